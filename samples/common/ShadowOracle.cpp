#include "common/ShadowOracle.h"

#include "common/Parallel.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr unsigned VisibleMask = 1U; ///< met by the viewer's rays
constexpr unsigned CastingMask = 2U; ///< met by shadow rays too

/** How far a shadow ray starts in front of its surface, as a fraction of the scene's half extent S.

    Embree's floats round a vertex by at most S 2^-25 per axis, the ray's origin by as much, and its
    robust intersector both differences once more: together below sqrt(3) 4 S 2^-25 < S 2^-22 along
    the normal. Eight times that keeps the origin in front of its own plane and of neighbours that
    are nearly coplanar, and is 1 mm in a scene of 1 km.
*/
constexpr double RayOffset = 1.0 / (1 << 19);

constexpr std::size_t PacketSize = 8; ///< rays that are traced at once

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using Scene = std::unique_ptr<RTCSceneTy, SceneRelease>;

/// The triangles of one Embree geometry, by its primitive number.
struct Group {
    const std::vector<Triangle>* all = nullptr;
    std::vector<std::uint32_t> members;
};

/// What Embree hands on to the filter: which faces a query sees.
struct FaceContext {
    RTCIntersectContext embree; ///< first, as the filter is given its address
    CasterFaces faces;

    explicit FaceContext(CasterFaces seen) : faces(seen) {
        rtcInitIntersectContext(&embree);
        embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }
};

/// Embree's filter for the viewer's and a map's rays: a face that is turned the other way is not
/// drawn.
void skipOtherFaces(const RTCFilterFunctionNArguments* arguments) {
    const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
    const bool fronts =
        reinterpret_cast<const FaceContext*>(arguments->context)->faces == CasterFaces::Fronts;
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const unsigned n = arguments->N;
        const std::uint32_t member = group.members[RTCHitN_primID(arguments->hit, n, i)];
        const float facing =
            RTCRayN_dir_x(arguments->ray, n, i) * RTCHitN_Ng_x(arguments->hit, n, i) +
            RTCRayN_dir_y(arguments->ray, n, i) * RTCHitN_Ng_y(arguments->hit, n, i) +
            RTCRayN_dir_z(arguments->ray, n, i) * RTCHitN_Ng_z(arguments->hit, n, i);
        const bool shown = fronts ? facing < 0.0F : facing > 0.0F;
        if (!shown && !(*group.all)[member].drawnFromBack) arguments->valid[i] = 0;
    }
}

/// The viewer's ray through a pixel, from the near plane to the far one.
struct ViewRay {
    Vector3d origin;
    Vector3d direction; ///< unit length
    double length;      ///< infinite without a far plane
};

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
    std::optional<ViewRay> through(int column, int row) const {
        const double x = (column + 0.5) / mWidth * 2.0 - 1.0;
        const double y = 1.0 - (row + 0.5) / mHeight * 2.0;
        const Vector4d near = mWsFromClip * Vector4d(x, y, -1.0, 1.0);
        // Mid-depth is finite for every projection; the far plane may lie at infinity or, by
        // rounding, beyond it.
        const Vector4d middle = mWsFromClip * Vector4d(x, y, 0.0, 1.0);
        const Vector4d far = mWsFromClip * Vector4d(x, y, 1.0, 1.0);
        if (!(near.w() > 0.0) || !(middle.w() > 0.0)) return std::nullopt;
        ViewRay ray;
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

RTCRay makeRay(const Vector3d& origin, const Vector3d& direction, double length, unsigned mask) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(origin.x());
    ray.org_y = static_cast<float>(origin.y());
    ray.org_z = static_cast<float>(origin.z());
    ray.dir_x = static_cast<float>(direction.x());
    ray.dir_y = static_cast<float>(direction.y());
    ray.dir_z = static_cast<float>(direction.z());
    ray.tnear = 0.0F;
    ray.tfar = static_cast<float>(length);
    ray.mask = mask;
    return ray;
}

} // namespace

struct ShadowOracle::Impl {
    TriangleScene scene;
    /// Embree sees positions relative to this, so that its floats round as little as they can.
    Vector3d centre = Vector3d::Zero();
    double rayOffset = 0.0; ///< world units
    Group casting;
    Group others;
    Device device;
    Scene embree;

    explicit Impl(TriangleScene triangles) : scene(std::move(triangles)) {
        validate();
        const Eigen::AlignedBox3d box = scene.box();
        if (!box.isEmpty()) {
            centre = box.center();
            rayOffset = RayOffset * (0.5 * box.sizes()).maxCoeff();
        }
        for (std::uint32_t i = 0; i < scene.triangles.size(); ++i)
            (scene.triangles[i].casts ? casting : others).members.push_back(i);
        casting.all = others.all = &scene.triangles;

        device.reset(rtcNewDevice(nullptr));
        if (!device) throw std::runtime_error("ShadowOracle: Embree gives no device");
        embree.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(embree.get(), RTC_SCENE_FLAG_ROBUST);
        attach(casting, VisibleMask | CastingMask);
        attach(others, VisibleMask);
        rtcCommitScene(embree.get());
        if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
            throw std::runtime_error("ShadowOracle: Embree cannot build the scene");
    }

