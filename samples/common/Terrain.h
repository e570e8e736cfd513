#pragma once

#include "common/MeshBuilder.h"

#include <functional>

namespace Lixel::Samples {

/// Height of ground over x and z.
using HeightFunction = std::function<float(float x, float z)>;

/// Points on ground in rows and columns, with its normals.
class GroundGrid {
public:
    /// @param height smooth over 0.05, the distance over which normals are taken
    explicit GroundGrid(HeightFunction height) : mHeight(std::move(height)) {}

    void add(float x, float z, float above, const Ogre::Vector2& uv);
    /// Two triangles for each four points, facing up where columns go along +x and rows along +z.
    void connect(Ogre::uint32 rows, Ogre::uint32 columns);
    void addTo(MeshBuilder& mesh) const;
    const std::vector<Ogre::Vector3>& positions() const { return mPositions; }

private:
    HeightFunction mHeight;
    std::vector<Ogre::Vector3> mPositions, mNormals;
    std::vector<Ogre::Vector2> mUvs;
    std::vector<Ogre::uint32> mIndices;
};

/** A block of ground about the origin, closed by walls and a flat underside, so that it may cast.

    Its texture is as large as MeshBuilder's.
    @param underside y, below all of the ground
*/
void addTerrain(MeshBuilder& mesh, const HeightFunction& height, float halfSide, int cells,
                float underside);

} // namespace Lixel::Samples
