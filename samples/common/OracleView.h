#pragma once

#include "common/ShadowOracle.h"

namespace Ogre {
class Camera;
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel::Samples {

/** What an OGRE camera sees, for the oracle.

    The view matrix is made in double from the camera's derived position and orientation, relative
    to `wsOrigin`; that equals what OGRE draws with camera-relative rendering at any distance from
    the origin, and without it near the origin. A custom view or projection matrix is respected;
    reflections are not.
    @param shadowDistance largest view-space depth with shadows, world units; 0: any
*/
OracleView oracleView(const Ogre::Camera& camera, int width, int height, double shadowDistance,
                      const Eigen::Vector3d& wsOrigin = Eigen::Vector3d::Zero());

/** An OGRE light, for the oracle: its derived position and direction, cone and attenuation range.

    @exception Ogre::InvalidParametersException for a rectangular light
*/
OracleLight oracleLight(const Ogre::Light& light,
                        const Eigen::Vector3d& wsOrigin = Eigen::Vector3d::Zero());

/// Which sides of casters a scene manager draws into shadow maps.
CasterFaces casterFaces(const Ogre::SceneManager& sceneManager);

} // namespace Lixel::Samples
