#include "fit/focus/SharedEdges.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <limits>

namespace Lixel {
namespace {

/// An edge runs along another only if it is longer than this part of it, in the same direction. The
/// far side of a flat polygon runs the opposite way. An edge as short as rounding has no direction.
constexpr double SharedPart = 1.0 / 1024.0;

} // namespace

void prepareEdges(const Polygon2& polygon, double slack, std::vector<FourEdges>& edges) {
    edges.clear();
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n && n > 2; ++i) {
        const std::size_t lane = i % 4;
        // Nothing runs along the lanes beyond the last edge.
        if (lane == 0) edges.emplace_back().shared.fill(std::numeric_limits<double>::infinity());
        FourEdges& four = edges.back();
        const Vec2& from = polygon[i];
        const Vec2 edge = polygon[i + 1 < n ? i + 1 : 0] - from;
        four.fromX[lane] = from.x();
        four.fromY[lane] = from.y();
        four.edgeX[lane] = edge.x();
        four.edgeY[lane] = edge.y();
        four.shared[lane] = SharedPart * edge.squaredNorm();
        four.slack[lane] = slack * edge.cwiseAbs().sum();
    }
}

LIXEL_MULTIVERSION
bool runsAlong(std::span<const FourEdges> edges, const Vec2& a, const Vec2& b) {
    const Vec2 own = b - a;
    for (const FourEdges& four : edges) {
        Four fromX;
        Four fromY;
        Four edgeX;
        Four edgeY;
        Four shared;
        Four slack;
        load(four.fromX.data(), fromX);
        load(four.fromY.data(), fromY);
        load(four.edgeX.data(), edgeX);
        load(four.edgeY.data(), edgeY);
        load(four.shared.data(), shared);
        load(four.slack.data(), slack);
        const Four offA = edgeX * (a.y() - fromY) - edgeY * (a.x() - fromX);
        const Four offB = edgeX * (b.y() - fromY) - edgeY * (b.x() - fromX);
        const FourMask along = (edgeX * own.x() + edgeY * own.y() > shared) & (offA <= slack) &
                               (offA >= -slack) & (offB <= slack) & (offB >= -slack);
        if (bitsOf(along) != 0) return true;
    }
    return false;
}

} // namespace Lixel
