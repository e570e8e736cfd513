#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace Ogre {
class SceneManager;
}

namespace Lixel::Samples {

/// One triangle of a TriangleScene, counter-clockwise seen from its front.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    bool casts = true;          ///< it is drawn into shadow maps
    bool receives = true;       ///< its material receives shadows
    bool drawnFromBack = false; ///< its material culls no side
};

/** The triangles of a scene as the renderer draws them.

    Positions are in world units, relative to `wsOrigin` (itself in world coordinates), so that a
    scene far from the world's origin loses no digits. Axes are the world's.
*/
struct TriangleScene {
    Eigen::Vector3d wsOrigin = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;

    /// Adds a triangle with three vertices of its own; `flags.vertices` is ignored.
    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             Triangle flags = {});

    /// Box of all vertices that a triangle uses, relative to wsOrigin; empty without triangles.
    Eigen::AlignedBox3d box() const;
};

/** The world-space triangles of everything solid that the scene manager would draw this frame.

    @param wsOrigin what positions are given relative to, in world coordinates

    Covers entities (and objects on their bones), manual objects and static geometry; vertex data
    shared or own, indexed by 16 or 32 bits or not at all; triangle lists, strips and fans. Node
    transforms are brought up to date first. A mirroring transform turns the front as OGRE does
    (SceneManager::getFlipCullingOnNegativeScale), and so does an anticlockwise culling mode.

    Objects count when they are visible and match the scene manager's visibility mask; a view's own
    mask, rendering distances and view-frustum culling do not count, since what a viewer does not
    see can still cast. `casts` is the object's getCastShadows, off where a transparent material
    says that it casts none. Entities contribute the level of detail and the pose they have now.

    Lines, points, instance batches, billboards and particles are left out.
    @exception Ogre::InvalidParametersException for positions that are not 3 or 4 floats, for an
    index beyond the vertices, and for hardware-skinned entities, whose pose only the GPU knows.
*/
TriangleScene collectTriangles(Ogre::SceneManager& sceneManager,
                               const Eigen::Vector3d& wsOrigin = Eigen::Vector3d::Zero());

} // namespace Lixel::Samples
