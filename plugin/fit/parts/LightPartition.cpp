#include "fit/parts/LightPartition.h"

#include "fit/focus/ViewVolume.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Sine between a face and the light's rays below which no ray is taken to leave through it: what
/// float's rounding makes of a ray along the face.
constexpr double AlongTheFace = 0x1p-24;

void add(LightPartition& parts, const ShadowLight& light, const Vec4& wsRow) {
    if (parts.count == LightPartition::Capacity) return;
    ShadowPart& part = parts.parts[parts.count++];
    part.light = light;
    part.wsRow = wsRow;
}

/// Sets each part's bounds: the half spaces in which its function is the greatest.
void bound(LightPartition& parts) {
    for (std::size_t i = 0; i < parts.count; ++i) {
        ShadowPart& part = parts.parts[i];
        part.boundCount = 0;
        for (std::size_t k = 0; k < parts.count; ++k) {
            const Vec4 difference = part.wsRow - parts.parts[k].wsRow;
            const double length = difference.head<3>().norm();
            if (k == i || !(length > 0.0)) continue;
            part.wsBounds[part.boundCount++] = {difference.head<3>() / length,
                                                difference.w() / length};
        }
    }
}

/// Whether another of the volume's planes faces the same way and lies before this one.
bool isHidden(const HalfSpace& plane, const ConvexVolume& volume) {
    constexpr double Parallel = 1e-12;
    for (const HalfSpace& other : volume.planes())
        if (&other != &plane && (other.normal - plane.normal).norm() < Parallel &&
            (other.offset < plane.offset || (other.offset == plane.offset && &other < &plane)))
            return true;
    return false;
}

/// What the viewer sees, within the light's range, as a box; false where neither ends.
bool seenBounds(const ShadowViewer& viewer, const ShadowLight& light, Aabb& box) {
    Aabb range{light.wsPosition, Vec3::Constant(light.range)};
    if (!viewBounds(viewer, box)) {
        box = range;
        return std::isfinite(light.range);
    }
    if (!std::isfinite(light.range)) return true;
    const Vec3 lower = (box.centre - box.halfExtents).cwiseMax(range.centre - range.halfExtents);
    const Vec3 upper = (box.centre + box.halfExtents).cwiseMin(range.centre + range.halfExtents);
    // Nothing that is seen is in range: any box will do.
    if ((lower.array() <= upper.array()).all())
        box = {(lower + upper) / 2.0, (upper - lower) / 2.0};
    return true;
}

/// Makes each part's light the spot around what is seen of the part; false where one map is not
/// enough for one of them.
bool aimParts(const ShadowViewer& viewer, const ShadowLight& light, LightPartition& parts,
              AimScratch& scratch) {
    Aabb bounds;
    if (!seenBounds(viewer, light, bounds)) return false;
    // Points nearer than this are the apex, which is the light: their direction is only rounding.
    const double apex = 1e-9 * (bounds.halfExtents.sum() + light.wsPosition.norm());
    for (std::size_t i = 0; i < parts.count; ++i) {
        ShadowPart& part = parts.parts[i];
        ConvexVolume volume = viewVolume(viewer);
        volume.add(part.bounds());
        scratch.wsPoints.clear();
        clipBox(bounds, volume, scratch.clip, scratch.wsPoints);
        scratch.directions.clear();
        for (const Vec3& ws : scratch.wsPoints)
            if ((ws - light.wsPosition).norm() > apex)
                scratch.directions.push_back(ws - light.wsPosition);
        // Nothing of the part is in view: any spot will do.
        if (scratch.directions.empty()) scratch.directions.push_back(-part.wsExit.head<3>());
        if (!spotAround(light, WidestHalfAngle, scratch.directions, part.light)) return false;
    }
    return true;
}

} // namespace

std::size_t LightPartition::serving(const Vec3& ws) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (parts[i].wsRow.dot(ws.homogeneous()) > parts[best].wsRow.dot(ws.homogeneous()))
            best = i;
    return best;
}

LightPartition wholeLight(const ShadowLight& light) {
    LightPartition parts;
    add(parts, light, Vec4::Zero());
    return parts;
}

