#pragma once

#include "BenchScene.h"

#include "scene/OgreVersions.h"
#include "setup/MapPlan.h"
#include "setup/ShadowMapObserver.h"

#include <OgreRenderTargetListener.h>

#include <chrono>

namespace Lixel::Tests {

/// What one frame took, in microseconds of wall clock, and what was done with its last map.
struct BenchTimes {
    double frame = 0;
    double survey = 0;
    double casters = 0;
    double fit = 0;
    double find = 0;
    double findMap = 0;
    double untilMap = 0; ///< until the last map was begun: its survey, casters, fit and plan
    double map = 0;
    double mapCalls = 0; ///< the same, until the last call was made
    MapPlan plan = MapPlan::Skip;
};

/// Times a scene's frames and their parts.
class BenchWatch : private SceneManagerListener,
                   private ShadowMapObserver,
                   private Ogre::RenderTargetListener {
public:
    explicit BenchWatch(BenchScene& scene);
    BenchWatch(const BenchWatch&) = delete;
    BenchWatch& operator=(const BenchWatch&) = delete;
    ~BenchWatch() override;

    /// Whether to wait for what is drawn, before the map and the frame, and after them.
    void setFinishing(bool finishes) { mFinishes = finishes; }
    void begin();
    BenchTimes end();

private:
    using Clock = std::chrono::steady_clock;

    void preFindVisibleObjects(Ogre::SceneManager* manager,
                               Ogre::SceneManager::IlluminationRenderStage stage,
                               Ogre::Viewport* viewport) override;
    void postFindVisibleObjects(Ogre::SceneManager* manager,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport* viewport) override;
    void shadowMapFitted(const ShadowMap& map) override;
    void preRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override;
    void postRenderTargetUpdate(const Ogre::RenderTargetEvent& event) override;
    void finishIfAsked() const;

    BenchScene& mScene;
    Ogre::TexturePtr mMap;
    bool mFinishes = false;
    BenchTimes mTimes;
    Clock::time_point mFrameBegin;
    Clock::time_point mFindBegin;
    Clock::time_point mMapBegin;
};

} // namespace Lixel::Tests
