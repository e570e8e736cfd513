#include "common/MeshBuilder.h"

#include <array>
#include <cmath>
#include <numbers>

namespace Lixel::Samples {
namespace {

using Ogre::uint32;
using Ogre::Vector2;
using Ogre::Vector3;

constexpr float TextureScale = 0.25F; ///< repetitions per unit of length
constexpr float TwoPi = 2.0F * std::numbers::pi_v<float>;

/// Texture coordinates in the plane that a normal is most nearly perpendicular to.
Vector2 planarUv(const Vector3& p, const Vector3& n) {
    if (std::abs(n.y) > 0.7F) return Vector2(p.x, p.z) * TextureScale;
    return (std::abs(n.x) > std::abs(n.z) ? Vector2(p.z, -p.y) : Vector2(p.x, -p.y)) * TextureScale;
}

/// A point of the unit circle in x and z; the last of a turn is bit for bit the first.
Vector2 onCircle(int segment, int segments) {
    const float angle =
        TwoPi * static_cast<float>(segment % segments) / static_cast<float>(segments);
    return {std::cos(angle), std::sin(angle)};
}

/// Outward normal (radius, height) of the outline between two of its points.
Vector2 outward(const ProfilePoint& from, const ProfilePoint& to) {
    return Vector2(to.height - from.height, from.radius - to.radius).normalisedCopy();
}

void fillVertexData(Ogre::VertexData& data, const void* bytes, std::size_t count) {
    data.vertexCount = static_cast<uint32>(count);
    Ogre::VertexDeclaration& declaration = *data.vertexDeclaration;
    std::size_t offset = 0;
    offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_POSITION).getSize();
    offset += declaration.addElement(0, offset, Ogre::VET_FLOAT3, Ogre::VES_NORMAL).getSize();
    declaration.addElement(0, offset, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    const auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        declaration.getVertexSize(0), count, Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY, true);
    buffer->writeData(0, buffer->getSizeInBytes(), bytes, true);
    data.vertexBufferBinding->setBinding(0, buffer);
}

void fillIndexData(Ogre::IndexData& data, const std::vector<uint32>& indices, bool wide) {
    data.indexCount = static_cast<uint32>(indices.size());
    data.indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        wide ? Ogre::HardwareIndexBuffer::IT_32BIT : Ogre::HardwareIndexBuffer::IT_16BIT,
        indices.size(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY, true);
    const std::size_t size = data.indexBuffer->getSizeInBytes();
    if (wide) {
        data.indexBuffer->writeData(0, size, indices.data(), true);
        return;
    }
    std::vector<Ogre::uint16> narrow;
    narrow.reserve(indices.size());
    for (const uint32 index : indices)
        narrow.push_back(static_cast<Ogre::uint16>(index));
    data.indexBuffer->writeData(0, size, narrow.data(), true);
}

} // namespace

uint32 MeshBuilder::vertex(const Vector3& position, const Vector3& normal, const Vector2& uv) {
    mVertices.push_back({transform * position, (transform.linear() * normal).normalisedCopy(), uv});
    return static_cast<uint32>(mVertices.size() - 1);
}

void MeshBuilder::triangle(uint32 a, uint32 b, uint32 c) {
    mIndices.insert(mIndices.end(), {a, b, c});
}

void MeshBuilder::polygon(std::span<const Vector3> corners) {
    const Vector3 normal =
        (corners[1] - corners[0]).crossProduct(corners[2] - corners[0]).normalisedCopy();
    const auto first = static_cast<uint32>(mVertices.size());
    for (const Vector3& corner : corners)
        vertex(corner, normal, planarUv(corner, normal));
    for (uint32 i = 2; i < corners.size(); ++i)
        triangle(first, first + i - 1, first + i);
}

void MeshBuilder::quad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
    polygon(std::array{a, b, c, d});
}

void MeshBuilder::box(const Vector3& low, const Vector3& high) {
    const std::array outline{Vector2(low.x, low.y), Vector2(high.x, low.y), Vector2(high.x, high.y),
                             Vector2(low.x, high.y)};
    prism(outline, low.z, high.z);
}

void MeshBuilder::boxOn(const Vector3& base, float width, float height, float depth) {
    const Vector3 half(0.5F * width, 0.0F, 0.5F * depth);
    box(base - half, base + half + Vector3(0.0F, height, 0.0F));
}

