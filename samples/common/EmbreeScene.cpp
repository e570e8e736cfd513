#include "common/EmbreeScene.h"

#include <embree3/rtcore.h>

#include <stdexcept>

namespace Lixel::Samples {
namespace {

using Eigen::Vector3d;

constexpr unsigned VisibleMask = 1U; ///< met by the viewer's rays
constexpr unsigned CastingMask = 2U; ///< met by shadow rays too

constexpr unsigned CastingBit = 1U; ///< of the number of a group that casts
constexpr unsigned HolesBit = 2U;   ///< of the number of a group whose triangles have masks

/** How far a shadow ray starts in front of its surface, as a fraction of the scene's half extent S.

    Embree's floats round a vertex by at most S 2^-25 per axis, the ray's origin by as much, and its
    robust intersector both differences once more: together below sqrt(3) 4 S 2^-25 < S 2^-22 along
    the normal. Eight times that keeps the origin in front of its own plane and of neighbours that
    are nearly coplanar, and is 1 mm in a scene of 1 km.
*/
constexpr double RayOffset = 1.0 / (1 << 19);

/// What Embree hands on to the filter: which faces a query sees.
struct FaceContext {
    RTCIntersectContext embree; ///< first, as the filter is given its address
    CasterFaces faces;

    explicit FaceContext(CasterFaces seen) : faces(seen) {
        rtcInitIntersectContext(&embree);
        embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }
};

RTCRay makeRay(const CasterRay& ray, const Vector3d& centre, unsigned mask) {
    const Vector3d origin = ray.origin - centre;
    RTCRay result{};
    result.org_x = static_cast<float>(origin.x());
    result.org_y = static_cast<float>(origin.y());
    result.org_z = static_cast<float>(origin.z());
    result.dir_x = static_cast<float>(ray.direction.x());
    result.dir_y = static_cast<float>(ray.direction.y());
    result.dir_z = static_cast<float>(ray.direction.z());
    result.tnear = 0.0F;
    result.tfar = static_cast<float>(ray.length);
    result.mask = mask;
    return result;
}

} // namespace

void EmbreeScene::DeviceRelease::operator()(RTCDeviceTy* device) const {
    rtcReleaseDevice(device);
}

void EmbreeScene::SceneRelease::operator()(RTCSceneTy* scene) const {
    rtcReleaseScene(scene);
}

/// Embree's filters: they take back hits that do not count.
struct EmbreeScene::Filters {
    /// For the viewer's and a map's rays: a face that is turned the other way is not drawn.
    static void skipOtherFaces(const RTCFilterFunctionNArguments* arguments) {
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
            if (!shown && !group.scene->triangles[member].drawnFromBack) arguments->valid[i] = 0;
        }
    }

    /// For all rays that meet triangles with masks.
    static void skipHoles(const RTCFilterFunctionNArguments* arguments) {
        const auto& group = *static_cast<const Group*>(arguments->geometryUserPtr);
        const TriangleScene& scene = *group.scene;
        for (unsigned i = 0; i < arguments->N; ++i) {
            if (arguments->valid[i] == 0) continue;
            const unsigned n = arguments->N;
            const std::uint32_t member = group.members[RTCHitN_primID(arguments->hit, n, i)];
            const Triangle& triangle = scene.triangles[member];
            // Embree's weights of the second and the third vertex.
            const auto second = static_cast<double>(RTCHitN_u(arguments->hit, n, i));
            const auto third = static_cast<double>(RTCHitN_v(arguments->hit, n, i));
            const Eigen::Vector2d uv =
                (1.0 - second - third) * scene.uvs[triangle.vertices[0]].cast<double>() +
                second * scene.uvs[triangle.vertices[1]].cast<double>() +
                third * scene.uvs[triangle.vertices[2]].cast<double>();
            if (scene.masks[triangle.mask].isHole(uv)) arguments->valid[i] = 0;
        }
    }

    static void skipOtherFacesAndHoles(const RTCFilterFunctionNArguments* arguments) {
        skipOtherFaces(arguments);
        skipHoles(arguments);
    }
};

