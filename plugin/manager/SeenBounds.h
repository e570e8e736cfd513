#pragma once

#include <OgreCamera.h>
#include <OgreSceneManager.h>
#include <OgreSphere.h>

#include <algorithm>
#include <cmath>

namespace Lixel {

/** Ogre::VisibleObjectsBoundsInfo of many objects, for one camera: the same values to the last bit,
    without asking the camera for each. */
class SeenBounds {
public:
    explicit SeenBounds(const Ogre::Camera& camera) : mView(camera.getViewMatrix(true)) {}

    void merge(const Ogre::AxisAlignedBox& box, const Ogre::Sphere& sphere, bool receives) {
        mSeen.add(box);
        if (receives) mReceiving.add(box);
        addDistance(sphere, mDrawn);
    }
    /// An object that receives, but is not drawn because it does not cast.
    void mergeNotDrawn(const Ogre::Sphere& sphere) { addDistance(sphere, mNotDrawn); }

    void addTo(Ogre::VisibleObjectsBoundsInfo& bounds) const {
        mSeen.addTo(bounds.aabb);
        mReceiving.addTo(bounds.receiverAabb);
        bounds.minDistance = std::min(bounds.minDistance, mDrawn.nearest);
        bounds.maxDistance = std::max(bounds.maxDistance, mDrawn.farthest);
        for (const Distances* distances : {&mDrawn, &mNotDrawn}) {
            bounds.minDistanceInFrustum = std::min(bounds.minDistanceInFrustum, distances->nearest);
            bounds.maxDistanceInFrustum =
                std::max(bounds.maxDistanceInFrustum, distances->farthest);
        }
    }

private:
    struct Distances {
        Ogre::Real nearest = std::numeric_limits<Ogre::Real>::infinity();
        Ogre::Real farthest = 0;
    };
    struct Ends {
        Ogre::Vector3 lower = Ogre::Vector3(std::numeric_limits<Ogre::Real>::infinity());
        Ogre::Vector3 upper = -lower;
        bool infinite = false;

        void add(const Ogre::AxisAlignedBox& box) {
            if (box.isFinite()) {
                lower.makeFloor(box.getMinimum());
                upper.makeCeil(box.getMaximum());
            }
            infinite = infinite || box.isInfinite();
        }
        void addTo(Ogre::AxisAlignedBox& box) const {
            if (infinite)
                box.setInfinite();
            else if (lower.x <= upper.x)
                box.merge(Ogre::AxisAlignedBox(lower, upper));
        }
    };

    void addDistance(const Ogre::Sphere& sphere, Distances& distances) const {
        const Ogre::Real distance = (mView * sphere.getCenter()).length();
        distances.nearest =
            std::min(distances.nearest, std::max(Ogre::Real(0), distance - sphere.getRadius()));
        distances.farthest = std::max(distances.farthest, distance + sphere.getRadius());
    }

    Ogre::Affine3 mView;
    Ends mSeen;
    Ends mReceiving;
    Distances mDrawn;
    Distances mNotDrawn;
};

} // namespace Lixel
