#include "setup/LastingMap.h"

#include "fit/core/Fit.h"
#include "fit/focus/ViewVolume.h"
#include "fit/problem/KeptFit.h"

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Of a margin, the part that a map keeps free along its own border.
constexpr double EdgeShare = 0.25;

bool serves(const ShadowFit& kept, const ShadowFit& fresh, const Vec3& wsShift, double bound) {
    if (!kept.hasMap()) return false;
    const KeptFit compared = compareFits(kept, fresh, wsShift);
    return compared.covers && compared.coarseness <= 1.0 + bound;
}

} // namespace

void addLight(const ShadowProblem& problem, Fingerprint& settings) {
    const ShadowLight& light = problem.light;
    settings.add(static_cast<std::uint64_t>(light.kind));
    for (const Eigen::Index axis : {0, 1, 2}) {
        settings.add(light.wsDirection[axis]);
        // Where it is in the world, whatever the problem's origin; a sun is nowhere.
        if (light.kind != LightKind::Directional)
            settings.add(static_cast<double>(
                static_cast<float>(light.wsPosition[axis] + problem.wsOrigin[axis])));
    }
    settings.add(light.outerHalfAngle);
    settings.add(light.nearDistance);
    settings.add(light.range);
    settings.add(static_cast<std::uint64_t>(problem.mapWidth));
    settings.add(static_cast<std::uint64_t>(problem.mapHeight));
    settings.add(std::uint64_t{problem.depthClamp});
}

bool serves(const LastingMap& kept, const Fingerprint& settings, const ShadowFit& fresh,
            const ShadowProblem& problem, double bound) {
    return kept.settings == settings &&
           serves(kept.fit, fresh, problem.wsOrigin - kept.wsOrigin, bound);
}

void keep(LastingMap& kept, const ShadowFit& fit) {
    kept.fit = fit;
    // Any region within the map may be seen through it later.
    focusOnWindow(kept.fit, kept.state);
}

bool move(LastingMap& kept, const Fingerprint& settings, const ShadowFit& fresh,
          const ShadowProblem& problem, double bound) {
    if (!kept.fit.hasMap() || kept.settings != settings) return false;
    std::optional<ShadowFit> moved =
        fitToTexels(problem, kept.state, kept.fit, problem.wsOrigin - kept.wsOrigin);
    if (!moved) return false;
    focusOnWindow(*moved, kept.state);
    if (!serves(*moved, fresh, Vec3::Zero(), bound)) return false;
    kept.fit = *moved;
    kept.wsOrigin = problem.wsOrigin;
    return true;
}

ShadowProblem widened(const ShadowProblem& problem, double share) {
    ShadowProblem wide = problem;
    wide.viewer = widened(problem.viewer, share);
    wide.seen = nullptr; // by cells of the picture as it is
    // The region may end at shadows instead of at the view's border: those ends move a little too.
    wide.filterRadius += EdgeShare * share * std::min(problem.mapWidth, problem.mapHeight) / 2.0;
    return wide;
}

ShadowPart widened(const ShadowPart& part, double share) {
    ShadowPart wide = part;
    // Planes through the light, of a cube's faces, move with the light alone.
    if (!std::isfinite(part.vsEnd) && part.wsRow.head<3>().isZero(0.0)) return wide;
    for (std::size_t i = 0; i < part.boundCount; ++i) {
        HalfSpace& bound = wide.wsBounds[i];
        // The viewer is near the origin: the offset is the distance of the plane from there.
        bound.offset += share * std::abs(bound.offset);
    }
    return wide;
}

ShadowPart relocated(const ShadowPart& part, const Vec3& wsShift) {
    ShadowPart moved = part;
    moved.wsRow.w() -= part.wsRow.head<3>().dot(wsShift);
    moved.wsExit.w() -= part.wsExit.head<3>().dot(wsShift);
    for (std::size_t i = 0; i < part.boundCount; ++i)
        moved.wsBounds[i].offset -= part.wsBounds[i].normal.dot(wsShift);
    moved.light.wsPosition += wsShift;
    return moved;
}

} // namespace Lixel
