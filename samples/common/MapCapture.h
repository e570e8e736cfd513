#pragma once

#include "common/MapEmulation.h"
#include "common/Setups.h"
#include "common/Stage.h"

#include <Lixel/setup/ShadowMapObserver.h>

namespace Lixel::Samples {

/** Shadow maps' matrices, as OGRE would draw with them, without drawing anything.

    While one lives, the stage's frames find what is visible and set shadow cameras up, but draw
    nothing. Afterwards every light has one map again, of the size that was captured last. The
    light keeps the setup that was captured last.
*/
class MapCapture : private ShadowMapObserver {
public:
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

private:
    void shadowMapFitted(const ShadowMap& map) override;
    void setMaps(int mapSize, std::size_t count);

    Stage& mStage;
    int mMapSize = 0;
    std::size_t mMapCount = 0;
    bool mClampsDepth = false;
    Eigen::Vector3d mOrigin = Eigen::Vector3d::Zero();
    std::vector<EmulatedMap> mMaps;
    FitReason mReason = FitReason::None;
};

} // namespace Lixel::Samples
