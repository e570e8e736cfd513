#include "common/TriangleCollector.h"

#include "common/MaterialHoles.h"
#include "common/MaterialPass.h"

#include <Lixel/scene/OgreMath.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace Lixel::Samples {
namespace {

/// Float world matrix as OGRE hands it to the GPU, taken relative to an origin in double.
Eigen::Affine3d relativeTransform(const Ogre::Matrix4& wsFromObject,
                                  const Eigen::Vector3d& origin) {
    Eigen::Affine3d transform(toDouble(wsFromObject));
    transform.pretranslate(-origin);
    return transform;
}

/// Texture coordinates of a set; those that the mesh lacks are 0, as a program reads them.
std::vector<Eigen::Vector2f> readUvs(const Ogre::VertexData& data, unsigned set,
                                     std::size_t count) {
    std::vector<Eigen::Vector2f> uvs(count, Eigen::Vector2f::Zero());
    const Ogre::VertexElement* element = data.vertexDeclaration->findElementBySemantic(
        Ogre::VES_TEXTURE_COORDINATES, static_cast<unsigned short>(set));
    if (!element) return uvs;
    const auto buffer = data.vertexBufferBinding->getBuffer(element->getSource());
    if (buffer->isInstanceData()) return uvs; // the instances' matrices
    if (Ogre::VertexElement::getBaseType(element->getType()) != Ogre::VET_FLOAT1)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "texture coordinates must be floats",
                    "readUvs");
    const std::size_t floats =
        std::min<std::size_t>(2, Ogre::VertexElement::getTypeCount(element->getType()));
    const std::size_t stride = buffer->getVertexSize();
    std::vector<unsigned char> bytes(count * stride);
    buffer->readData(data.vertexStart * stride, bytes.size(), bytes.data());
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(uvs[i].data(), bytes.data() + i * stride + element->getOffset(),
                    floats * sizeof(float));
    return uvs;
}

} // namespace

DrawnPart TriangleCollector::read(const Ogre::MovableObject& object,
                                  const Ogre::MaterialPtr& material,
                                  const Ogre::RenderOperation& operation, std::size_t copies) {
    DrawnPart part;
    if (!operation.vertexData || operation.vertexData->vertexCount == 0) return part;
    readTriangles(operation, 0, countTriangles(operation) / copies, part.corners);
    if (part.corners.empty()) return part;
    const std::size_t vertices = operation.vertexData->vertexCount / copies;
    readPositions(*operation.vertexData, 0, vertices, part.positions);
    for (const TriangleCorners& triangle : part.corners)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= vertices)
                OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                            "'" + object.getName() + "' has an index beyond its vertices",
                            "collectTriangles");

    part.flags.casts = object.getCastShadows();
    if (!material) return part;
    part.flags.receives = material->getReceiveShadows();
    if (material->isTransparent() && !material->getTransparencyCastsShadows())
        part.flags.casts = false;
    if (const Ogre::Pass* pass = firstPass(*material)) {
        part.flags.drawnFromBack = pass->getCullingMode() == Ogre::CULL_NONE;
        part.frontIsClockwise = pass->getCullingMode() == Ogre::CULL_ANTICLOCKWISE;
    }
    if (const auto& holes = holesOf(material)) {
        part.flags.mask = holes->mask;
        part.uvs = readUvs(*operation.vertexData, holes->uvSet, vertices);
        for (Eigen::Vector2f& uv : part.uvs)
            uv = (holes->uvFromMesh * Eigen::Vector3f(uv.x(), uv.y(), 0.0F)).head<2>();
    }
    return part;
}

void TriangleCollector::add(const DrawnPart& part, const Ogre::Matrix4& wsFromObject,
                            bool mirrored) {
    const Eigen::Affine3d transform = relativeTransform(wsFromObject, mScene.wsOrigin);
    const auto first = static_cast<std::uint32_t>(mScene.positions.size());
    if (!part.uvs.empty()) {
        mScene.uvs.resize(first, Eigen::Vector2f::Zero());
        mScene.uvs.insert(mScene.uvs.end(), part.uvs.begin(), part.uvs.end());
    }
    for (const Vec3& position : part.positions)
        mScene.positions.push_back(transform * position);
    const bool turned = (mFlipsMirrored && mirrored) != part.frontIsClockwise;
    for (const TriangleCorners& corners : part.corners) {
        Triangle& triangle = mScene.triangles.emplace_back(part.flags);
        for (std::size_t k = 0; k < 3; ++k)
            triangle.vertices[k] = first + corners[k];
        if (turned) std::swap(triangle.vertices[1], triangle.vertices[2]);
    }
}

bool TriangleCollector::isMirrored(const Ogre::Renderable& renderable) {
    std::vector<Ogre::Matrix4> transforms(
        std::max<std::size_t>(1, renderable.getNumWorldTransforms()), Ogre::Matrix4::IDENTITY);
    renderable.getWorldTransforms(transforms.data());
    return toDouble(transforms.front()).topLeftCorner<3, 3>().determinant() < 0.0;
}

const std::optional<TriangleCollector::KnownHoles>&
TriangleCollector::holesOf(const Ogre::MaterialPtr& material) {
    const auto [known, isNew] = mHoles.try_emplace(material.get());
    if (!isNew) return known->second;
    if (auto holes = findHoles(*material)) {
        known->second = {static_cast<std::uint32_t>(mScene.masks.size()), holes->uvSet,
                         holes->uvFromMesh};
        mScene.masks.push_back(std::move(holes->mask));
    }
    return known->second;
}

} // namespace Lixel::Samples
