#pragma once

#include "fit/focus/FocusRegion.h"
#include "fit/sampling/ViewSamples.h"

namespace Lixel {

/** How densely shadows' edges lie in the light image, at each distance along the light.

    A box's shadow ends at its outline as the light sees it: six of the box's edges. Their lengths
    are added up in the cells of a grid around the focus region, in a few layers along the light; a
    receiver counts what lies between it and the light. Everything is interpolated, so that what
    moves a little changes the density a little.

    Outlines in the shadow of others count as well, and a mesh is taken for its box.
*/
class EdgeDensity {
public:
    /// Cells to a side of the grid, and planes between which layers lie.
    static constexpr std::size_t Cells = 16;
    static constexpr std::size_t Planes = 4;

    /// Starts without edges.
    /// @param liHull whose bounds the grid divides
    /// @param lsRange distances along the light's axis of the first plane and of the last one; what
    /// is nearer or farther counts as if it were there
    void reset(const LightImage& image, const Polygon2& liHull, const Vec2& lsRange);

    /// Adds the outlines of boxes, to first order about a box's middle where the light is local.
    /// @param nearDistance of a local light: a box whose middle is nearer is left out
    void add(const BoxSet& casters, double nearDistance);

    /// To be called after the last add, and before the first question.
    void finish();

    /// Length of outlines per area of the light image, around a point of it, in front of a receiver
    /// at that distance along the light's axis. A point beyond the grid has that of its border.
    double at(const Vec2& li, double lsDepth) const;

    /// How often outlines of that density, all over the grid, would go around it.
    double turnsOf(double density) const;

private:
    /// Where a point is between nodes of the grid and planes.
    struct Place {
        /// Of the node before it.
        std::size_t node;
        /// How far it is to the next: across, up, along the light.
        Vec3 part;
    };
    /// Nodes to a side: both ends of all cells, and one more, to interpolate at the border.
    static constexpr std::size_t Side = Cells + 2;
    static constexpr std::size_t PlaneSize = Side * Side;

    Place place(const Vec2& inCells, double lsDepth) const;
    void addEdge(Vec2 middle, Vec2 half, double lsDepth);
    /// Leaves of an edge, middle ± half, what lies in the grid. @return whether anything does
    bool cutToGrid(Vec2& middle, Vec2& half) const;
    void addAt(const Vec2& li, double lsDepth, double length);

    LightImage mImage;
    Vec2 mLiLeast = Vec2::Zero();
    Vec2 mLiSize = Vec2::Zero();
    /// Cells per unit of the light image.
    Vec2 mScale = Vec2::Zero();
    double mLsNear = 0.0;
    /// Planes per unit along the light.
    double mLsScale = 0.0;
    /// By plane, row and node. Empty before the first reset: most states of fits need none.
    std::vector<double> mLength;
};

/** Lets samples count more where shadows' edges are dense.

    Sets each sample's weight to 1 - s + s d, where d is the density of edges at the sample,
    relative to its mean over the samples, and s is `share`, or less where outlines are few: one box
    around everything says nothing of where shadows end.
    @param share from 0 to 1
    @param liHull of the focus region, or a little more
*/
void weighByEdges(const ShadowProblem& problem, const LightImage& image, const FocusRegion& region,
                  const Polygon2& liHull, double share, EdgeDensity& edges,
                  std::vector<ViewSample>& samples);

} // namespace Lixel