    void validate() const {
        for (const Triangle& triangle : scene.triangles) {
            for (const std::uint32_t vertex : triangle.vertices) {
                if (vertex >= scene.positions.size())
                    throw std::invalid_argument("ShadowOracle: an index beyond the vertices");
                if (!scene.positions[vertex].allFinite())
                    throw std::invalid_argument("ShadowOracle: a position is not finite");
            }
        }
    }

    /// A geometry of its own per mask, since Embree's masks are per geometry.
    void attach(Group& group, unsigned mask) {
        if (group.members.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t corners = group.members.size() * 3;
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), scene.positions.size()));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), corners / 3));
        if (!vertices || !indices)
            throw std::runtime_error("ShadowOracle: Embree has no memory for the scene");
        for (const Vector3d& position : scene.positions)
            for (int axis = 0; axis < 3; ++axis)
                *vertices++ = static_cast<float>(position(axis) - centre(axis));
        for (const std::uint32_t member : group.members)
            for (const std::uint32_t vertex : scene.triangles[member].vertices)
                *indices++ = vertex;
        rtcSetGeometryMask(geometry, mask);
        rtcSetGeometryUserData(geometry, &group);
        rtcSetGeometryIntersectFilterFunction(geometry, skipOtherFaces);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(embree.get(), geometry, mask);
        rtcReleaseGeometry(geometry);
    }

    std::optional<SurfacePoint> hit(const ViewRay& ray) const {
        FaceContext context(CasterFaces::Fronts);
        RTCRayHit query{};
        query.ray = makeRay(ray.origin - centre, ray.direction, ray.length, VisibleMask);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(embree.get(), &context.embree, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

        const Group& group = (query.hit.geomID & CastingMask) != 0 ? casting : others;
        SurfacePoint point;
        point.triangle = group.members[query.hit.primID];
        const auto& corners = scene.triangles[point.triangle].vertices;
        const Vector3d& a = scene.positions[corners[0]];
        const Vector3d& b = scene.positions[corners[1]];
        const Vector3d& c = scene.positions[corners[2]];
        point.normal = (b - a).cross(c - a).normalized();
        if (point.normal.dot(ray.direction) > 0.0) point.normal = -point.normal;
        // Embree found which triangle; where on it the pixel lies is a division in double.
        double t = (a - ray.origin).dot(point.normal) / ray.direction.dot(point.normal);
        const double rough = static_cast<double>(query.ray.tfar);
        if (!(std::abs(t - rough) <= 1e-3 * rough + 16.0 * rayOffset)) t = rough;
        point.position = ray.origin + t * ray.direction;
        return point;
    }

    bool occluded(const SurfacePoint& point, const OracleLight& light) const {
        const Vector3d start = point.position + rayOffset * point.normal;
        Vector3d direction = -light.direction;
        double length = std::numeric_limits<double>::infinity();
        if (light.kind != OracleLight::Kind::Directional) {
            length = (light.position - start).norm();
            direction = (light.position - start) / length;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay ray = makeRay(start - centre, direction, length, CastingMask);
        rtcOccluded1(embree.get(), &context, &ray);
        return ray.tfar < 0.0F;
    }

    /// The first `count` of eight rays at once: neighbours meet the same nodes.
    void firstCasters(const CasterRay* rays, double* distances, std::size_t count,
                      CasterFaces faces) const {
        alignas(32) std::array<int, PacketSize> valid{};
        RTCRayHit8 query{};
        for (std::size_t i = 0; i < count; ++i) {
            valid[i] = rays[i].length > 0.0 ? -1 : 0;
            const RTCRay ray =
                makeRay(rays[i].origin - centre, rays[i].direction, rays[i].length, CastingMask);
            query.ray.org_x[i] = ray.org_x;
            query.ray.org_y[i] = ray.org_y;
            query.ray.org_z[i] = ray.org_z;
            query.ray.dir_x[i] = ray.dir_x;
            query.ray.dir_y[i] = ray.dir_y;
            query.ray.dir_z[i] = ray.dir_z;
            query.ray.tfar[i] = ray.tfar;
            query.ray.mask[i] = ray.mask;
            query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        FaceContext context(faces);
        rtcIntersect8(valid.data(), embree.get(), &context.embree, &query);
        for (std::size_t i = 0; i < count; ++i)
            distances[i] = valid[i] != 0 && query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID
                               ? static_cast<double>(query.ray.tfar[i])
                               : std::numeric_limits<double>::infinity();
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
    for (std::size_t i = 0; i < rays.size(); i += PacketSize)
        mImpl->firstCasters(rays.data() + i, distances.data() + i,
                            std::min(PacketSize, rays.size() - i), faces);
}

double ShadowOracle::rayOffset() const {
    return mImpl->rayOffset;
}

} // namespace Lixel::Samples
