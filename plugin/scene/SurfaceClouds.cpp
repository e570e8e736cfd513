#include "scene/SurfaceClouds.h"

#include "scene/Geometry.h"

#include <OgreEntity.h>
#include <OgreException.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
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

} // namespace

const SurfaceCloud* SurfaceClouds::of(const Ogre::Entity& entity) {
    if (entity.hasSkeleton() || entity.hasVertexAnimation()) return nullptr;
    Ogre::Mesh& mesh = *entity.getMesh();
    const auto found = mEntries.find(mesh.getHandle());
    const bool known = found != mEntries.end() && found->second.state == mesh.getStateCount();
    if (!known) {
        forgetDestroyed();
        Entry entry{mesh.getStateCount(), {}};
        try {
            entry.cloud = read(mesh);
        } catch (const Ogre::Exception&) {
            // Positions that are not floats: the box has to do. OGRE has logged the exception.
        }
        mEntries.insert_or_assign(mesh.getHandle(), std::move(entry));
    }
    const SurfaceCloud& cloud = mEntries.at(mesh.getHandle()).cloud;
    return cloud.surfels.empty() ? nullptr : &cloud;
}

void SurfaceClouds::forgetDestroyed() {
    std::erase_if(mEntries, [](const auto& entry) {
        return !Ogre::MeshManager::getSingleton().getByHandle(entry.first);
    });
}

} // namespace Lixel
