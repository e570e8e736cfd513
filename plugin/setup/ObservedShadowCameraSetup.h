#pragma once

#include "fit/geometry/Types.h"

// OgreShadowCameraSetup.h of 1.12 needs it and does not include it.
#include <OgreSharedPtr.h>

#include <OgreShadowCameraSetup.h>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Wraps any other shadow camera setup so that Lixel's materials and statistics work with it.

    The shadow camera is exactly as the wrapped setup leaves it; its matrices are then published
    like those of a fit. This is how OGRE's own setups are compared with Lixel's in one scene, with
    the same materials. OGRE's Focused, LiSPSM and PSSM setups crash where they outlive Root, and so
    they do in here.
*/
class LIXEL_API ObservedShadowCameraSetup : public Ogre::ShadowCameraSetup {
public:
    /// @throws Ogre::InvalidParametersException where `inner` is null.
    static std::shared_ptr<ObservedShadowCameraSetup>
    create(const Ogre::ShadowCameraSetupPtr& inner, Ogre::Real depthBias = 0);
    /// Use create(). @param depthBias in world units, as FittedShadowCameraSetup::setDepthBias.
    ObservedShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& inner, Ogre::Real depthBias);

    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override;

private:
    Ogre::ShadowCameraSetupPtr mInner;
    Ogre::Real mDepthBias;
};

/// @}
} // namespace Lixel
