#pragma once

#include "fit/problem/PictureCells.h"
#include "fit/problem/ShadowProblem.h"

#include <array>
#include <span>
#include <vector>

namespace Lixel {

/// What an earlier frame's picture showed, in world axes relative to some origin.
struct SeenSurfaces {
    /// Of surfaces, spread evenly over the picture.
    std::vector<VisiblePoint> points;
    /// Homogeneous points of where there was no surface up to the far plane; w is 0 at infinity.
    std::vector<Vec4> empty;

    void clear() {
        points.clear();
        empty.clear();
    }
};

/** What an earlier frame showed, by the cells of the picture that is seen now.

    A cell is known where something of that frame is in it, be it a surface or the sky: fits take
    its points instead of a view ray. The others were uncovered since, or lie beside what was seen.
    A point that something hides by now counts nevertheless. */
class SeenPicture {
public:
    struct Point {
        VisiblePoint point;
        /// Where it is in the picture, in device coordinates.
        Vec2 ndc;
    };

    /** Sorts what was seen into cells; what is out of view by now is left out.
        @param now its view matrix may contain a translation
        @param offset what is added to positions to make them relative to now's origin */
    void take(const SeenSurfaces& seen, const ShadowViewer& now, const Vec3& offset) noexcept;
    /// No cell is known.
    void clear() noexcept;

    bool isKnown(std::size_t cell) const { return mIsKnown[cell]; }
    /// How many of the cells.
    std::size_t known() const { return mKnown; }
    /// Of a cell. Relative to now's origin.
    std::span<const Point> points(std::size_t cell) const {
        return std::span(mPoints).subspan(mFirst[cell], mFirst[cell + 1] - mFirst[cell]);
    }

    /// A cell's point that is nearest to a place in the picture; null where it has none.
    const Point* nearest(std::size_t cell, const Vec2& ndc) const;

private:
    std::array<bool, PictureCells::Count> mIsKnown{};
    std::array<std::size_t, PictureCells::Count + 1> mFirst{};
    std::size_t mKnown = 0;
    std::vector<Point> mPoints;
    // Scratch.
    std::vector<std::pair<std::size_t, Point>> mUnsorted;
};

} // namespace Lixel
