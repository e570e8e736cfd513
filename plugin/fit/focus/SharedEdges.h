#pragma once

#include "fit/geometry/Polygon2.h"

#include <array>
#include <span>
#include <vector>

namespace Lixel {

/// Four edges of a convex polygon, prepared for the question which edges run along them. Without
/// that question, casters are compared with more planes: fits take 1.20 times as long, up to 1.44.
struct FourEdges {
    std::array<double, 4> fromX, fromY, edgeX, edgeY;
    /// The least length that another edge must have along this one, times this one's length; and
    /// how far off its line the other's ends may be, times the same.
    std::array<double, 4> shared, slack;
};

/// Prepares the edges of a convex polygon, each with a slack for its vertices' coordinates.
void prepareEdges(const Polygon2& polygon, double slack, std::vector<FourEdges>& edges);

/// Whether the edge from a to b runs along one of those.
bool runsAlong(std::span<const FourEdges> edges, const Vec2& a, const Vec2& b);

} // namespace Lixel