void MeshBuilder::prism(std::span<const Vector2> outline, float back, float front) {
    std::vector<Vector3> cap;
    for (const Vector2& p : outline)
        cap.emplace_back(p.x, p.y, front);
    polygon(cap);
    cap.clear();
    for (auto p = outline.rbegin(); p != outline.rend(); ++p)
        cap.emplace_back(p->x, p->y, back);
    polygon(cap);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2& p = outline[i];
        const Vector2& q = outline[(i + 1) % outline.size()];
        quad({p.x, p.y, back}, {q.x, q.y, back}, {q.x, q.y, front}, {p.x, p.y, front});
    }
}

void MeshBuilder::arch(float span, float height, float thickness, float depth, int segments) {
    const auto outline = [&](float radius) {
        std::vector<Vector2> points{{radius, 0.0F}};
        for (int i = 0; i <= segments; ++i) {
            const float angle = 0.5F * TwoPi * static_cast<float>(i) / static_cast<float>(segments);
            points.emplace_back(radius * std::cos(angle), height + radius * std::sin(angle));
        }
        points.emplace_back(-radius, 0.0F);
        return points;
    };
    const std::vector<Vector2> inner = outline(0.5F * span);
    const std::vector<Vector2> outer = outline(0.5F * span + thickness);
    const auto at = [&](const Vector2& p, float side) {
        return Vector3(p.x, p.y, 0.5F * side * depth);
    };
    for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
        const std::size_t j = i + 1;
        quad(at(inner[i], 1), at(outer[i], 1), at(outer[j], 1), at(inner[j], 1));
        quad(at(inner[j], -1), at(outer[j], -1), at(outer[i], -1), at(inner[i], -1));
        quad(at(outer[i], 1), at(outer[i], -1), at(outer[j], -1), at(outer[j], 1));
        quad(at(inner[j], 1), at(inner[j], -1), at(inner[i], -1), at(inner[i], 1));
    }
    const std::size_t last = inner.size() - 1;
    quad(at(inner[0], 1), at(inner[0], -1), at(outer[0], -1), at(outer[0], 1));
    quad(at(outer[last], 1), at(outer[last], -1), at(inner[last], -1), at(inner[last], 1));
}

void MeshBuilder::lathe(std::span<const ProfilePoint> profile, int segments) {
    float along = 0.0F;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const ProfilePoint& low = profile[i];
        const ProfilePoint& high = profile[i + 1];
        const Vector2 flat = outward(low, high);
        const Vector2 lowNormal =
            low.smooth && i > 0 ? (flat + outward(profile[i - 1], low)).normalisedCopy() : flat;
        const Vector2 highNormal = high.smooth && i + 2 < profile.size()
                                       ? (flat + outward(high, profile[i + 2])).normalisedCopy()
                                       : flat;
        const float length =
            std::hypot(high.radius - low.radius, high.height - low.height) * TextureScale;
        const float turn = TwoPi * std::max(low.radius, high.radius) * TextureScale;
        const auto first = static_cast<uint32>(mVertices.size());
        for (int s = 0; s <= segments; ++s) {
            const Vector2 c = onCircle(s, segments);
            const float u = turn * static_cast<float>(s) / static_cast<float>(segments);
            vertex({low.radius * c.x, low.height, low.radius * c.y},
                   {lowNormal.x * c.x, lowNormal.y, lowNormal.x * c.y}, {u, along});
            vertex({high.radius * c.x, high.height, high.radius * c.y},
                   {highNormal.x * c.x, highNormal.y, highNormal.x * c.y}, {u, along + length});
        }
        for (uint32 s = 0; s < static_cast<uint32>(segments); ++s) {
            const uint32 v = first + 2 * s;
            if (high.radius > 0.0F) triangle(v, v + 1, v + 3);
            if (low.radius > 0.0F) triangle(v, v + 3, v + 2);
        }
        along += length;
    }
}

void MeshBuilder::cylinder(float radius, float low, float high, int segments) {
    lathe(std::array{ProfilePoint{0.0F, low}, ProfilePoint{radius, low}, ProfilePoint{radius, high},
                     ProfilePoint{0.0F, high}},
          segments);
}

void MeshBuilder::cone(float radius, float low, float high, int segments) {
    lathe(std::array{ProfilePoint{0.0F, low}, ProfilePoint{radius, low}, ProfilePoint{0.0F, high}},
          segments);
}

