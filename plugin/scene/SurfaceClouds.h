#pragma once

#include "fit/SurfaceCloud.h"

#include <map>
#include <memory>

namespace Ogre {
class Entity;
class Mesh;
} // namespace Ogre

namespace Lixel {

/** The surfaces of meshes as few discs: read once from their buffers, and kept.

    A mesh that is loaded anew is read anew. One whose buffers an application rewrites in place
   keeps the discs of its first shape.
*/
class LIXEL_API SurfaceClouds {
public:
    /// Discs of each cloud: a wall of a room has a dozen and more.
    static constexpr std::size_t Discs = 128;

    /** The surface of an entity, in its own space.
        @return null for what moves its vertices (skeletons, morphs, poses), and for meshes without
        triangles that can be read. It holds for as long as the mesh is there, and is not
        loaded anew. */
    const SurfaceCloud* of(const Ogre::Entity& entity);

private:
    struct Entry {
        std::weak_ptr<Ogre::Mesh> mesh;
        std::size_t state = 0; ///< how often the mesh had been loaded
        SurfaceCloud cloud;
    };

    std::map<const Ogre::Mesh*, Entry> mEntries;
};

} // namespace Lixel
