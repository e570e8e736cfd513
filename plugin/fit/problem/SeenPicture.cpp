#include "fit/problem/SeenPicture.h"

#include <algorithm>
#include <utility>

namespace Lixel {
namespace {

/// The cell of a homogeneous point; Count where it is not between the view's planes.
std::size_t cellOf(const Mat4& clipFromWorld, const Vec4& ws, Vec2& ndc) {
    const Vec4 clip = clipFromWorld * ws;
    // Depths of what lies on the far plane are not compared: rounding decides there.
    if (!(clip.w() > 0.0) || !(clip.z() >= -clip.w())) return PictureCells::Count;
    ndc = clip.head<2>() / clip.w();
    return PictureCells::at(ndc);
}

} // namespace

void SeenPicture::clear() noexcept {
    mIsKnown.fill(false);
    mFirst.fill(0);
    mKnown = 0;
    mPoints.clear();
}

/*  1. Find each point's cell, and count the points of each cell.
    2. Put the points where their cells begin. */
void SeenPicture::take(const SeenSurfaces& seen, const ShadowViewer& now,
                       const Vec3& offset) noexcept {
    clear();
    mUnsorted.clear();
    const Mat4 clipFromWorld = now.clipFromView * now.viewFromWorld;
    for (const VisiblePoint& point : seen.points) {
        const VisiblePoint moved{point.ws + offset, point.wsNormal};
        Vec2 ndc;
        const std::size_t cell =
            cellOf(clipFromWorld, Vec4(moved.ws.x(), moved.ws.y(), moved.ws.z(), 1.0), ndc);
        if (cell == PictureCells::Count) continue;
        mIsKnown[cell] = true;
        ++mFirst[cell + 1];
        mUnsorted.emplace_back(cell, Point{moved, ndc});
    }
    for (Vec4 ws : seen.empty) {
        ws.head<3>() += ws.w() * offset;
        Vec2 ndc;
        const std::size_t cell = cellOf(clipFromWorld, ws, ndc);
        if (cell < PictureCells::Count) mIsKnown[cell] = true;
    }
    mKnown = static_cast<std::size_t>(std::ranges::count(mIsKnown, true));
    for (std::size_t cell = 0; cell < PictureCells::Count; ++cell)
        mFirst[cell + 1] += mFirst[cell];
    mPoints.resize(mUnsorted.size());
    std::array<std::size_t, PictureCells::Count> next;
    std::copy_n(mFirst.begin(), next.size(), next.begin());
    for (const auto& [cell, point] : mUnsorted)
        mPoints[next[cell]++] = point;
}

const SeenPicture::Point* SeenPicture::nearest(std::size_t cell, const Vec2& ndc) const {
    const Point* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Point& point : points(cell)) {
        const double distance = (point.ndc - ndc).squaredNorm();
        if (!(distance < least)) continue;
        least = distance;
        best = &point;
    }
    return best;
}

} // namespace Lixel
