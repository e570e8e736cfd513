#include "common/MapEmulation.h"

#include "common/Parallel.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Eigen::RowVector4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

/// Receivers or rays that a thread takes at a time: some tens of microseconds of work.
constexpr std::size_t PartSize = 1024;

/// The texel of a map, counted in rows from the lower left; None outside.
std::uint32_t texelAt(const EmulatedMap& map, const Vector3d& ws) {
    const Vector4d clip = map.clipFromWs * ws.homogeneous();
    const double u = 0.5 + 0.5 * clip.x() / clip.w();
    const double v = 0.5 + 0.5 * clip.y() / clip.w();
    // Negated, so that NaN fails too.
    if (!(clip.w() > 0.0) || !(u >= 0.0 && u <= 1.0) || !(v >= 0.0 && v <= 1.0)) return None;
    const auto column = std::min(static_cast<int>(u * map.width), map.width - 1);
    const auto row = std::min(static_cast<int>(v * map.height), map.height - 1);
    return static_cast<std::uint32_t>(row * map.width + column);
}

/// The map that serves a point; their number where none does.
std::size_t servingMap(std::span<const EmulatedMap> maps, const Vector3d& ws, double depth) {
    std::size_t serving = maps.size();
    double greatest = -Infinity;
    for (std::size_t m = 0; m < maps.size(); ++m) {
        if (!(depth >= maps[m].beginDepth && depth < maps[m].endDepth)) continue;
        const double share = maps[m].wsShare.dot(ws.homogeneous().transpose());
        if (!(share > greatest)) continue;
        greatest = share;
        serving = m;
    }
    return serving;
}

/// Cuts begin..end of a ray down to where plane . (x, 1) >= 0.
void keepInFront(const RowVector4d& plane, const Vector3d& origin, const Vector3d& direction,
                 double& begin, double& end) {
    const double atOrigin = plane.dot(origin.homogeneous());
    const double slope = plane.head<3>().dot(direction);
    if (slope > 0.0)
        begin = std::max(begin, -atOrigin / slope);
    else if (slope < 0.0)
        end = std::min(end, -atOrigin / slope);
    else if (atOrigin < 0.0)
        end = -Infinity;
}

} // namespace

MapEmulation::MapEmulation(const ShadowOracle& oracle, CasterFaces faces)
    : mOracle(oracle), mFaces(faces) {
    const Eigen::AlignedBox3d box = oracle.scene().box();
    if (!box.isEmpty()) mCentre = box.center();
    if (!box.isEmpty()) mRadius = 0.5 * box.diagonal().norm();
}

void MapEmulation::setView(const OracleView& view) {
    mView = view;
    mPoints = mOracle.visiblePoints(view);
}

void MapEmulation::setLight(const OracleLight& light) {
    mLight = light;
    mTruth = mOracle.classify(mPoints, mView, light);
    mReceivers.clear();
    for (std::size_t i = 0; i < mTruth.pixels.size(); ++i) {
        if (mTruth.pixels[i] != PixelClass::Lit && mTruth.pixels[i] != PixelClass::Shadowed)
            continue;
        mReceivers.push_back({i, *mPoints.pixels[i]});
    }
}

/// Numbers the texels of all maps through. @return how many there are
std::size_t MapEmulation::numberTexels(std::span<const EmulatedMap> maps) {
    std::size_t texels = 0;
    mFirstTexel.clear();
    for (const EmulatedMap& map : maps) {
        mFirstTexel.push_back(texels);
        texels += static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
    }
    return texels;
}

void MapEmulation::findTexels(std::span<const EmulatedMap> maps, const OracleView& reader) {
    mTexelOf.assign(mReceivers.size(), None);
    forEachPart(mReceivers.size(), PartSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vector3d& position = mReceivers[i].point.position;
            const double depth = -reader.vsFromWs.row(2).dot(position.homogeneous());
            const std::size_t m = servingMap(maps, position, depth);
            if (m == maps.size()) continue;
            const std::uint32_t texel = texelAt(maps[m], position);
            if (texel != None) mTexelOf[i] = static_cast<std::uint32_t>(mFirstTexel[m]) + texel;
        }
    });
}

void MapEmulation::shareRays(std::size_t texelCount) {
    mRayOfTexel.assign(texelCount, None);
    mRayOf.assign(mReceivers.size(), None);
    mReceiverOfRay.clear();
    for (std::size_t i = 0; i < mReceivers.size(); ++i) {
        if (mTexelOf[i] == None) continue;
        std::uint32_t& ray = mRayOfTexel[mTexelOf[i]];
        if (ray == None) {
            ray = static_cast<std::uint32_t>(mReceiverOfRay.size());
            mReceiverOfRay.push_back(static_cast<std::uint32_t>(i));
        }
        mRayOf[i] = ray;
    }
}

