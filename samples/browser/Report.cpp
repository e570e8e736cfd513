#include "browser/Report.h"

#include "common/PictureFile.h"

#include <Lixel/material/OnDemandPrograms.h>
#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/VisiblePointFeedback.h>

#include <OgreGpuProgram.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace Lixel::Samples {
namespace {

struct Programs {
    std::size_t known = 0; ///< that scripts have, and that OGRE's shader system has made
    std::size_t compiled = 0;
    std::size_t used = 0; ///< loaded: those of all materials that something wears
};

Programs countPrograms() {
    Programs programs;
    for (const auto& [handle, program] : programManager().getResourceIterator()) {
        ++programs.known;
        programs.compiled += isCompiled(static_cast<const Ogre::GpuProgram&>(*program)) ? 1 : 0;
        programs.used += program->isLoaded() ? 1 : 0;
    }
    return programs;
}

} // namespace

void drawHeadless(Stage& stage, const SampleScene& scene, const BrowserOptions& options) {
    if (options.proof) setProofMode(true, [&stage] { stage.finish(); });
    Measurement measured = measureFrames(stage, options.frames);
    const std::vector<std::uint8_t> picture = stage.picture();
    const Programs programs = countPrograms();

    const ShadowOracle oracle(collectTriangles(stage.sceneManager()));
    std::vector<std::uint8_t> visibility;
    ShadowTruth truth;
    measured.error = measureError(stage, oracle, scene.shadowDistance, &visibility, &truth);

    if (options.proof) {
        const ProofCount proof = proofCount();
        fmt::print(
            "proof: {} maps that could be kept and {} in layers were drawn anew and compared, "
            "{} were different\n",
            proof.maps, proof.layered, proof.different);
    }
    const std::string setup = options.setup.empty() ? stage.preset() : options.setup;
    if (!options.output.empty())
        savePicture(picture, options.width, options.height, options.output);
    if (!options.comparison.empty())
        savePicture(paintComparison(truth, visibility), options.width, options.height,
                    options.comparison);
    if (!options.stats.empty()) {
        const nlohmann::ordered_json stats{
            {"sample", scene.name},
            {"setup", setup},
            {"map", options.mapSize},
            {"width", options.width},
            {"height", options.height},
            {"view", options.view},
            {"frames", options.frames},
            {"error_percent", measured.error.error},
            {"acne_percent", measured.error.acne},
            {"leak_percent", measured.error.leak},
            {"grazing_error_percent", measured.error.grazingError},
            {"pixels_counted", measured.error.counted()},
            {"pixels_shadowed", measured.error.shadowed},
            {"survey_us", measured.surveyMicroseconds},
            {"fit_us", measured.fitMicroseconds},
            {"caster_ms", measured.casterMilliseconds},
            {"receiver_ms", measured.receiverMilliseconds},
            {"frame_ms", measured.frameMilliseconds},
            {"still_frame_ms", measured.stillFrameMilliseconds},
            {"maps_drawn", measured.mapsDrawn},
            {"maps_drawn_moving", measured.mapsDrawnMoving},
            {"maps_reused", measured.mapsReused},
            {"maps_skipped", measured.mapsSkipped},
            {"reason", measured.reason},
            {"feedback", toString(feedbackStatistics(stage.camera()).state)},
            {"programs", programs.known},
            {"programs_compiled", programs.compiled},
            {"programs_used", programs.used},
            {"gl_renderer", stage.glRenderer()},
        };
        std::ofstream file(options.stats);
        file << stats.dump(2) << '\n';
        if (!file.flush())
            throw std::runtime_error("the statistics '" + options.stats + "' could not be written");
    }
    fmt::print("{:<12} {:<18} map {:>4}  error {:6.3f} % (acne {:.3f}, leak {:.3f})  "
               "frame {:.1f} ms{}\n",
               scene.name, setup, options.mapSize, measured.error.error, measured.error.acne,
               measured.error.leak, measured.frameMilliseconds,
               options.output.empty() ? "" : "  " + options.output);
}

} // namespace Lixel::Samples
