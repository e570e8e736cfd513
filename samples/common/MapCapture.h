#pragma once

#include "common/MapEmulation.h"
#include "common/Setups.h"
#include "common/ShadowWork.h"
#include "common/Stage.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/ShadowMapObserver.h>

#include <OgreSceneManager.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace Lixel::Samples {

/// The shadow maps of one frame.
struct CapturedFrame {
    std::vector<EmulatedMap> maps;
    std::size_t mapsDrawn = 0; ///< not kept, and not skipped
    // What it cost.
    double surveyMicroseconds = 0.0; ///< the search for casters included
    double fitMicroseconds = 0.0;
    double casterMilliseconds = 0.0; ///< of drawing maps, on RenderClock, where they are drawn
};

/** Shadow maps' matrices, as OGRE would draw with them.

    While one lives, the stage's frames find what is visible and set shadow cameras up, but draw
    nothing, or maps alone or all of it where that is asked for. Afterwards every light has one map
    again, of the size that was captured last. The light keeps the setup that was captured last.
*/
class MapCapture : private ShadowMapObserver, private SceneManagerListener {
public:
    enum class Draws { Nothing, Maps, Everything };
    explicit MapCapture(Stage& stage);
    ~MapCapture() override;
    MapCapture(const MapCapture&) = delete;
    MapCapture& operator=(const MapCapture&) = delete;

    /** The maps that a new instance of a setup gives the stage's light for its camera.

        OGRE's setups use what was visible in the frame before, so they get as many frames as it
        takes until that no longer changes.
        @param mapSize side of the map in texels; several maps share as many texels
        @param shadowDistance view-space depth that shadows reach, for setups that split the view;
        0: any
        @param wsOrigin what the emulation's positions are relative to, in world coordinates
    */
    std::vector<EmulatedMap> capture(const NamedSetup& setup, int mapSize, double shadowDistance,
                                     const Eigen::Vector3d& wsOrigin);

    /// What kept the fits of the last capture from their ideal, such as "warp clamped"; of several
    /// maps the first that says something, "none" where none does.
    std::string reason() const { return toString(mReason); }

    /// Gives the stage's light a new instance of a setup, for the frames that follow, and lets it
    /// settle for the camera as it is. Parameters as of capture.
    void begin(const NamedSetup& setup, int mapSize, double shadowDistance,
               const Eigen::Vector3d& wsOrigin);
    /// The next frame of what was begun, for the camera as it is now.
    CapturedFrame nextFrame(Draws draws = Draws::Nothing);
    /// The same, all of it drawn: how much of the light each pixel gets, as Stage::drawVisibility.
    std::vector<std::uint8_t> nextVisibility();

private:
    /// @param draw draws a frame of the stage's
    CapturedFrame takeFrame(Draws draws, const std::function<void()>& draw);
    void shadowMapFitted(const ShadowMap& map) override;
    void shadowTexturesUpdated(std::size_t) override {
        if (mDraws != Draws::Everything) setDrawing(false);
    }
    void setDrawing(bool on);
    void setMaps(int mapSize, std::size_t count);

    Stage& mStage;
    Draws mDraws = Draws::Nothing;
    RenderClock mClock;
    ShadowWork mWork;
    int mMapSize = 0;
    std::size_t mMapCount = 0;

    // What was begun.
    NamedSetup mSetup;
    bool mClampsDepth = false;
    double mShadowDistance = 0.0;
    Eigen::Vector3d mOrigin = Eigen::Vector3d::Zero();
    FitReason mReason = FitReason::None;

    CapturedFrame mFrame;
};

} // namespace Lixel::Samples
