#include "common/Measurement.h"

#include "common/PlanCounts.h"

#include "common/Median.h"
#include "common/OracleView.h"

#include <algorithm>
#include <ctime>

namespace Lixel::Samples {
namespace {

/// Milliseconds on the clock that fits the renderer, after all drawing is done.
class Clock {
public:
    explicit Clock(Stage& stage)
        : mStage(stage),
          mClock(stage.glRenderer().find("llvmpipe") != std::string::npos ||
                         stage.glRenderer().find("softpipe") != std::string::npos
                     ? CLOCK_PROCESS_CPUTIME_ID
                     : CLOCK_MONOTONIC) {}

    double now() {
        mStage.finish();
        timespec time{};
        clock_gettime(mClock, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }

private:
    Stage& mStage;
    clockid_t mClock;
};

/// Adds up one frame's shadow work: what setups publish, and the drawing of shadow textures.
class ShadowWork : public ShadowMapObserver, public Ogre::RenderTargetListener {
public:
    explicit ShadowWork(Clock& clock) : mClock(clock) { addShadowMapObserver(*this); }
    ~ShadowWork() override {
        for (Ogre::RenderTarget* target : mTargets)
            target->removeListener(this);
    }

    void beginFrame() { survey = fit = caster = 0.0; }

    void shadowMapFitted(const ShadowMap& map) override {
        survey += map.surveyMicroseconds + map.casterMicroseconds;
        fit += map.fitMicroseconds;
        reason = toString(map.fit.reason);
        Ogre::RenderTarget* const target = map.shadowCamera.getViewport()->getTarget();
        if (std::find(mTargets.begin(), mTargets.end(), target) == mTargets.end()) {
            mTargets.push_back(target);
            target->addListener(this);
        }
    }
    void preRenderTargetUpdate(const Ogre::RenderTargetEvent&) override { mBegin = mClock.now(); }
    void postRenderTargetUpdate(const Ogre::RenderTargetEvent&) override {
        caster += mClock.now() - mBegin;
    }

    double survey = 0.0;
    double fit = 0.0;
    double caster = 0.0;
    std::string reason = "none";

private:
    Clock& mClock;
    double mBegin = 0.0;
    std::vector<Ogre::RenderTarget*> mTargets;
};

} // namespace

Measurement measureFrames(Stage& stage, int frames) {
    Clock clock(stage);
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
