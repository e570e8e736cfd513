#include "scene/Geometry.h"

#include <OgreException.h>
#include <OgreHardwareIndexBuffer.h>
#include <OgreHardwareVertexBuffer.h>
#include <OgreVertexIndexData.h>

#include <cstring>

namespace Lixel {
namespace {

template <typename Index>
std::vector<std::uint32_t> readIndicesAs(const Ogre::IndexData& data) {
    std::vector<Index> raw(data.indexCount);
    if (!raw.empty())
        data.indexBuffer->readData(data.indexStart * sizeof(Index), raw.size() * sizeof(Index),
                                   raw.data());
    return {raw.begin(), raw.end()};
}

/// The vertices in the order in which they are drawn.
std::vector<std::uint32_t> drawOrder(const Ogre::RenderOperation& operation) {
    if (operation.useIndexes) {
        const Ogre::IndexData& data = *operation.indexData;
        return data.indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_32BIT
                   ? readIndicesAs<std::uint32_t>(data)
                   : readIndicesAs<std::uint16_t>(data);
    }
    std::vector<std::uint32_t> order(operation.vertexData->vertexCount);
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<std::uint32_t>(i);
    return order;
}

} // namespace

std::vector<Vec3> readPositions(const Ogre::VertexData& data) {
    const Ogre::VertexElement* element =
        data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    if (!element ||
        (element->getType() != Ogre::VET_FLOAT3 && element->getType() != Ogre::VET_FLOAT4))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "vertex positions must be 3 or 4 floats",
                    "readPositions");
    const Ogre::HardwareVertexBufferSharedPtr buffer =
        data.vertexBufferBinding->getBuffer(element->getSource());
    const std::size_t stride = buffer->getVertexSize();
    // readData works for write-only buffers too: from their shadow copy, or through the driver.
    std::vector<unsigned char> bytes(stride * data.vertexCount);
    if (!bytes.empty()) buffer->readData(stride * data.vertexStart, bytes.size(), bytes.data());
    std::vector<Vec3> positions(data.vertexCount);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        float xyz[3];
        std::memcpy(xyz, bytes.data() + i * stride + element->getOffset(), sizeof xyz);
        positions[i] = Eigen::Vector3f(xyz[0], xyz[1], xyz[2]).cast<double>();
    }
    return positions;
}

std::vector<TriangleCorners> readTriangles(const Ogre::RenderOperation& operation) {
    const std::vector<std::uint32_t> order = drawOrder(operation);
    std::vector<TriangleCorners> corners;
    switch (operation.operationType) {
    case Ogre::RenderOperation::OT_TRIANGLE_LIST:
        for (std::size_t i = 0; i + 2 < order.size(); i += 3)
            corners.push_back({order[i], order[i + 1], order[i + 2]});
        break;
    case Ogre::RenderOperation::OT_TRIANGLE_STRIP:
        for (std::size_t i = 0; i + 2 < order.size(); ++i) {
            const std::size_t odd = i & 1U;
            corners.push_back({order[i + odd], order[i + 1 - odd], order[i + 2]});
        }
        break;
    case Ogre::RenderOperation::OT_TRIANGLE_FAN:
        for (std::size_t i = 1; i + 1 < order.size(); ++i)
            corners.push_back({order[0], order[i], order[i + 1]});
        break;
    default:
        break;
    }
    return corners;
}

} // namespace Lixel
