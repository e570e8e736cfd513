#include "scene/SurfaceClouds.h"

#include "scene/Geometry.h"

#include <OgreEntity.h>
#include <OgreException.h>
#include <OgreMesh.h>
#include <OgreSubMesh.h>

#include <algorithm>

namespace Lixel {
namespace {

/// All triangles of a mesh, in its own space.
SurfaceCloud read(Ogre::Mesh& mesh) {
    std::vector<Vec3> positions;
    std::vector<TriangleCorners> triangles;
    for (Ogre::SubMesh* part : mesh.getSubMeshes()) {
        Ogre::RenderOperation operation;
        part->_getRenderOperation(operation);
        if (operation.vertexData == nullptr || operation.vertexData->vertexCount == 0) continue;
        const auto first = static_cast<std::uint32_t>(positions.size());
        const std::vector<Vec3> own = readPositions(*operation.vertexData);
        positions.insert(positions.end(), own.begin(), own.end());
        for (TriangleCorners triangle : readTriangles(operation)) {
            // An index beyond the vertices must not become another part's vertex.
            if (std::ranges::any_of(triangle, [&](auto index) { return index >= own.size(); }))
                continue;
            for (std::uint32_t& index : triangle)
                index += first;
            triangles.push_back(triangle);
        }
    }
    return makeSurfaceCloud(positions, triangles, SurfaceClouds::Discs);
}

const SurfaceCloud* cloudOf(const SurfaceCloud& cloud) {
    return cloud.surfels.empty() ? nullptr : &cloud;
}

} // namespace

const SurfaceCloud* SurfaceClouds::of(const Ogre::Entity& entity) {
    if (entity.hasSkeleton() || entity.hasVertexAnimation()) return nullptr;
    const Ogre::MeshPtr& mesh = entity.getMesh();
    const auto found = mEntries.find(mesh.get());
    // Another mesh may have come to be at the address of one that has gone.
    if (found != mEntries.end() && !found->second.mesh.expired() &&
        found->second.state == mesh->getStateCount())
        return cloudOf(found->second.cloud);

    std::erase_if(mEntries, [](const auto& entry) { return entry.second.mesh.expired(); });
    Entry entry{mesh, mesh->getStateCount(), {}};
    try {
        entry.cloud = read(*mesh);
    } catch (const Ogre::Exception&) {
        // Positions that are not floats: the box has to do. OGRE has logged the exception.
    }
    return cloudOf(mEntries.insert_or_assign(mesh.get(), std::move(entry)).first->second.cloud);
}

} // namespace Lixel
