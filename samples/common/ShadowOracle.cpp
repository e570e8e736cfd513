#include "common/ShadowOracle.h"

#include "common/EmbreeScene.h"
#include "common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Lixel::Samples {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// The viewer's rays through pixels, from the near plane to the far one; infinite without one.
class ViewRays {
public:
    explicit ViewRays(const OracleView& view)
        : mWidth(view.width),
          mHeight(view.height),
          mWsFromClip(view.vsFromWs.inverse() * view.clipFromVs.inverse()) {
        if (view.width < 1 || view.height < 1)
            throw std::invalid_argument("ShadowOracle: a view needs at least one pixel");
        if (!mWsFromClip.allFinite())
            throw std::invalid_argument("ShadowOracle: the view's matrices cannot be inverted");
    }

    /// Nothing where the projection has no point on the near plane.
    std::optional<CasterRay> through(int column, int row) const {
        const double x = (column + 0.5) / mWidth * 2.0 - 1.0;
        const double y = 1.0 - (row + 0.5) / mHeight * 2.0;
        const Vector4d near = mWsFromClip * Vector4d(x, y, -1.0, 1.0);
        // Mid-depth is finite for every projection; the far plane may lie at infinity or, by
        // rounding, beyond it.
        const Vector4d middle = mWsFromClip * Vector4d(x, y, 0.0, 1.0);
        const Vector4d far = mWsFromClip * Vector4d(x, y, 1.0, 1.0);
        if (!(near.w() > 0.0) || !(middle.w() > 0.0)) return std::nullopt;
        CasterRay ray;
        ray.origin = near.hnormalized();
        ray.direction = (middle.hnormalized() - ray.origin).normalized();
        ray.length = far.w() > 0.0 ? (far.hnormalized() - ray.origin).norm()
                                   : std::numeric_limits<double>::infinity();
        return ray;
    }

private:
    double mWidth;
    double mHeight;
    Matrix4d mWsFromClip;
};

void requireValid(const OracleLight& light) {
    const bool needed = light.kind != OracleLight::Kind::Point;
    if (needed && !(std::abs(light.direction.norm() - 1.0) < 1e-3))
        throw std::invalid_argument("ShadowOracle: a light's direction must have unit length");
    if (light.kind != OracleLight::Kind::Directional && !light.position.allFinite())
        throw std::invalid_argument("ShadowOracle: a light's position must be finite");
}

void requireValid(const AlphaMask& mask) {
    if (mask.width < 1 || mask.height < 1 ||
        mask.alpha.size() !=
            static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height))
        throw std::invalid_argument("ShadowOracle: a mask has not one alpha per texel");
}

const TriangleScene& requireValid(const TriangleScene& scene) {
    for (const AlphaMask& mask : scene.masks)
        requireValid(mask);
    for (const Triangle& triangle : scene.triangles) {
        const bool masked = triangle.mask != NoMask;
        if (masked && triangle.mask >= scene.masks.size())
            throw std::invalid_argument("ShadowOracle: an index beyond the masks");
        for (const std::uint32_t vertex : triangle.vertices) {
            if (vertex >= scene.positions.size())
                throw std::invalid_argument("ShadowOracle: an index beyond the vertices");
            if (!scene.positions[vertex].allFinite())
                throw std::invalid_argument("ShadowOracle: a position is not finite");
            if (masked && (vertex >= scene.uvs.size() || !scene.uvs[vertex].allFinite()))
                throw std::invalid_argument(
                    "ShadowOracle: a masked triangle lacks texture coordinates");
        }
    }
    return scene;
}

} // namespace

struct ShadowOracle::Impl {
    TriangleScene scene;
    EmbreeScene embree;

    explicit Impl(TriangleScene triangles)
        : scene(std::move(triangles)), embree(requireValid(scene)) {}

    std::optional<SurfacePoint> hit(const CasterRay& ray) const {
        const auto found = embree.firstVisible(ray);
        if (!found) return std::nullopt;
        SurfacePoint point;
        point.triangle = found->triangle;
        const auto& corners = scene.triangles[point.triangle].vertices;
        const Vector3d& a = scene.positions[corners[0]];
        const Vector3d& b = scene.positions[corners[1]];
        const Vector3d& c = scene.positions[corners[2]];
        point.normal = (b - a).cross(c - a).normalized();
        if (point.normal.dot(ray.direction) > 0.0) point.normal = -point.normal;
        // Embree found which triangle; where on it the pixel lies is a division in double.
        double t = (a - ray.origin).dot(point.normal) / ray.direction.dot(point.normal);
        const double rough = found->distance;
        if (!(std::abs(t - rough) <= 1e-3 * rough + 16.0 * embree.rayOffset())) t = rough;
        point.position = ray.origin + t * ray.direction;
        return point;
    }

