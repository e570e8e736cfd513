#pragma once

#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowPart.h"
#include "setup/MapPlan.h"

namespace Ogre {
class Camera;
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/// What was decided for one shadow map, right before its casters are drawn.
struct ShadowMap {
    Ogre::SceneManager& sceneManager;
    const Ogre::Camera& viewer;
    Ogre::Light& light;
    Ogre::Camera& shadowCamera;
    /// Which of the light's maps this is.
    std::size_t iteration;
    /// Which receivers this map serves: the points where its affine function, relative to the
    /// fit's origin, is greater than those of the light's other maps.
    const ShadowPart& part;
    /// The matrices, and why they are as they are. Without a map nothing is drawn, and all is lit.
    const ShadowFit& fit;
    /// What is done with its texture in this frame, and why.
    const MapDecision& decision;
    /// The fit's origin in the world.
    Vec3 wsOrigin;
    int width;
    int height;
    /// Receivers nearer than this to a caster along the light's axis stay lit, in world units.
    double depthBias;
    /// CPU time in microseconds: of the survey of what is seen, 0 where this map shares another's;
    /// of the search for this light's casters; and of the fit.
    double surveyMicroseconds;
    double casterMicroseconds;
    double fitMicroseconds;
};

/// What wants to know about shadow maps: materials' parameters, statistics.
class LIXEL_API ShadowMapObserver {
public:
    virtual ~ShadowMapObserver();
    /// A map was fitted. Called inside OGRE's preparation of shadow textures: draw nothing.
    virtual void shadowMapFitted(const ShadowMap& map) = 0;
};

/** Observers are called in the order in which they were added. Adding one twice has no effect.

    They may be added, removed and destroyed while they are told about a map: who is gone is not
    told any more, who is new is told from the next map on. */
LIXEL_API void addShadowMapObserver(ShadowMapObserver& observer);
LIXEL_API void removeShadowMapObserver(ShadowMapObserver& observer);
/// For those who make shadow maps: tells every observer.
LIXEL_API void publishShadowMap(const ShadowMap& map);

static_assert(HasOneLayout<ShadowMap>);

/// @}
} // namespace Lixel
