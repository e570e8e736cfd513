#pragma once

#include "common/AlphaMask.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace Ogre {
class SceneManager;
}

namespace Lixel::Samples {

/// Triangle::mask of a triangle without holes.
constexpr std::uint32_t NoMask = std::numeric_limits<std::uint32_t>::max();

/// One triangle of a TriangleScene, counter-clockwise seen from its front.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    bool casts = true;           ///< it is drawn into shadow maps
    bool receives = true;        ///< its material receives shadows
    bool drawnFromBack = false;  ///< its material culls no side
    std::uint32_t mask = NoMask; ///< index into TriangleScene::masks
};

/** The triangles of a scene as the renderer draws them.

    Positions are in world units, relative to `wsOrigin` (itself in world coordinates), so that a
    scene far from the world's origin loses no digits. Axes are the world's. Neither light nor sight
    is stopped by a triangle where its mask has a hole; most scenes have no masks.
*/
struct TriangleScene {
    Eigen::Vector3d wsOrigin = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;
    std::vector<AlphaMask> masks;
    /// Texture coordinates of each vertex, as far as triangles with a mask use them.
    std::vector<Eigen::Vector2f> uvs;

    /// Adds a triangle with three vertices of its own; `flags.vertices` is ignored, and texture
    /// coordinates are left to the caller.
    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             Triangle flags = {});

    /// Box of all vertices that a triangle uses, relative to wsOrigin; empty without triangles.
    Eigen::AlignedBox3d box() const;
};

/** The world-space triangles of everything solid that the scene manager would draw this frame.

    @param wsOrigin what positions are given relative to, in world coordinates

    Covers entities (and objects on their bones), manual objects, static geometry and the instances
    of instance managers; vertex data shared or own, indexed by 16 or 32 bits or not at all;
    triangle lists, strips and fans. Node transforms are brought up to date first. A mirroring
    transform turns the front as OGRE does (SceneManager::getFlipCullingOnNegativeScale), and so
    does an anticlockwise culling mode.

    Objects count when they are visible and match the scene manager's visibility mask; a view's own
    mask, rendering distances and view-frustum culling do not count, since what a viewer does not
    see can still cast. `casts` is the object's getCastShadows (of instances their batch's), off
    where a transparent material says that it casts none. Entities contribute the level of detail
    and the pose they have now, whether OGRE blends it or a GPU does. Instances of static batches
    are where they are now: call InstanceBatch::setStaticAndUpdate before, as for drawing.

    Holes are those of findHoles, cut by the alpha of a material's texture.

    Lines, points, billboards and particles are left out, and vertices that a program moves by
    itself are where the buffers have them.
    @exception Ogre::InvalidParametersException for positions that are not 3 or 4 floats, for an
    index beyond the vertices, for poses that only the GPU knows, which are those of pose animation
    in hardware and of instances with bones, and as findHoles
*/
TriangleScene collectTriangles(Ogre::SceneManager& sceneManager,
                               const Eigen::Vector3d& wsOrigin = Eigen::Vector3d::Zero());

} // namespace Lixel::Samples
