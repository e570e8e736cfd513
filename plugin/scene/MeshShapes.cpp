#include "scene/MeshShapes.h"

#include "scene/Geometry.h"
#include "scene/OgreMath.h"

#include <OgreEntity.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgrePass.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>

#include <algorithm>

namespace Lixel {
namespace {

/// A box of so many times the hull's volume is as good: the padding of a mesh's bounds alone makes
/// 1.06 of it. When a body turns, this is also what its map may change by at once.
constexpr double LooseBox = 1.1;

/// Bounds beyond those of the vertices, relative to the longest side, that are rounding: in files
/// they are kept as floats, or as decimals.
constexpr double BoundsRounding = 1e-3;

/// Vertex programs of which it is known that they do nothing but transform.
const Ogre::String OwnPrograms = "Lixel/";
const Ogre::String ShaderGenerator = "ShaderGeneratorDefaultScheme";

bool isFixed(const Ogre::VertexData& data) {
    const Ogre::VertexElement* const element =
        data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    if (element == nullptr) return false;
    const auto& buffer = data.vertexBufferBinding->getBuffer(element->getSource());
    return (buffer->getUsage() & Ogre::HardwareBuffer::HBU_DYNAMIC) == 0;
}

/// Calls `visit` with each part of a mesh that has vertices.
template <typename Visit>
void forParts(const Ogre::Mesh& mesh, const Visit& visit) {
    for (Ogre::SubMesh* part : mesh.getSubMeshes()) {
        Ogre::RenderOperation operation;
        part->_getRenderOperation(operation);
        if (operation.vertexData != nullptr && operation.vertexData->vertexCount > 0)
            visit(operation);
    }
}

SurfaceCloud readCloud(const Ogre::Mesh& mesh) {
    std::vector<Vec3> positions;
    std::vector<TriangleCorners> triangles;
    forParts(mesh, [&](const Ogre::RenderOperation& operation) {
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
    });
    return makeSurfaceCloud(positions, triangles, MeshShapes::Discs);
}

/// Whether the hull reaches as far as a mesh's bounds, but for the margin that OGRE adds to these.
bool fills(const BodyHull& hull, const Ogre::AxisAlignedBox& bounds) {
    if (hull.empty() || !bounds.isFinite()) return false;
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : hull.vertices)
        box.extend(vertex);
    // Padded when it was made, and once more when it was loaded.
    const double padding =
        2.0 * static_cast<double>(Ogre::MeshManager::getSingleton().getBoundsPaddingFactor());
    const Vec3 slack =
        padding * box.sizes() + Vec3::Constant(BoundsRounding * box.sizes().maxCoeff());
    const Eigen::AlignedBox3d padded(box.min() - slack, box.max() + slack);
    return padded.contains(toDouble(bounds.getMinimum())) &&
           padded.contains(toDouble(bounds.getMaximum()));
}

/// The hull of all vertices; empty where one of them may not stay where it is.
BodyHull readHull(const Ogre::Mesh& mesh) {
    std::vector<Vec3> positions;
    bool fixed = true;
    const Ogre::VertexData* last = nullptr;
    forParts(mesh, [&](const Ogre::RenderOperation& operation) {
        // Parts that share their vertices follow each other, as a rule.
        if (operation.vertexData == last) return;
        last = operation.vertexData;
        fixed = fixed && isFixed(*last);
        if (!fixed) return;
        const std::vector<Vec3> own = readPositions(*last);
        positions.insert(positions.end(), own.begin(), own.end());
    });
    if (!fixed) return {};
    BodyHull hull = makeBodyHull(positions);
    return fills(hull, mesh.getBounds()) ? hull : BodyHull();
}

/// Reads something of a mesh; nothing where its positions are not floats, which OGRE has logged, or
/// memory is short: the box has to do.
template <typename Shape>
const Shape& readOnce(std::optional<Shape>& shape, const Ogre::Mesh& mesh,
                      Shape (*read)(const Ogre::Mesh&)) {
    if (!shape) {
        shape.emplace();
        try {
            *shape = read(mesh);
        } catch (const std::exception&) {
        }
    }
    return *shape;
}

/// Whether a vertex program may move vertices elsewhere than their node has them.
bool mayMoveVertices(const Ogre::Entity& entity) {
    for (const Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material) continue;
        for (const Ogre::Technique* technique : material->getTechniques()) {
            if (technique->getSchemeName() == ShaderGenerator) continue;
            for (const Ogre::Pass* pass : technique->getPasses())
                if (pass->hasVertexProgram() &&
                    !Ogre::StringUtil::startsWith(pass->getVertexProgramName(), OwnPrograms, false))
                    return true;
        }
    }
    return false;
}

/// An entity's hull, for whoever must not throw.
const BodyHull* hullOrNone(MeshShapes& meshes, const Ogre::Entity& entity) noexcept {
    try {
        return meshes.hullOf(entity);
    } catch (const std::exception&) {
        return nullptr;
    }
}

} // namespace

MeshShapes::Entry* MeshShapes::find(const Ogre::Entity& entity) {
    if (entity.hasSkeleton() || entity.hasVertexAnimation()) return nullptr;
    const Ogre::MeshPtr& mesh = entity.getMesh();
    const auto found = mEntries.find(mesh.get());
    // Another mesh may have come to be at the address of one that has gone.
    if (found != mEntries.end() && !found->second.mesh.expired() &&
        found->second.state == mesh->getStateCount())
        return &found->second;

    std::erase_if(mEntries, [](const auto& entry) { return entry.second.mesh.expired(); });
    Entry entry{mesh, mesh->getStateCount(), mesh->getBounds(), {}, {}};
    return &mEntries.insert_or_assign(mesh.get(), std::move(entry)).first->second;
}

const SurfaceCloud* MeshShapes::cloudOf(const Ogre::Entity& entity) {
    Entry* const entry = find(entity);
    if (entry == nullptr) return nullptr;
    const SurfaceCloud& cloud = readOnce(entry->cloud, *entity.getMesh(), readCloud);
    return cloud.surfels.empty() ? nullptr : &cloud;
}

const BodyHull* MeshShapes::hullOf(const Ogre::Entity& entity) {
    Entry* const entry = find(entity);
    if (entry == nullptr) return nullptr;
    const Ogre::Mesh& mesh = *entity.getMesh();
    if (entry->bounds != mesh.getBounds() || mesh.hasManualLodLevel()) return nullptr;
    const BodyHull& hull = readOnce(entry->hull, mesh, readHull);
    return hull.empty() || mayMoveVertices(entity) ? nullptr : &hull;
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
    const BodyHull* const hull = entity != nullptr ? hullOrNone(*mMeshes, *entity) : nullptr;
    if (hull == nullptr) return nullptr;
    wsFromBody = relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin);
    const double filled = hull->volume * std::abs(wsFromBody.linear().determinant());
    const auto boxed = static_cast<double>(entity->getWorldBoundingBox().volume());
    return boxed > LooseBox * filled ? hull : nullptr;
}

} // namespace Lixel