EmbreeScene::EmbreeScene(const TriangleScene& scene) : mScene(scene) {
    const Eigen::AlignedBox3d box = scene.box();
    if (!box.isEmpty()) {
        mCentre = box.center();
        mRayOffset = RayOffset * (0.5 * box.sizes()).maxCoeff();
    }
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const Triangle& triangle = scene.triangles[i];
        const unsigned group =
            (triangle.casts ? CastingBit : 0U) | (triangle.mask != NoMask ? HolesBit : 0U);
        mGroups[group].members.push_back(i);
    }
    mDevice.reset(rtcNewDevice(nullptr));
    if (!mDevice) throw std::runtime_error("ShadowOracle: Embree gives no device");
    mEmbree.reset(rtcNewScene(mDevice.get()));
    rtcSetSceneFlags(mEmbree.get(), RTC_SCENE_FLAG_ROBUST);
    for (unsigned group = 0; group < mGroups.size(); ++group)
        attach(group);
    rtcCommitScene(mEmbree.get());
    if (rtcGetDeviceError(mDevice.get()) != RTC_ERROR_NONE)
        throw std::runtime_error("ShadowOracle: Embree cannot build the scene");
}

EmbreeScene::~EmbreeScene() = default;

/// A geometry of its own per group, since Embree's masks and filters are per geometry.
void EmbreeScene::attach(unsigned number) {
    Group& group = mGroups[number];
    group.scene = &mScene;
    if (group.members.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(mDevice.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mScene.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), group.members.size()));
    if (!vertices || !indices) {
        rtcReleaseGeometry(geometry);
        throw std::runtime_error("ShadowOracle: Embree has no memory for the scene");
    }
    for (const Vector3d& position : mScene.positions)
        for (int axis = 0; axis < 3; ++axis)
            *vertices++ = static_cast<float>(position(axis) - mCentre(axis));
    for (const std::uint32_t member : group.members)
        for (const std::uint32_t vertex : mScene.triangles[member].vertices)
            *indices++ = vertex;
    rtcSetGeometryMask(geometry,
                       (number & CastingBit) != 0 ? VisibleMask | CastingMask : VisibleMask);
    rtcSetGeometryUserData(geometry, &group);
    if ((number & HolesBit) != 0) {
        rtcSetGeometryIntersectFilterFunction(geometry, Filters::skipOtherFacesAndHoles);
        rtcSetGeometryOccludedFilterFunction(geometry, Filters::skipHoles);
    } else {
        rtcSetGeometryIntersectFilterFunction(geometry, Filters::skipOtherFaces);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(mEmbree.get(), geometry, number);
    rtcReleaseGeometry(geometry);
}

std::optional<EmbreeScene::Hit> EmbreeScene::firstVisible(const CasterRay& ray) const {
    FaceContext context(CasterFaces::Fronts);
    RTCRayHit query{};
    query.ray = makeRay(ray, mCentre, VisibleMask);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(mEmbree.get(), &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{mGroups[query.hit.geomID].members[query.hit.primID],
               static_cast<double>(query.ray.tfar)};
}

bool EmbreeScene::isBlocked(const CasterRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = makeRay(ray, mCentre, CastingMask);
    rtcOccluded1(mEmbree.get(), &context, &query);
    return query.tfar < 0.0F;
}

/// Eight rays at once: neighbours meet the same nodes.
void EmbreeScene::firstCasters(const CasterRay* rays, double* distances, std::size_t count,
                               CasterFaces faces) const {
    alignas(32) std::array<int, PacketSize> valid{};
    RTCRayHit8 query{};
    for (std::size_t i = 0; i < count; ++i) {
        valid[i] = rays[i].length > 0.0 ? -1 : 0;
        const RTCRay ray = makeRay(rays[i], mCentre, CastingMask);
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
    rtcIntersect8(valid.data(), mEmbree.get(), &context.embree, &query);
    for (std::size_t i = 0; i < count; ++i)
        distances[i] = valid[i] != 0 && query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID
                           ? static_cast<double>(query.ray.tfar[i])
                           : std::numeric_limits<double>::infinity();
}

} // namespace Lixel::Samples
