#include "CaseRun.h"

#include "ChildProcess.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/ShadowCameraSetups.h>
#include <Lixel/setup/ShadowPass.h>

#include <fmt/core.h>

#include <algorithm>

namespace Lixel::Tests {
namespace {

/// Seconds; a case takes a tenth of one.
constexpr unsigned TimeLimit = 20;

/// Texels between points on one light ray: Lixel's contract, and what makes OGRE's shadows wrong.
constexpr double LixelsApart = 0.25;
constexpr double OgresApart = 1.0;

/// A result as it goes through a pipe.
struct Message {
    bool ok;
    std::array<char, 200> text;
    Losses losses;
};

CaseResult judgeFrame(HardScene& scene, const std::vector<ProbedMap>& maps, const MapUse& use) {
    CaseResult result;
    const bool anyMap = std::any_of(maps.begin(), maps.end(),
                                    [](const ProbedMap& map) { return hasMap(map.reason); });
    if (anyMap) {
        result.losses = judge(scene, maps, use);
        result.ok = result.losses.none();
        result.text = describe(result.losses);
        return result;
    }
    result.losses.shadowed = countShadowed(scene);
    // Without a map everything is lit, which is right where nothing is in shadow.
    const bool nothingIsLost =
        result.losses.shadowed == 0 && (maps.empty() || maps.front().reason < FitReason::Unbounded);
    result.ok = nothingIsLost;
    result.text = nothingIsLost
                      ? "ok"
                      : fmt::format("no map: {}", maps.empty() ? "none asked for"
                                                               : toString(maps.front().reason));
    return result;
}

} // namespace

const std::vector<Samples::NamedSetup>& judgedSetups() {
    static const std::vector<Samples::NamedSetup> setups = [] {
        std::vector<Samples::NamedSetup> all = Samples::shadowSetups();
        Samples::NamedSetup literal;
        literal.name = "XPSM-Literal";
        literal.title = "Lixel: extended perspective shadow map, as the paper has it";
        literal.create = [] { return XPSMShadowCameraSetup::create({.guarded = false}); };
        all.insert(all.begin() + 2, literal);
        Samples::NamedSetup exact;
        exact.name = "PlaneOptimal-Exact";
        exact.title = "Lixel: exactly the viewer's picture of the ground plane";
        exact.create = [] { return PlaneOptimalShadowCameraSetup::create({.exact = true}); };
        for (const char* const name : {"Stable", "Cascades-3", "Stable-Cascades-3", "Cube"}) {
            all.insert(std::find_if_not(all.begin(), all.end(), isLixels),
                       *Samples::findEmulatedSetup(name));
        }
        const auto ogres = std::find_if_not(all.begin(), all.end(), isLixels);
        all.insert(ogres, exact);
        return all;
    }();
    return setups;
}

bool isLixels(const Samples::NamedSetup& setup) {
    return !setup.name.starts_with("Ogre");
}

void buildCase(HardScene& scene, const HardCase& hardCase) {
    hardCase.build(scene);
    if (scene.mapWidth != 1024 || scene.mapHeight != 1024)
        scene.manager().setShadowTextureConfig(0, static_cast<unsigned short>(scene.mapWidth),
                                               static_cast<unsigned short>(scene.mapHeight),
                                               Ogre::PF_FLOAT32_R);
}

void drawCase(HardScene& scene, const HardCase& hardCase, const std::function<void()>& judged) {
    for (int frame = 0; frame < hardCase.settle; ++frame) {
        if (hardCase.eachFrame) hardCase.eachFrame(scene, frame);
        scene.stage.drawFrame();
    }
    if (hardCase.change) hardCase.change(scene);
    if (hardCase.eachFrame) hardCase.eachFrame(scene, hardCase.settle);
    judged();
    scene.stage.drawFrame();
    if (!hardCase.repair) return;
    hardCase.repair(scene);
    judged();
    scene.stage.drawFrame();
}

CaseResult runCase(Samples::Stage& stage, const HardCase& hardCase,
                   const Samples::NamedSetup& setup) {
    const bool lixels = isLixels(setup);
    stage.setShadowSetup(setup.create());
    HardScene scene(stage);
    buildCase(scene, hardCase);
    const std::size_t maps = lixels ? std::max(setup.maps, hardCase.maps) : 1;
    if (maps > 1) scene.shareAmong(maps);
    MapProbe probe(scene, lixels);
    MapUse use;
    // Lixel's setups clamp where the render system can.
    use.clampsDepth = (lixels || ogreClampsDepth(*scene.light)) && canClampDepth();
    use.greatestApart = lixels ? LixelsApart : OgresApart;
    drawCase(scene, hardCase, [&] { probe.maps.clear(); });
    return judgeFrame(scene, probe.maps, use);
}

std::vector<CaseResult> runCaseApart(Samples::Stage& stage, const HardCase& hardCase,
                                     const std::vector<const Samples::NamedSetup*>& setups) {
    Message message{};
    std::vector<CaseResult> results;
    // A child goes on to the next setup, until one ends it.
    while (results.size() < setups.size()) {
        const std::size_t first = results.size();
        const auto work = [&](std::size_t step) {
            if (step > 0) stage.clear();
            const CaseResult result = runCase(stage, hardCase, *setups[first + step]);
            message = Message{result.ok, {}, result.losses};
            result.text.copy(message.text.data(), message.text.size() - 1);
        };
        const std::string failure =
            runApart(TimeLimit, setups.size() - first, work,
                     std::as_writable_bytes(std::span(&message, 1)), [&](std::size_t) {
                         results.push_back({message.ok, message.text.data(), message.losses});
                     });
        if (!failure.empty()) results.push_back({false, failure, {}});
    }
    return results;
}

} // namespace Lixel::Tests
