#include "scene/MeshBuffers.h"

#include <OgreException.h>
#include <OgreHardwareIndexBuffer.h>
#include <OgreHardwareVertexBuffer.h>
#include <OgreVertexIndexData.h>

#include <cstring>
#include <memory>

namespace Lixel {
namespace {

/// Reads things that lie side by side in a buffer, as bytes.
std::unique_ptr<unsigned char[]> readBytes(Ogre::HardwareBuffer& buffer, std::size_t size,
                                           std::size_t first, std::size_t count) {
    const std::size_t held = buffer.getSizeInBytes() / size;
    if (first > held || count > held - first)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "a mesh's buffer is too short",
                    "readBytes");
    auto bytes = std::make_unique_for_overwrite<unsigned char[]>(count * size);
    // Works for write-only buffers too: from their shadow copy, or through the driver.
    if (count > 0) buffer.readData(first * size, count * size, bytes.get());
    return bytes;
}

template <typename Index>
void readIndicesAs(const Ogre::IndexData& data, std::size_t first, std::size_t count,
                   std::uint32_t* indices) {
    const auto bytes = readBytes(*data.indexBuffer, sizeof(Index), data.indexStart + first, count);
    for (std::size_t i = 0; i < count; ++i) {
        Index index;
        std::memcpy(&index, bytes.get() + i * sizeof(Index), sizeof(Index));
        indices[i] = index;
    }
}

std::size_t countCorners(const Ogre::RenderOperation& operation) {
    if (!operation.useIndexes) return operation.vertexData->vertexCount;
    return operation.indexData->indexBuffer ? operation.indexData->indexCount : 0;
}

/// The vertices in the order in which they are drawn.
void readDrawOrder(const Ogre::RenderOperation& operation, std::size_t first, std::size_t count,
                   std::uint32_t* order) {
    if (!operation.useIndexes) {
        for (std::size_t i = 0; i < count; ++i)
            order[i] = static_cast<std::uint32_t>(first + i);
        return;
    }
    const Ogre::IndexData& data = *operation.indexData;
    if (data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_32BIT)
        readIndicesAs<std::uint32_t>(data, first, count, order);
    else
        readIndicesAs<std::uint16_t>(data, first, count, order);
}

} // namespace

std::vector<Vec3> readPositions(const Ogre::VertexData& data) {
    std::vector<Vec3> positions;
    readPositions(data, 0, data.vertexCount, positions);
    return positions;
}

void readPositions(const Ogre::VertexData& data, std::size_t first, std::size_t count,
                   std::vector<Vec3>& positions) {
    const Ogre::VertexElement* element =
        data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    if (!element ||
        (element->getType() != Ogre::VET_FLOAT3 && element->getType() != Ogre::VET_FLOAT4))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "vertex positions must be 3 or 4 floats",
                    "readPositions");
    const Ogre::HardwareVertexBufferSharedPtr buffer =
        data.vertexBufferBinding->getBuffer(element->getSource());
    const std::size_t stride = buffer->getVertexSize();
    const auto bytes = readBytes(*buffer, stride, data.vertexStart + first, count);
    positions.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        float xyz[3];
        std::memcpy(xyz, bytes.get() + i * stride + element->getOffset(), sizeof xyz);
        positions[i] = Eigen::Vector3f(xyz[0], xyz[1], xyz[2]).cast<double>();
    }
}

std::size_t countTriangles(const Ogre::RenderOperation& operation) {
    const std::size_t corners = countCorners(operation);
    switch (operation.operationType) {
    case Ogre::RenderOperation::OT_TRIANGLE_LIST:
        return corners / 3;
    case Ogre::RenderOperation::OT_TRIANGLE_STRIP:
    case Ogre::RenderOperation::OT_TRIANGLE_FAN:
        return corners < 3 ? 0 : corners - 2;
    default:
        return 0;
    }
}

std::vector<TriangleCorners> readTriangles(const Ogre::RenderOperation& operation) {
    std::vector<TriangleCorners> triangles;
    readTriangles(operation, 0, countTriangles(operation), triangles);
    return triangles;
}

void readTriangles(const Ogre::RenderOperation& operation, std::size_t first, std::size_t count,
                   std::vector<TriangleCorners>& triangles) {
    triangles.clear();
    if (count == 0) return;
    triangles.reserve(count);
    if (operation.operationType == Ogre::RenderOperation::OT_TRIANGLE_LIST) {
        triangles.resize(count);
        readDrawOrder(operation, 3 * first, 3 * count, triangles.front().data());
        return;
    }
    const bool fan = operation.operationType == Ogre::RenderOperation::OT_TRIANGLE_FAN;
    std::uint32_t hub = 0;
    if (fan) readDrawOrder(operation, 0, 1, &hub);
    std::vector<std::uint32_t> order(count + 2);
    readDrawOrder(operation, first, count + 2, order.data());
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t odd = (first + i) & 1U;
        if (fan)
            triangles.push_back({hub, order[i + 1], order[i + 2]});
        else
            triangles.push_back({order[i + odd], order[i + 1 - odd], order[i + 2]});
    }
}

} // namespace Lixel
