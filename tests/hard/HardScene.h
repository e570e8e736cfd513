#pragma once

#include "common/Stage.h"

#include <string>

namespace Lixel::Tests {

/** A small scene in which a case can be told in a few lines.

    Lengths and positions are told in units, relative to `origin`: both can be changed before
    anything is placed, so that the same scene stands far away, or is tiny. Starts as a viewer at
    (0, 8, 16) who looks at the origin with planes at 0.1 and 1000, shadows that reach 100, and
    a sun from the right; nothing is in the scene.
*/
class HardScene {
public:
    explicit HardScene(Samples::Stage& stage);

    Samples::Stage& stage;
    float unit = 1.0F;                          ///< world units
    Ogre::Vector3 origin = Ogre::Vector3::ZERO; ///< world units
    Ogre::Light* light;                         ///< the one whose map is judged
    int mapWidth = 1024;                        ///< texels
    int mapHeight = 1024;                       ///< texels

    Ogre::SceneManager& manager() { return stage.sceneManager(); }
    Ogre::Camera& viewer() { return *stage.viewport().getCamera(); }
    Ogre::Vector3 toWorld(const Ogre::Vector3& units) const { return origin + unit * units; }

    /// A box by its centre; a negative size mirrors it.
    Ogre::SceneNode* addBox(const Ogre::Vector3& centre, const Ogre::Vector3& size,
                            bool casts = true, bool receives = true);
    /// Tiles with their upper side at y = 0 that receive and do not cast.
    void addGround(float halfSide = 100.0F, int tiles = 8);
    /// Ground, and all around the origin 7 x 7 boxes from 1 to 4 high, each with a roof over it.
    void addField();

    void look(const Ogre::Vector3& eye, const Ogre::Vector3& target);
    void setPlanes(float near, float far);
    void setReach(float distance);
    /// Gives each light several maps of one size, which OGRE draws under integrated techniques.
    void shareAmong(std::size_t maps);
    void sun(const Ogre::Vector3& direction);
    /// The same to the last bit, which a node's rotation would not be.
    void sunExactly(const Ogre::Vector3& direction);
    /// A sun that stands `elevation` degrees high over `azimuth`: 0 over +z, 90 over +x.
    void sunAt(float azimuth, float elevation);
    void spot(const Ogre::Vector3& position, const Ogre::Vector3& target, float outerDegrees);
    /// The light's own direction, unchecked: nodes refuse what is not finite.
    Ogre::Vector3 ownDirection() const;
    void setOwnDirection(const Ogre::Vector3& direction);

private:
    int mBoxes = 0;
};

} // namespace Lixel::Tests
