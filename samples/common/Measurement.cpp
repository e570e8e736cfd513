#include "common/Measurement.h"

#include "common/Median.h"
#include "common/OracleView.h"
#include "common/PlanCounts.h"
#include "common/ShadowWork.h"

namespace Lixel::Samples {

Measurement measureFrames(Stage& stage, int frames) {
    RenderClock clock(stage);
    ShadowWork work(clock);
    stage.drawFrame();

    std::vector<double> survey, fit, caster, receiver, frame;
    for (int i = 0; i < frames; ++i) {
        work.beginFrame();
        redrawShadowMaps();
        const double begin = clock.now();
        stage.drawFrame();
        const double total = clock.now() - begin;
        survey.push_back(work.survey);
        fit.push_back(work.fit);
        caster.push_back(work.caster);
        receiver.push_back(total - work.caster - 1e-3 * (work.survey + work.fit));
        frame.push_back(total);
    }
    // One to come to rest.
    stage.drawFrame();
    std::vector<double> still;
    PlanCounts plans;
    for (int i = 0; i < frames; ++i) {
        plans.clear();
        const double begin = clock.now();
        stage.drawFrame();
        still.push_back(clock.now() - begin);
    }
    Measurement result;
    result.stillFrameMilliseconds = median(still);
    result.mapsDrawn = plans.drawn;
    result.mapsDrawnMoving = plans.moving;
    result.mapsReused = plans.reused;
    result.mapsSkipped = plans.skipped;
    result.surveyMicroseconds = median(survey);
    result.fitMicroseconds = median(fit);
    result.casterMilliseconds = median(caster);
    result.receiverMilliseconds = median(receiver);
    result.frameMilliseconds = median(frame);
    result.reason = work.reason;
    return result;
}

ClassificationError measureError(Stage& stage, const ShadowOracle& oracle, double shadowDistance,
                                 std::vector<std::uint8_t>* visibility, ShadowTruth* truth) {
    std::vector<bool> isLit;
    const std::vector<std::uint8_t> drawn = stage.drawVisibility(&isLit);
    const Eigen::Vector3d& origin = oracle.scene().wsOrigin;
    ShadowTruth exact = oracle.classify(
        oracleView(stage.camera(), static_cast<int>(stage.window().getWidth()),
                   static_cast<int>(stage.window().getHeight()), shadowDistance, origin),
        oracleLight(stage.light(), origin));
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!isLit[i] && exact.pixels[i] != PixelClass::Background)
            exact.pixels[i] = PixelClass::Unlit;
    const ClassificationError error = compareWithTruth(exact, drawn);
    if (visibility != nullptr) *visibility = drawn;
    if (truth != nullptr) *truth = exact;
    return error;
}

} // namespace Lixel::Samples
