#pragma once

#include "common/Stage.h"

#include <Lixel/setup/ShadowMapObserver.h>

#include <OgreRenderTargetListener.h>

#include <ctime>

namespace Lixel::Samples {

/** Milliseconds on the clock that fits the renderer, after all drawing is done.

    On a software renderer that is the process' CPU time, which counts the renderer's threads too; on
    a GPU the wall clock.
*/
class RenderClock {
public:
    explicit RenderClock(Stage& stage);
    double now();

private:
    Stage& mStage;
    clockid_t mClock;
};

/// Adds up one frame's shadow work: what setups publish, and the drawing of shadow textures.
class ShadowWork : public ShadowMapObserver, public Ogre::RenderTargetListener {
public:
    explicit ShadowWork(RenderClock& clock);
    ~ShadowWork() override;
    ShadowWork(const ShadowWork&) = delete;
    ShadowWork& operator=(const ShadowWork&) = delete;

    void beginFrame() { survey = fit = caster = 0.0; }
    /// To be called before shadow textures go.
    void leaveTargets();

    void shadowMapFitted(const ShadowMap& map) override;
    void preRenderTargetUpdate(const Ogre::RenderTargetEvent&) override { mBegin = mClock.now(); }
    void postRenderTargetUpdate(const Ogre::RenderTargetEvent&) override {
        caster += mClock.now() - mBegin;
    }

    double survey = 0.0; ///< microseconds, the search for casters included
    double fit = 0.0;    ///< microseconds
    double caster = 0.0; ///< milliseconds
    std::string reason = "none";

private:
    RenderClock& mClock;
    double mBegin = 0.0;
    std::vector<Ogre::RenderTarget*> mTargets;
};

} // namespace Lixel::Samples
