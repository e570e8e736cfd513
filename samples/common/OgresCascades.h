#pragma once

#include "common/Stage.h"

namespace Lixel::Samples {

/** While it lives, a stage's scene of OGRE's shader system has OGRE's own shadows: three parallel
    splits in depth textures, as OGRE's sample of that system sets them up, with OGRE's casters.

    Made for the camera as it is: the splits follow from its near distance and the shadow distance.
    The stage goes on with the light's preset.
*/
class OgresCascades {
public:
    /// @param mapSize texels of each map's side
    OgresCascades(Stage& stage, int mapSize);
    ~OgresCascades();
    OgresCascades(const OgresCascades&) = delete;
    OgresCascades& operator=(const OgresCascades&) = delete;

private:
    Stage& mStage;
    int mMapSize;
};

} // namespace Lixel::Samples
