#pragma once

#include "fit/BodyHull.h"
#include "fit/SurfaceCloud.h"

#include <OgreAxisAlignedBox.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace Ogre {
class Entity;
class Mesh;
class MovableObject;
} // namespace Ogre

namespace Lixel {

/** The shapes of meshes, as few discs of their surface and as a convex hull: read once from their
    buffers, and kept.

    A mesh that is loaded anew is read anew. One whose buffers an application rewrites in place
    keeps its first shape, but has no hull once its bounds change.

    Null is what moves its vertices (skeletons, morphs, poses), and meshes without triangles that
    can be read. What is not null holds for as long as the mesh is there, and is not loaded anew.
*/
class LIXEL_API MeshShapes {
public:
    /// Discs of each cloud: a wall of a room has a dozen and more.
    static constexpr std::size_t Discs = 128;

    /// The surface of an entity, in its own space.
    const SurfaceCloud* cloudOf(const Ogre::Entity& entity);

    /** A hull of an entity, in its own space.
        @return null too where its vertices may go beyond it: with manual levels of detail, buffers
        that are not static, bounds that are given larger than the vertices have it, and vertex
        programs of others than Lixel and OGRE's shader generator, which may move them */
    const BodyHull* hullOf(const Ogre::Entity& entity);

private:
    struct Entry {
        std::weak_ptr<Ogre::Mesh> mesh;
        std::size_t state = 0; ///< how often the mesh had been loaded
        Ogre::AxisAlignedBox bounds;
        // Once they were asked for; empty where there is none.
        std::optional<SurfaceCloud> cloud;
        std::optional<BodyHull> hull;
    };

    Entry* find(const Ogre::Entity& entity);

    std::map<const Ogre::Mesh*, Entry> mEntries;
};

/// The hulls of a set's bodies, where these are entities that fill their world boxes badly.
class LIXEL_API ObjectShapes final : public BodyShapes {
public:
    /// @param meshes must outlive what follows
    void reset(MeshShapes& meshes, const Vec3& wsOrigin);
    /// Adds what the next box of the set is of; it must be there until the next reset.
    void add(const Ogre::MovableObject& object) { mObjects.push_back(&object); }

    const BodyHull* hullOf(std::size_t index, Eigen::Affine3d& wsFromBody) const noexcept override;

private:
    MeshShapes* mMeshes = nullptr;
    Vec3 mWsOrigin = Vec3::Zero();
    std::vector<const Ogre::MovableObject*> mObjects;
};

} // namespace Lixel
