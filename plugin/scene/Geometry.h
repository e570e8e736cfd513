#pragma once

#include "fit/Types.h"

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
    @exception Ogre::InvalidParametersException for positions that are not 3 or 4 floats
*/
LIXEL_API std::vector<Vec3> readPositions(const Ogre::VertexData& data);

/// The triangles of a list, strip or fan, indexed or not; none for lines and points.
LIXEL_API std::vector<TriangleCorners> readTriangles(const Ogre::RenderOperation& operation);

} // namespace Lixel
