#pragma once

#include <Ogre.h>

#include <array>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// The material that an entity or an instance wears; empty for other objects.
Ogre::String materialOf(const Ogre::MovableObject& object);

/// What a ray meets: the first of these that is on its way.
enum class Meeting {
    Picture, ///< where it is whole
    Edge,    ///< of a hole, or near one
    Hole,
    Nothing
};

/// Meshes of MeshBuilder's whose triangles show one picture with holes, to trace rays through.
class PictureCasters {
public:
    /// @param picture a file in the resource group of media
    explicit PictureCasters(const std::string& picture);

    /// Adds an entity, or an instance.
    void add(const Ogre::MovableObject& object);

    Meeting meet(const Ogre::Ray& ray) const;

private:
    struct Corner {
        Ogre::Vector3 ws;
        Ogre::Vector2 uv;
    };
    /// Whether the picture is whole around a place, has a hole there, or an edge.
    Meeting around(const Ogre::Vector2& uv) const;

    Ogre::Image mPicture;
    std::vector<std::array<Corner, 3>> mTriangles;
};

} // namespace Lixel::Samples