MapEmulation::TexelRay MapEmulation::rayThrough(const EmulatedMap& map, std::size_t texel,
                                                const Vector3d& anchor) const {
    const auto width = static_cast<std::size_t>(map.width);
    const double x = 2.0 * (static_cast<double>(texel % width) + 0.5) / map.width - 1.0;
    const double y = 2.0 * (static_cast<double>(texel / width) + 0.5) / map.height - 1.0;
    // The ray is where two planes meet: clip x = x w and clip y = y w.
    const RowVector4d rowW = map.clipFromWs.row(3);
    const RowVector4d planeX = map.clipFromWs.row(0) - x * rowW;
    const RowVector4d planeY = map.clipFromWs.row(1) - y * rowW;
    const Vector3d nx = planeX.head<3>().transpose();
    const Vector3d ny = planeY.head<3>().transpose();
    const Vector3d along = nx.cross(ny);
    const double squared = along.squaredNorm();

    TexelRay ray{};
    ray.caster = Infinity;
    ray.bias = BiasInRayOffsets * mOracle.rayOffset() + map.extraBias;
    ray.begin = Infinity;
    ray.end = -Infinity;
    // Two planes that do not meet: nothing is drawn there.
    if (!(squared > 0.0)) return ray;
    // The point of the ray nearest to the anchor.
    ray.origin = anchor - (planeX.dot(anchor.homogeneous()) * ny.cross(along) +
                           planeY.dot(anchor.homogeneous()) * along.cross(nx)) /
                              squared;
    ray.direction = along / std::sqrt(squared);
    const bool directional = mLight.kind == OracleLight::Kind::Directional;
    const Vector3d fromLight = directional ? mLight.direction : Vector3d(anchor - mLight.position);
    if (ray.direction.dot(fromLight) < 0.0) ray.direction = -ray.direction;

    const double centre = (mCentre - ray.origin).dot(ray.direction);
    ray.begin = centre - mRadius;
    ray.end = centre + mRadius;
    if (!directional)
        ray.begin = std::max(ray.begin, (mLight.position - ray.origin).dot(ray.direction));
    keepInFront(rowW, ray.origin, ray.direction, ray.begin, ray.end);
    if (!map.clampsDepth) {
        const RowVector4d rowZ = map.clipFromWs.row(2);
        keepInFront(rowW + rowZ, ray.origin, ray.direction, ray.begin, ray.end);
        keepInFront(rowW - rowZ, ray.origin, ray.direction, ray.begin, ray.end);
    }
    return ray;
}

void MapEmulation::traceRays(std::span<const EmulatedMap> maps) {
    mRays.resize(mReceiverOfRay.size());
    forEachPart(mRays.size(), PartSize, [&](std::size_t begin, std::size_t end) {
        std::array<CasterRay, PartSize> pieces;
        std::array<double, PartSize> distances{};
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t receiver = mReceiverOfRay[i];
            std::size_t m = maps.size() - 1;
            while (mTexelOf[receiver] < mFirstTexel[m])
                --m;
            mRays[i] = rayThrough(maps[m], mTexelOf[receiver] - mFirstTexel[m],
                                  mReceivers[receiver].point.position);
            const TexelRay& ray = mRays[i];
            pieces[i - begin] = {ray.origin + ray.begin * ray.direction, ray.direction,
                                 ray.end - ray.begin};
        }
        const std::size_t count = end - begin;
        mOracle.firstCasters(std::span(pieces).first(count), mFaces,
                             std::span(distances).first(count));
        for (std::size_t i = begin; i < end; ++i)
            mRays[i].caster = mRays[i].begin + distances[i - begin];
    });
}

bool MapEmulation::inShadow(const Receiver& receiver, const TexelRay& ray) const {
    const SurfacePoint& point = receiver.point;
    const Vector3d apart = point.position - ray.origin;
    // Seen from the light, along a ray that is not far from the light's own direction.
    const double facing = -point.normal.dot(ray.direction);
    const double plane =
        facing > 0.5 * GrazingCosine ? -point.normal.dot(apart) / facing : ray.direction.dot(apart);
    return ray.caster < plane - ray.bias;
}

std::vector<std::uint8_t> MapEmulation::visibility(std::span<const EmulatedMap> maps) {
    return visibility(maps, mView);
}

std::vector<std::uint8_t> MapEmulation::visibility(std::span<const EmulatedMap> maps,
                                                   const OracleView& reader) {
    const std::size_t texels = numberTexels(maps);
    findTexels(maps, reader);
    shareRays(texels);
    traceRays(maps);

    std::vector<std::uint8_t> visible(mTruth.pixels.size(), 255);
    forEachPart(mReceivers.size(), PartSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (mRayOf[i] != None && inShadow(mReceivers[i], mRays[mRayOf[i]]))
                visible[mReceivers[i].pixel] = 0;
    });
    return visible;
}

std::size_t MapEmulation::shadowedOutside(std::span<const EmulatedMap> maps) {
    numberTexels(maps);
    findTexels(maps, mView);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < mReceivers.size(); ++i)
        if (mTruth.pixels[mReceivers[i].pixel] == PixelClass::Shadowed && mTexelOf[i] == None)
            ++outside;
    return outside;
}

ClassificationError MapEmulation::error(std::span<const EmulatedMap> maps) {
    return compareWithTruth(mTruth, visibility(maps));
}

} // namespace Lixel::Samples