void MeshBuilder::sphere(const Vector3& centre, float radius, int segments) {
    const int rings = segments / 2;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = 0.5F * TwoPi * static_cast<float>(i) / static_cast<float>(rings);
        const bool pole = i == 0 || i == rings;
        profile.push_back(
            {pole ? 0.0F : radius * std::sin(angle), centre.y - radius * std::cos(angle), true});
    }
    const Ogre::Affine3 outer = transform;
    Ogre::Affine3 aside = Ogre::Affine3::IDENTITY;
    aside.setTrans(Vector3(centre.x, 0.0F, centre.z));
    transform = outer * aside;
    lathe(profile, segments);
    transform = outer;
}

void MeshBuilder::torus(float radius, float tube, int segments, int sides) {
    const auto first = static_cast<uint32>(mVertices.size());
    const auto columns = static_cast<uint32>(sides + 1);
    for (int s = 0; s <= segments; ++s) {
        const Vector2 around = onCircle(s, segments);
        for (int t = 0; t <= sides; ++t) {
            const Vector2 across = onCircle(t, sides);
            const Vector3 normal(around.x * across.x, across.y, around.y * across.x);
            const float r = radius + tube * across.x;
            const Vector2 uv(TwoPi * radius * static_cast<float>(s) / static_cast<float>(segments),
                             TwoPi * tube * static_cast<float>(t) / static_cast<float>(sides));
            vertex({r * around.x, tube * across.y, r * around.y}, normal, uv * TextureScale);
        }
    }
    for (uint32 s = 0; s < static_cast<uint32>(segments); ++s) {
        for (uint32 t = 0; t < static_cast<uint32>(sides); ++t) {
            const uint32 v = first + s * columns + t;
            triangle(v, v + 1, v + columns + 1);
            triangle(v, v + columns + 1, v + columns);
        }
    }
}

void MeshBuilder::ground(float halfSide, int cells) {
    // A grid rather than two triangles: attributes interpolated over a kilometre lose digits.
    const auto first = static_cast<uint32>(mVertices.size());
    const auto columns = static_cast<uint32>(cells + 1);
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const auto place = [&](int i) {
                return halfSide * (2.0F * static_cast<float>(i) / static_cast<float>(cells) - 1.0F);
            };
            const Vector3 p(place(column), 0.0F, place(row));
            vertex(p, Vector3::UNIT_Y, planarUv(p, Vector3::UNIT_Y));
        }
    }
    for (uint32 row = 0; row < static_cast<uint32>(cells); ++row) {
        for (uint32 column = 0; column < static_cast<uint32>(cells); ++column) {
            const uint32 v = first + row * columns + column;
            triangle(v, v + columns, v + columns + 1);
            triangle(v, v + columns + 1, v + 1);
        }
    }
}

void MeshBuilder::triangles(std::span<const Vector3> positions, std::span<const Vector3> normals,
                            std::span<const Vector2> uvs, std::span<const uint32> indices) {
    const auto first = static_cast<uint32>(mVertices.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        vertex(positions[i], normals.empty() ? Vector3::UNIT_Y : normals[i],
               uvs.empty() ? Vector2::ZERO : uvs[i]);
    for (const uint32 index : indices)
        mIndices.push_back(first + index);
}

Ogre::MeshPtr MeshBuilder::build(const std::string& name) const {
    if (mIndices.empty())
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE, "mesh '" + name + "' has no triangles",
                    "MeshBuilder::build");
    auto& meshes = Ogre::MeshManager::getSingleton();
    const Ogre::String& group = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
    // Entities that still show the old mesh keep it alive.
    if (const Ogre::MeshPtr old = meshes.getByName(name, group)) meshes.remove(old);
    const Ogre::MeshPtr mesh = meshes.createManual(name, group);
    Ogre::SubMesh* part = mesh->createSubMesh();
    part->useSharedVertices = false;
    part->vertexData = OGRE_NEW Ogre::VertexData();

    Ogre::AxisAlignedBox box;
    float radius = 0.0F;
    std::vector<float> floats;
    floats.reserve(mVertices.size() * 8);
    for (const Vertex& v : mVertices) {
        box.merge(v.position);
        radius = std::max(radius, v.position.length());
        floats.insert(floats.end(), {v.position.x, v.position.y, v.position.z, v.normal.x,
                                     v.normal.y, v.normal.z, v.uv.x, v.uv.y});
    }
    fillVertexData(*part->vertexData, floats.data(), mVertices.size());
    fillIndexData(*part->indexData, mIndices, mVertices.size() > 65535);
    mesh->_setBounds(box, false);
    mesh->_setBoundingSphereRadius(radius);
    mesh->load();
    return mesh;
}

} // namespace Lixel::Samples
