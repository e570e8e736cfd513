#include "PictureCasters.h"

#include "common/Stage.h"

#include <Lixel/scene/MeshBuffers.h>

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Ogre::Vector2;
using Ogre::Vector3;

/// A ray that comes nearer than this to an edge of a hole may be on either side of it.
constexpr int NearTexels = 5;

/// Where a ray meets a triangle, as the weights of its second and third corner. (Möller and
/// Trumbore 1997.)
bool meets(const Ogre::Ray& ray, const Vector3& a, const Vector3& b, const Vector3& c,
           Vector2& weights) {
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    const Vector3 p = ray.getDirection().crossProduct(ac);
    const float determinant = ab.dotProduct(p);
    if (std::abs(determinant) < 1e-9F) return false;
    const Vector3 from = ray.getOrigin() - a;
    const Vector3 q = from.crossProduct(ab);
    weights = Vector2(from.dotProduct(p), ray.getDirection().dotProduct(q)) / determinant;
    return weights.x >= 0.0F && weights.y >= 0.0F && weights.x + weights.y <= 1.0F &&
           ac.dotProduct(q) / determinant > 0.0F;
}

} // namespace

Ogre::String materialOf(const Ogre::MovableObject& object) {
    if (object.getMovableType() == "Entity")
        return static_cast<const Ogre::Entity&>(object).getSubEntity(0)->getMaterialName();
    if (object.getMovableType() == "InstancedEntity")
        return static_cast<const Ogre::InstancedEntity&>(object)
            ._getOwner()
            ->getMaterial()
            ->getName();
    return {};
}

PictureCasters::PictureCasters(const std::string& picture) {
    mPicture.load(picture, MediaGroup);
}

void PictureCasters::add(const Ogre::MovableObject& object) {
    const Ogre::MeshPtr mesh =
        object.getMovableType() == "Entity"
            ? static_cast<const Ogre::Entity&>(object).getMesh()
            : static_cast<const Ogre::InstancedEntity&>(object)._getOwner()->_getMeshReference();
    Ogre::SubMesh& part = *mesh->getSubMesh(0);
    const Ogre::Affine3 wsFromMesh(object.getParentNode()->_getFullTransform());
    const auto buffer = part.vertexData->vertexBufferBinding->getBuffer(0);
    std::vector<float> floats(buffer->getSizeInBytes() / sizeof(float));
    buffer->readData(0, buffer->getSizeInBytes(), floats.data());
    const std::size_t stride = buffer->getVertexSize() / sizeof(float);
    Ogre::RenderOperation operation;
    part._getRenderOperation(operation);
    for (const TriangleCorners& corners : readTriangles(operation)) {
        std::array<Corner, 3> triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const float* const v = &floats[corners[i] * stride]; // position, normal, coordinates
            triangle[i] = {wsFromMesh * Vector3(v[0], v[1], v[2]), Vector2(v[6], v[7])};
        }
        mTriangles.push_back(triangle);
    }
}

Meeting PictureCasters::around(const Vector2& uv) const {
    const int width = static_cast<int>(mPicture.getWidth());
    const int height = static_cast<int>(mPicture.getHeight());
    const int column = static_cast<int>(std::floor(uv.x * static_cast<float>(width)));
    const int row = static_cast<int>(std::floor(uv.y * static_cast<float>(height)));
    bool whole = true, empty = true;
    for (int y = row - NearTexels; y <= row + NearTexels; ++y) {
        for (int x = column - NearTexels; x <= column + NearTexels; ++x) {
            const float alpha =
                mPicture
                    .getColourAt(static_cast<std::size_t>(((x % width) + width) % width),
                                 static_cast<std::size_t>(std::clamp(y, 0, height - 1)), 0)
                    .a;
            whole = whole && alpha > 0.6F;
            empty = empty && alpha < 0.4F;
        }
    }
    return whole ? Meeting::Picture : empty ? Meeting::Hole : Meeting::Edge;
}

Meeting PictureCasters::meet(const Ogre::Ray& ray) const {
    Meeting first = Meeting::Nothing;
    for (const auto& [a, b, c] : mTriangles) {
        Vector2 weights;
        if (!meets(ray, a.ws, b.ws, c.ws, weights)) continue;
        const Meeting here = around(a.uv + weights.x * (b.uv - a.uv) + weights.y * (c.uv - a.uv));
        first = std::min(first, here);
        if (first == Meeting::Picture) break;
    }
    return first;
}

} // namespace Lixel::Samples