    bool occluded(const SurfacePoint& point, const OracleLight& light) const {
        CasterRay ray{point.position + embree.rayOffset() * point.normal, -light.direction,
                      std::numeric_limits<double>::infinity()};
        if (light.kind != OracleLight::Kind::Directional) {
            ray.length = (light.position - ray.origin).norm();
            ray.direction = (light.position - ray.origin) / ray.length;
        }
        return embree.isBlocked(ray);
    }
};

ShadowOracle::ShadowOracle(TriangleScene scene) : mImpl(std::make_unique<Impl>(std::move(scene))) {}
ShadowOracle::~ShadowOracle() = default;
ShadowOracle::ShadowOracle(ShadowOracle&&) noexcept = default;
ShadowOracle& ShadowOracle::operator=(ShadowOracle&&) noexcept = default;

const TriangleScene& ShadowOracle::scene() const {
    return mImpl->scene;
}

VisiblePoints ShadowOracle::visiblePoints(const OracleView& view) const {
    const ViewRays rays(view);
    VisiblePoints points{view.width, view.height, {}};
    const auto width = static_cast<std::size_t>(view.width);
    points.pixels.resize(width * static_cast<std::size_t>(view.height));
    forEachPart(points.pixels.size(), width, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const auto ray =
                    rays.through(static_cast<int>(i % width), static_cast<int>(i / width)))
                points.pixels[i] = mImpl->hit(*ray);
    });
    return points;
}

ShadowTruth ShadowOracle::classify(const OracleView& view, const OracleLight& light) const {
    return classify(visiblePoints(view), view, light);
}

ShadowTruth ShadowOracle::classify(const VisiblePoints& points, const OracleView& view,
                                   const OracleLight& light) const {
    requireValid(light);
    ShadowTruth truth{points.width, points.height, {}};
    truth.pixels.resize(points.pixels.size(), PixelClass::Background);
    forEachPart(points.pixels.size(), static_cast<std::size_t>(points.width),
                [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                        if (points.pixels[i])
                            truth.pixels[i] = classifyPoint(*points.pixels[i], view, light);
                });
    return truth;
}

PixelClass ShadowOracle::classifyPoint(const SurfacePoint& point, const OracleView& view,
                                       const OracleLight& light) const {
    if (!mImpl->scene.triangles[point.triangle].receives) return PixelClass::NotReceiver;
    const double depth = -view.vsFromWs.row(2).dot(point.position.homogeneous());
    if (view.shadowDistance > 0.0 && depth > view.shadowDistance)
        return PixelClass::BeyondShadowDistance;

    Vector3d towardsLight = -light.direction;
    if (light.kind != OracleLight::Kind::Directional) {
        towardsLight = light.position - point.position;
        const double distance = towardsLight.norm();
        if (!(distance > 0.0) || distance > light.range) return PixelClass::Unlit;
        towardsLight /= distance;
        if (light.kind == OracleLight::Kind::Spot &&
            -towardsLight.dot(light.direction) < std::cos(0.5 * light.outerAngle))
            return PixelClass::Unlit;
    }
    const double cosine = point.normal.dot(towardsLight);
    if (!(cosine > 0.0)) return PixelClass::Unlit;
    const bool shadowed = occluded(point, light);
    if (cosine < GrazingCosine)
        return shadowed ? PixelClass::GrazingShadowed : PixelClass::GrazingLit;
    return shadowed ? PixelClass::Shadowed : PixelClass::Lit;
}

bool ShadowOracle::occluded(const SurfacePoint& point, const OracleLight& light) const {
    return mImpl->occluded(point, light);
}

void ShadowOracle::firstCasters(std::span<const CasterRay> rays, CasterFaces faces,
                                std::span<double> distances) const {
    if (rays.size() != distances.size())
        throw std::invalid_argument("ShadowOracle: a distance is asked for each ray");
    constexpr std::size_t Packet = EmbreeScene::PacketSize;
    for (std::size_t i = 0; i < rays.size(); i += Packet)
        mImpl->embree.firstCasters(rays.data() + i, distances.data() + i,
                                   std::min(Packet, rays.size() - i), faces);
}

double ShadowOracle::rayOffset() const {
    return mImpl->embree.rayOffset();
}

} // namespace Lixel::Samples
