#include "common/Terrain.h"

#include <array>

namespace Lixel::Samples {

using Ogre::uint32;
using Ogre::Vector2;
using Ogre::Vector3;

void GroundGrid::add(float x, float z, float above, const Vector2& uv) {
    constexpr float Step = 0.05F;
    mPositions.emplace_back(x, mHeight(x, z) + above, z);
    mNormals.push_back(Vector3(mHeight(x - Step, z) - mHeight(x + Step, z), 2.0F * Step,
                               mHeight(x, z - Step) - mHeight(x, z + Step))
                           .normalisedCopy());
    mUvs.push_back(uv);
}

void GroundGrid::connect(uint32 rows, uint32 columns) {
    for (uint32 row = 0; row + 1 < rows; ++row) {
        for (uint32 column = 0; column + 1 < columns; ++column) {
            const uint32 v = row * columns + column;
            mIndices.insert(mIndices.end(),
                            {v, v + columns, v + columns + 1, v, v + columns + 1, v + 1});
        }
    }
}

void GroundGrid::addTo(MeshBuilder& mesh) const {
    mesh.triangles(mPositions, mNormals, mUvs, mIndices);
}

void addTerrain(MeshBuilder& mesh, const HeightFunction& height, float halfSide, int cells,
                float underside) {
    GroundGrid grid(height);
    const auto along = [&](int i) {
        return halfSide * (2.0F * static_cast<float>(i) / static_cast<float>(cells) - 1.0F);
    };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column)
            grid.add(along(column), along(row), 0.0F, Vector2(along(column), along(row)) * 0.25F);
    const auto side = static_cast<std::size_t>(cells) + 1;
    grid.connect(static_cast<uint32>(side), static_cast<uint32>(side));
    grid.addTo(mesh);

    // Around the edge, counter-clockwise seen from above: +x, then -z, -x and +z.
    std::vector<Vector3> edge;
    const auto at = [&](std::size_t row, std::size_t column) {
        edge.push_back(grid.positions()[row * side + column]);
    };
    const std::size_t last = side - 1;
    for (std::size_t i = 0; i < last; ++i)
        at(last, i);
    for (std::size_t i = 0; i < last; ++i)
        at(last - i, last);
    for (std::size_t i = 0; i < last; ++i)
        at(0, last - i);
    for (std::size_t i = 0; i < last; ++i)
        at(i, 0);
    const auto under = [&](const Vector3& p) { return Vector3(p.x, underside, p.z); };
    for (std::size_t i = 0; i < edge.size(); ++i) {
        const Vector3& a = edge[i];
        const Vector3& b = edge[(i + 1) % edge.size()];
        mesh.quad(under(a), under(b), b, a);
        mesh.polygon(std::array{Vector3(0.0F, underside, 0.0F), under(b), under(a)});
    }
}

} // namespace Lixel::Samples
