#include "fit/sampling/DepthPoints.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace Lixel {
namespace {

/// Both sides of a pixel show one surface where the slopes between them turn its normal by no more
/// than this, as a tangent.
constexpr double OneSurface = 0.5;
/// The most by which the depths' resolution may turn a normal, as a tangent.
constexpr double Certain = 0.25;
/// The least cosine between the viewer and a normal that is known from one side.
constexpr double LeastFacingViewer = 0.1;
/// The rounding of interpolated and of stored depths, in units in the last place.
constexpr double Roundings = 2.0;

/// The slope of depth along one axis of the picture.
struct Slope {
    double value = 0.0;
    bool isOneSided = false;
    bool isKnown = true;
};

/// The view's matrix and its inverse.
struct Picture {
    Mat4 clipFromWorld;
    Mat4 worldFromClip;

    Vec3 row(Eigen::Index i) const { return clipFromWorld.row(i).head<3>(); }
    Vec3 point(const Vec3& ndc) const {
        const Vec4 ws = worldFromClip * ndc.homogeneous();
        return ws.head<3>() / ws.w();
    }
};

} // namespace

double DepthGrid::resolution(double depth) const {
    const double step = std::ldexp(1.0, -bits);
    return Roundings * (isFloat ? depth * step : step);
}

namespace {

/// Finds one pixel's slopes and normal.
class Pixel {
public:
    Pixel(const DepthGrid& grid, const Picture& picture, std::size_t index, const Vec2& ndc)
        : mGrid(grid), mIndex(index), mDepth(depthOf(DepthGrid::Here)) {
        mNdc = Vec3(ndc.x(), ndc.y(), grid.ndcZ(mDepth));
        // How a plane's normal changes with the slopes of depth across and up.
        mAcross = picture.row(0) - mNdc.x() * picture.row(3);
        mUp = picture.row(1) - mNdc.y() * picture.row(3);
        mBack = picture.row(2) - mNdc.z() * picture.row(3);
    }

    /// Whether it shows a surface whose normal is certain.
    bool find(const Picture& picture, VisiblePoint& point) const {
        point.ws = picture.point(mNdc);
        const Vec3 ahead = point.ws - picture.point({mNdc.x(), mNdc.y(), -1.0});
        Slope across = mean(DepthGrid::Before, DepthGrid::Behind, mGrid.ndcBeside.x());
        Slope up = mean(DepthGrid::Under, DepthGrid::Over, mGrid.ndcBeside.y());
        const double length = normal(across.value, up.value).norm();
        keepNearer(across, DepthGrid::Before, DepthGrid::Behind, mGrid.ndcBeside.x(),
                   OneSurface * length / mAcross.norm());
        keepNearer(up, DepthGrid::Under, DepthGrid::Over, mGrid.ndcBeside.y(),
                   OneSurface * length / mUp.norm());
        if (!across.isKnown || !up.isKnown) return false;

        const Vec3 wsNormal = normal(across.value, up.value);
        const double size = wsNormal.norm();
        const double resolution = 2.0 * mGrid.resolution(mDepth);
        const double turn = resolution * (mAcross.norm() / std::abs(mGrid.ndcBeside.x()) +
                                          mUp.norm() / std::abs(mGrid.ndcBeside.y()));
        const double facing = -wsNormal.dot(ahead.stableNormalized());
        if (!(turn <= Certain * size) || !point.ws.allFinite()) return false;
        if ((across.isOneSided || up.isOneSided) && !(std::abs(facing) >= LeastFacingViewer * size))
            return false;
        point.wsNormal = (facing < 0.0 ? -1.0 : 1.0) / size * wsNormal;
        return point.wsNormal.allFinite();
    }

    bool isEmpty() const { return mDepth == mGrid.nothing(); }

private:
    double depthOf(DepthGrid::Side side) const {
        return static_cast<double>(mGrid.depths[side][mIndex]);
    }

    /// The slope towards one side.
    Slope towards(DepthGrid::Side side, double ndcThere) const {
        const double depth = depthOf(side);
        return {(mGrid.ndcZ(depth) - mNdc.z()) / ndcThere, true, depth != mGrid.nothing()};
    }

    Slope mean(DepthGrid::Side lesser, DepthGrid::Side greater, double ndcBeside) const {
        const Slope a = towards(lesser, -ndcBeside);
        const Slope b = towards(greater, ndcBeside);
        return {(a.value + b.value) / 2.0, false, a.isKnown && b.isKnown};
    }

    /// Where both sides differ by more than this, the one where depth changes less.
    void keepNearer(Slope& slope, DepthGrid::Side lesser, DepthGrid::Side greater, double ndcBeside,
                    double mostApart) const {
        const Slope a = towards(lesser, -ndcBeside);
        const Slope b = towards(greater, ndcBeside);
        if (slope.isKnown && std::abs(a.value - b.value) <= mostApart) return;
        slope = !b.isKnown || (a.isKnown && std::abs(a.value) <= std::abs(b.value)) ? a : b;
    }

    /// Of the plane z = across x + up y + …, through the pixel in device coordinates: times the
    /// view's matrix, that row is the plane in the world. Away from the viewer or towards him.
    Vec3 normal(double across, double up) const { return across * mAcross + up * mUp - mBack; }

    const DepthGrid& mGrid;
    std::size_t mIndex;
    double mDepth;
    Vec3 mNdc;
    Vec3 mAcross;
    Vec3 mUp;
    Vec3 mBack;
};

} // namespace

void surfacesOf(const DepthGrid& grid, const Mat4& clipFromWorld, SeenSurfaces& seen) noexcept {
    seen.clear();
    const Picture picture{clipFromWorld, clipFromWorld.inverse()};
    for (std::size_t i = 0; i < grid.columns * grid.rows; ++i) {
        const Vec2 ndc =
            grid.ndcFirst + grid.ndcStep.cwiseProduct(Vec2(static_cast<double>(i % grid.columns),
                                                           static_cast<double>(i / grid.columns)));
        const Pixel pixel(grid, picture, i, ndc);
        if (VisiblePoint point; pixel.isEmpty())
            seen.empty.emplace_back(picture.worldFromClip * Vec4(ndc.x(), ndc.y(), 1.0, 1.0));
        else if (pixel.find(picture, point))
            seen.points.push_back(point);
    }
}

} // namespace Lixel
