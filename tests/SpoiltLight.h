#pragma once

#include <Lixel/scene/OgreVersions.h>

#include <OgreLight.h>

#include <limits>

namespace Lixel::Tests {

/** Gives a light a NaN that OGRE must not draw its shadows with, and takes it back.

    It is the light's direction where lights have one of their own. Elsewhere it is how far its
    shadows reach: a node's direction cannot be a NaN, because OGRE itself asserts that the bounds
    of what is attached to it are a box, whether anything casts shadows or not.
*/
class SpoiltLight {
public:
    /// Changes nothing yet.
    explicit SpoiltLight(Ogre::Light& light)
        : mLight(light), mDirection(ownDirection(light)), mDistance(light.getShadowFarDistance()) {}

    void spoil() {
        constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
        if (LightsHaveDirections)
            setOwnDirection(mLight, Ogre::Vector3(NaN, NaN, NaN));
        else
            mLight.setShadowFarDistance(NaN);
    }

    /// Puts back what was there at first.
    void mend() {
        if (LightsHaveDirections)
            setOwnDirection(mLight, mDirection);
        else
            mLight.setShadowFarDistance(mDistance);
    }

private:
    Ogre::Light& mLight;
    Ogre::Vector3 mDirection;
    Ogre::Real mDistance;
};

} // namespace Lixel::Tests
