#include "scene/MeshShapes.h"

#include "scene/Geometry.h"
#include "scene/OgreMath.h"

#include <OgreEntity.h>
#include <OgreException.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>

#include <algorithm>

namespace Lixel {
namespace {

/// A box of so many times the hull's volume costs more than the hull's additional vertices.
constexpr double LooseBox = 2.0;

/// Bounds beyond those of the vertices, relative to the longest side, that are rounding: in files
/// they are kept as floats, or as decimals.
constexpr double BoundsRounding = 1e-3;

struct Geometry {
    std::vector<Vec3> positions;
    std::vector<TriangleCorners> triangles;
    /// Whether no buffer of it is meant to be rewritten.
    bool fixed = true;
};

bool isFixed(const Ogre::VertexData& data) {
    const Ogre::VertexElement* const element =
        data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    if (element == nullptr) return false;
    const auto& buffer = data.vertexBufferBinding->getBuffer(element->getSource());
    return (buffer->getUsage() & Ogre::HardwareBuffer::HBU_DYNAMIC) == 0;
}

/// All triangles of a mesh, in its own space.
Geometry read(Ogre::Mesh& mesh) {
    Geometry geometry;
    for (Ogre::SubMesh* part : mesh.getSubMeshes()) {
        Ogre::RenderOperation operation;
        part->_getRenderOperation(operation);
        if (operation.vertexData == nullptr || operation.vertexData->vertexCount == 0) continue;
        geometry.fixed = geometry.fixed && isFixed(*operation.vertexData);
        const auto first = static_cast<std::uint32_t>(geometry.positions.size());
        const std::vector<Vec3> own = readPositions(*operation.vertexData);
        geometry.positions.insert(geometry.positions.end(), own.begin(), own.end());
        for (TriangleCorners triangle : readTriangles(operation)) {
            // An index beyond the vertices must not become another part's vertex.
            if (std::ranges::any_of(triangle, [&](auto index) { return index >= own.size(); }))
                continue;
            for (std::uint32_t& index : triangle)
                index += first;
            geometry.triangles.push_back(triangle);
        }
    }
    return geometry;
}

/// Whether the hull reaches as far as a mesh's bounds, but for the margin that OGRE adds to these.
bool fills(const BodyHull& hull, const Ogre::AxisAlignedBox& bounds) {
    if (hull.empty() || !bounds.isFinite()) return false;
    Vec3 lower = hull.vertices[0];
    Vec3 upper = lower;
    for (const Vec3& vertex : hull.vertices) {
        lower = lower.cwiseMin(vertex);
        upper = upper.cwiseMax(vertex);
    }
    const Vec3 sides = upper - lower;
    // Padded when it was made, and once more when it was loaded.
    const double padding =
        2.0 * static_cast<double>(Ogre::MeshManager::getSingleton().getBoundsPaddingFactor());
    const Vec3 slack = padding * sides + Vec3::Constant(BoundsRounding * sides.maxCoeff());
    return ((toDouble(bounds.getMinimum()) - (lower - slack)).array() >= 0.0).all() &&
           (((upper + slack) - toDouble(bounds.getMaximum())).array() >= 0.0).all();
}

} // namespace

const MeshShapes::Entry* MeshShapes::find(const Ogre::Entity& entity) {
    if (entity.hasSkeleton() || entity.hasVertexAnimation()) return nullptr;
    const Ogre::MeshPtr& mesh = entity.getMesh();
    const auto found = mEntries.find(mesh.get());
    // Another mesh may have come to be at the address of one that has gone.
    if (found != mEntries.end() && !found->second.mesh.expired() &&
        found->second.state == mesh->getStateCount())
        return &found->second;

    std::erase_if(mEntries, [](const auto& entry) { return entry.second.mesh.expired(); });
    Entry entry{mesh, mesh->getStateCount(), mesh->getBounds(), {}, {}};
    try {
        const Geometry geometry = read(*mesh);
        entry.cloud = makeSurfaceCloud(geometry.positions, geometry.triangles, Discs);
        if (geometry.fixed && !mesh->hasManualLodLevel())
            entry.hull = makeBodyHull(geometry.positions);
        if (!fills(entry.hull, entry.bounds)) entry.hull = {};
    } catch (const Ogre::Exception&) {
        // Positions that are not floats: the box has to do. OGRE has logged the exception.
    }
    return &mEntries.insert_or_assign(mesh.get(), std::move(entry)).first->second;
}

const SurfaceCloud* MeshShapes::cloudOf(const Ogre::Entity& entity) {
    const Entry* const entry = find(entity);
    return entry != nullptr && !entry->cloud.surfels.empty() ? &entry->cloud : nullptr;
}

const BodyHull* MeshShapes::hullOf(const Ogre::Entity& entity) {
    const Entry* const entry = find(entity);
    if (entry == nullptr || entry->hull.empty() || entry->bounds != entity.getMesh()->getBounds())
        return nullptr;
    return &entry->hull;
}

void ObjectShapes::reset(MeshShapes& meshes, const Vec3& wsOrigin) {
    mMeshes = &meshes;
    mWsOrigin = wsOrigin;
    mObjects.clear();
}

const BodyHull* ObjectShapes::hullOf(std::size_t index,
                                     Eigen::Affine3d& wsFromBody) const noexcept {
    if (index >= mObjects.size()) return nullptr;
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(mObjects[index]);
    const BodyHull* const hull = entity != nullptr ? mMeshes->hullOf(*entity) : nullptr;
    if (hull == nullptr) return nullptr;
    wsFromBody = Eigen::Affine3d(toDouble(entity->_getParentNodeFullTransform()));
    wsFromBody.pretranslate(-mWsOrigin);
    const double filled = hull->volume * std::abs(wsFromBody.linear().determinant());
    const auto boxed = static_cast<double>(entity->getWorldBoundingBox().volume());
    return boxed > LooseBox * filled ? hull : nullptr;
}

} // namespace Lixel
