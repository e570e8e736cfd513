#include "manager/CasterBatch.h"

#include <OgreAutoParamDataSource.h>
#include <OgreHardwareBufferManager.h>
#include <OgreLight.h>
#include <OgreMesh.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>

#include <algorithm>

namespace Lixel {
namespace {

constexpr unsigned short PositionSource = 0;
constexpr unsigned short InstanceSource = 1;
/// Of the first column, as LixelCaster.vert has it.
constexpr unsigned short FirstCoordinate = 1;
constexpr std::size_t ColumnSize = 4 * sizeof(float);
constexpr std::size_t InstanceSize = 4 * ColumnSize;
constexpr std::size_t FewestInstances = 16;

const Ogre::VertexData* verticesOf(const Ogre::SubMesh& mesh) {
    return mesh.useSharedVertices ? mesh.parent->sharedVertexData : mesh.vertexData;
}

const Ogre::VertexElement* positionOf(const Ogre::VertexData& vertices) {
    return vertices.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
}

/// GLSL's order.
void writeColumns(const Ogre::Matrix4& matrix, float* columns) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            *columns++ = static_cast<float>(matrix[row][column]);
}

} // namespace

bool CasterBatch::canDraw(const Ogre::SubMesh& mesh) {
    if (mesh.operationType != Ogre::RenderOperation::OT_TRIANGLE_LIST &&
        mesh.operationType != Ogre::RenderOperation::OT_TRIANGLE_STRIP &&
        mesh.operationType != Ogre::RenderOperation::OT_TRIANGLE_FAN)
        return false;
    const Ogre::VertexData* const vertices = verticesOf(mesh);
    // OGRE would start instances there, too.
    if (vertices == nullptr || vertices->vertexStart != 0 || vertices->vertexCount == 0)
        return false;
    const Ogre::VertexElement* const position = positionOf(*vertices);
    const auto isInstance = [](const auto& binding) { return binding.second->isInstanceData(); };
    return position != nullptr &&
           vertices->vertexBufferBinding->isBufferBound(position->getSource()) &&
           std::ranges::none_of(vertices->vertexBufferBinding->getBindings(), isInstance);
}

void CasterBatch::fill(Ogre::AutoParamDataSource& source, const Ogre::MaterialPtr& material) {
    mMaterial = material;
    reserveInstances();
    bindMesh();
    auto* columns = static_cast<float*>(mInstances->lock(Ogre::HardwareBuffer::HBL_DISCARD));
    for (const Ogre::SubEntity* caster : mCasters) {
        source.setCurrentRenderable(caster);
        writeColumns(source.getWorldViewProjMatrix(), columns);
        columns += InstanceSize / sizeof(float);
    }
    mInstances->unlock();
}

void CasterBatch::reserveInstances() {
    const std::size_t reserved = mInstances ? mInstances->getNumVertices() : 0;
    if (reserved >= mCasters.size()) return;
    const std::size_t size = std::max({FewestInstances, mCasters.size(), 2 * reserved});
    mInstances = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        InstanceSize, size, Ogre::HBU_CPU_TO_GPU);
    mInstances->setIsInstanceData(true);
    mInstances->setInstanceDataStepRate(1);
}

void CasterBatch::bindMesh() {
    const Ogre::VertexData& mesh = *verticesOf(*mKey.mesh);
    const Ogre::VertexElement& position = *positionOf(mesh);
    const Ogre::HardwareVertexBufferSharedPtr& positions =
        mesh.vertexBufferBinding->getBuffer(position.getSource());
    if (mVertices) {
        const Ogre::VertexElement& bound = *positionOf(*mVertices);
        if (bound.getOffset() == position.getOffset() && bound.getType() == position.getType() &&
            mVertices->vertexBufferBinding->getBuffer(PositionSource) == positions &&
            mVertices->vertexBufferBinding->getBuffer(InstanceSource) == mInstances) {
            mVertices->vertexCount = mesh.vertexCount;
            return;
        }
    }
    // Made anew: the render system knows a declaration's buffers by their addresses, which may come
    // again.
    mVertices = std::make_unique<Ogre::VertexData>();
    mVertices->vertexCount = mesh.vertexCount;
    Ogre::VertexDeclaration& declaration = *mVertices->vertexDeclaration;
    declaration.addElement(PositionSource, position.getOffset(), position.getType(),
                           Ogre::VES_POSITION);
    for (unsigned short column = 0; column < 4; ++column)
        declaration.addElement(InstanceSource, column * ColumnSize, Ogre::VET_FLOAT4,
                               Ogre::VES_TEXTURE_COORDINATES,
                               static_cast<unsigned short>(FirstCoordinate + column));
    mVertices->vertexBufferBinding->setBinding(PositionSource, positions);
    mVertices->vertexBufferBinding->setBinding(InstanceSource, mInstances);
}

void CasterBatch::getRenderOperation(Ogre::RenderOperation& operation) {
    operation.operationType = mKey.mesh->operationType;
    operation.vertexData = mVertices.get();
    operation.indexData = mKey.mesh->indexData;
    // As SubMesh::_getRenderOperation.
    operation.useIndexes = mKey.mesh->indexData->indexCount != 0;
    operation.numberOfInstances = static_cast<Ogre::uint32>(mCasters.size());
}

/// Instances have their own.
void CasterBatch::getWorldTransforms(Ogre::Matrix4* transforms) const {
    *transforms = Ogre::Matrix4::IDENTITY;
}

const Ogre::LightList& CasterBatch::getLights() const {
    static const Ogre::LightList none;
    return none;
}

} // namespace Lixel