LightPartition sliceView(const ShadowViewer& viewer, const ShadowLight& light,
                         std::span<const double> vsSplits, double vsPadding) {
    LightPartition parts = wholeLight(light);
    vsSplits = vsSplits.first(std::min(vsSplits.size(), LightPartition::Capacity - 1));
    const Vec4 depth = -viewer.viewFromWorld.row(2).transpose();
    Vec4 row = Vec4::Zero();
    for (const double split : vsSplits) {
        // Steeper by one with each slice: the last whose split lies before the point is greatest.
        parts.parts[parts.count - 1].vsEnd = split;
        row += (depth - Vec4(0.0, 0.0, 0.0, split)) / split;
        add(parts, light, row);
    }
    bound(parts);
    // All bounds of slices lie across the view, so a length along it is one along their normals.
    for (ShadowPart& part : std::span(parts.parts).first(parts.count))
        for (HalfSpace& plane : std::span(part.wsBounds).first(part.boundCount))
            plane.offset += vsPadding;
    return parts;
}

LightPartition stripLight(const ShadowLight& light, const LightImage& image,
                          const Vec2& liDirection, std::span<const double> liSplits) {
    liSplits = liSplits.first(std::min(liSplits.size(), LightPartition::Capacity - 1));
    if (liSplits.empty()) return wholeLight(light);
    // Of a point with the image q: z (d . q - split), with z > 0 its depth along a lamp's axis, or
    // 1.
    const auto beyond = [&](double split) {
        const Vec3 lsNormal(liDirection.x(), liDirection.y(), image.directional() ? 0.0 : split);
        const Vec3 wsNormal = image.lsFromWs().transpose() * lsNormal;
        Vec4 row;
        row << wsNormal, -wsNormal.dot(image.wsEye()) - (image.directional() ? split : 0.0);
        return row;
    };
    LightPartition parts;
    Vec4 row = -beyond(liSplits.front()) / 2.0;
    add(parts, light, row);
    for (const double split : liSplits) {
        row += beyond(split);
        add(parts, light, row);
    }
    bound(parts);
    return parts;
}

LightPartition aimedSpot(const ShadowProblem& problem, AimScratch& scratch) {
    ShadowLight spot;
    return aimSpot(problem, scratch, spot) ? wholeLight(spot) : LightPartition();
}

LightPartition widestPart(const ShadowProblem& problem, AimScratch& scratch,
                          std::optional<Vec3>& wsAxis) {
    LightPartition parts = aimedSpot(problem, scratch);
    if (parts.count > 0) return parts;
    parts = wholeLight(widestSpot(problem, scratch, wsAxis));
    parts.servesAll = false;
    return parts;
}

LightPartition cubeAround(const ShadowLight& light) {
    LightPartition parts;
    ShadowLight face = light;
    face.kind = LightKind::Spot;
    face.outerHalfAngle = std::acos(1.0 / std::sqrt(3.0)); // to the cube's corners
    // A point light's near distance is a sphere's radius; this plane does not reach into it.
    face.nearDistance = light.nearDistance / std::sqrt(3.0);
    for (const int axis : {0, 1, 2})
        for (const double sign : {1.0, -1.0}) {
            face.wsDirection = Vec3::Zero();
            face.wsDirection[axis] = sign;
            Vec4 row;
            row << face.wsDirection, -face.wsDirection.dot(light.wsPosition);
            add(parts, face, row);
        }
    bound(parts);
    return parts;
}

LightPartition facesOfView(const ShadowViewer& viewer, const ShadowLight& light,
                           AimScratch& scratch) {
    LightPartition parts;
    const bool directional = light.kind == LightKind::Directional;
    const ConvexVolume volume = viewVolume(viewer);
    for (const HalfSpace& plane : volume.planes()) {
        // Both are distances: along the light, and across the face.
        const Vec3 towards = -light.wsDirection.stableNormalized();
        const double facing =
            directional ? plane.normal.dot(towards) : plane.distance(light.wsPosition);
        if (!(facing > AlongTheFace * (directional ? 1.0 : light.wsPosition.norm()))) continue;
        if (isHidden(plane, volume)) continue; // the far plane beyond the shadow distance
        Vec4 exit;
        exit << plane.normal, plane.offset;
        add(parts, light, -exit / facing);
        parts.parts[parts.count - 1].wsExit = exit;
    }
    // A view without end, which no ray leaves.
    if (parts.count == 0) return needsParts(light) ? cubeAround(light) : wholeLight(light);
    bound(parts);
    if (needsParts(light) && !aimParts(viewer, light, parts, scratch)) return cubeAround(light);
    return parts;
}

ShadowProblem problemOf(const ShadowProblem& problem, const ShadowPart& part) {
    ShadowProblem result = problem;
    result.light = part.light;
    result.part = &part;
    return result;
}

} // namespace Lixel
