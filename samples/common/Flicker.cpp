#include "common/Flicker.h"

#include "common/TruthComparison.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// Pixels around a silhouette that do not count.
constexpr int SilhouetteWidth = 2;

/// How much farther apart neighbouring points of one surface may be than their tangent planes say:
/// surfaces are curved, and meet at creases.
constexpr double Apart = 3.0;

/// Least cosine between normal and view that such a distance is derived from: below it a surface is
/// seen so flatly that nothing tells a gap from its slope.
constexpr double LeastFacing = 0.02;

/// One frame, and what follows from its view.
class Picture {
public:
    Picture(const VisiblePoints& points, const OracleView& view)
        : mPoints(points),
          mView(view),
          mEye(view.vsFromWs.inverse().topRightCorner<3, 1>()),
          // Of a pixel at depth 1, across the view.
          mPixel(2.0 / (view.clipFromVs(1, 1) * view.height)),
          mClipFromWs(view.clipFromVs * view.vsFromWs) {}

    /// How far apart points of one surface may be in neighbouring pixels.
    double reach(const SurfacePoint& point) const {
        const Vector3d toEye = mEye - point.position;
        const double facing = std::max(LeastFacing, point.normal.dot(toEye.normalized()));
        return Apart * mPixel * toEye.norm() / facing;
    }

    /// Whether they show one surface. @param a, b neighbouring pixels
    bool joined(std::size_t a, std::size_t b) const {
        if (!mPoints.pixels[a] || !mPoints.pixels[b]) return false;
        const SurfacePoint& p = *mPoints.pixels[a];
        const SurfacePoint& q = *mPoints.pixels[b];
        return (p.position - q.position).norm() <= std::max(reach(p), reach(q));
    }

    /// Per pixel, whether it is away from all silhouettes.
    std::vector<bool> inner() const {
        const int width = mPoints.width;
        const int height = mPoints.height;
        const auto index = [&](int x, int y) {
            return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x);
        };
        std::vector<bool> result(mPoints.pixels.size(), true);
        const auto spoil = [&](int x, int y) {
            for (int v = std::max(0, y - SilhouetteWidth);
                 v <= std::min(height - 1, y + SilhouetteWidth); ++v)
                for (int u = std::max(0, x - SilhouetteWidth);
                     u <= std::min(width - 1, x + SilhouetteWidth); ++u)
                    result[index(u, v)] = false;
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool right = x + 1 == width || joined(index(x, y), index(x + 1, y));
                const bool below = y + 1 == height || joined(index(x, y), index(x, y + 1));
                if (!right || !below) spoil(x, y);
                if (!right) spoil(x + 1, y);
                if (!below) spoil(x, y + 1);
            }
        return result;
    }

    /// The pixel that shows a point; none where the point is hidden, or outside of the picture.
    std::optional<std::size_t> pixelOf(const SurfacePoint& point) const {
        const Vector4d clip = mClipFromWs * point.position.homogeneous();
        if (!(clip.w() > 0.0)) return std::nullopt;
        const double x = std::floor((0.5 + 0.5 * clip.x() / clip.w()) * mPoints.width);
        const double y = std::floor((0.5 - 0.5 * clip.y() / clip.w()) * mPoints.height);
        if (!(x >= 0.0 && x < mPoints.width && y >= 0.0 && y < mPoints.height)) return std::nullopt;
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(mPoints.width) +
            static_cast<std::size_t>(x);
        const auto& shown = mPoints.pixels[pixel];
        if (!shown || !((shown->position - point.position).norm() <= reach(*shown)))
            return std::nullopt;
        const double depth = -mView.vsFromWs.row(2).dot(point.position.homogeneous());
        if (mView.shadowDistance > 0.0 && depth > mView.shadowDistance) return std::nullopt;
        return pixel;
    }

private:
    const VisiblePoints& mPoints;
    const OracleView& mView;
    Vector3d mEye;
    double mPixel;
    Eigen::Matrix4d mClipFromWs;
};

} // namespace

std::vector<std::size_t> followedPixels(const VisiblePoints& now, const OracleView& nowView,
                                        const ShadowTruth& truth, const VisiblePoints& next,
                                        const OracleView& nextView) {
    const Picture nextPicture(next, nextView);
    const std::vector<bool> innerNow = Picture(now, nowView).inner();
    const std::vector<bool> innerNext = nextPicture.inner();
    std::vector<std::size_t> followed;
    for (std::size_t i = 0; i < now.pixels.size(); ++i) {
        if (!innerNow[i]) continue;
        if (truth.pixels[i] != PixelClass::Lit && truth.pixels[i] != PixelClass::Shadowed) continue;
        const std::optional<std::size_t> there = nextPicture.pixelOf(*now.pixels[i]);
        if (there && innerNext[*there]) followed.push_back(i);
    }
    return followed;
}

std::size_t changedPixels(std::span<const std::size_t> followed,
                          std::span<const std::uint8_t> visibilityNow,
                          std::span<const std::uint8_t> visibilityNext) {
    return static_cast<std::size_t>(
        std::count_if(followed.begin(), followed.end(), [&](std::size_t pixel) {
            return (visibilityNow[pixel] >= LitVisibility) !=
                   (visibilityNext[pixel] >= LitVisibility);
        }));
}

} // namespace Lixel::Samples
