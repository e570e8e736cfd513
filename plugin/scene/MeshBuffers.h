#pragma once

#include "fit/geometry/Types.h"

#include <OgreHardwareBuffer.h>
#include <OgreRenderOperation.h>

#include <array>
#include <cstdint>
#include <vector>

/// What OGRE's buffers hold, as triangles.
namespace Lixel {

/// Three vertices, counter-clockwise seen from the front.
using TriangleCorners = std::array<std::uint32_t, 3>;

/** Vertex positions, in the space that the buffers are in.

    Reads buffers that are write-only too: from their shadow copy, or through the driver.
    @exception Ogre::InvalidParametersException for positions that are not 3 or 4 floats, and where
    the buffer is too short
*/
LIXEL_API std::vector<Vec3> readPositions(const Ogre::VertexData& data);
/// The same for `count` vertices, starting at index `first`. Overwrites `positions`.
LIXEL_API void readPositions(const Ogre::VertexData& data, std::size_t first, std::size_t count,
                             std::vector<Vec3>& positions);

/// The triangles of a list, strip or fan, indexed or not; none for lines and points.
LIXEL_API std::vector<TriangleCorners> readTriangles(const Ogre::RenderOperation& operation);
/// Of `count` triangles from the `first` on, in place of what `triangles` held.
LIXEL_API void readTriangles(const Ogre::RenderOperation& operation, std::size_t first,
                             std::size_t count, std::vector<TriangleCorners>& triangles);
LIXEL_API std::size_t countTriangles(const Ogre::RenderOperation& operation);

/// Whether a buffer was made to be written once. False for none.
inline bool isStaticBuffer(const Ogre::HardwareBuffer* buffer) {
    return buffer != nullptr && (buffer->getUsage() & Ogre::HardwareBuffer::HBU_DYNAMIC) == 0;
}

} // namespace Lixel
