#include "fit/sampling/TexelExtent.h"

#include "fit/geometry/Multiversion.h"
#include "fit/geometry/Simd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lixel {
namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Sine of the angle between a map's axes below which texels are too thin to be any good.
constexpr double LeastAxesSine = 0.1;

/// A parallelogram of more than so many times the smallest rectangle's area is not judged: how long
/// texels are on average goes with the area's square root, and what their shape gains is less.
constexpr double GreatestAxesArea = 1.2;

/// Gain over the smallest rectangle, relative, from which on a parallelogram is taken: less is
/// within what samples can tell.
constexpr double LeastAxesGain = 0.02;

/// Gain for which the last map's axes are given up: half the share of the map's area that a turned
/// rectangle has to save (MapPlacement.cpp), since a texel's extent goes with the area's square
/// root.
constexpr double TurnedAxesGain = 0.05;

/// The count rounded up to whole fours.
constexpr std::size_t inFours(std::size_t count) {
    return (count + 3) / 4 * 4;
}

/// Loops over lanes become one instruction where it need not report errors (CMakeLists.txt).
[[gnu::always_inline]] inline void squareRoot(Four& value) {
    for (int lane = 0; lane < 4; ++lane)
        value[lane] = std::sqrt(value[lane]);
}

} // namespace

LIXEL_MULTIVERSION
MapSides smallestMap(const double* x, const double* y, std::size_t count) {
    Four leastArea = Four{} + Infinity;
    Four leastPerimeter = leastArea;
    Four edgeX{};
    Four edgeY{};
    Four along{};
    Four across{};
    for (std::size_t i = 0; i < count; i += 4) {
        Four fromX;
        Four fromY;
        Four toX;
        Four toY;
        load(x + i, fromX);
        load(y + i, fromY);
        load(x + i + 1, toX);
        load(y + i + 1, toY);
        toX -= fromX;
        toY -= fromY;
        // Bounds along the edge and across it, times its length.
        Four leastAlong = Four{} + Infinity;
        Four leastAcross = leastAlong;
        Four mostAlong = -leastAlong;
        Four mostAcross = -leastAlong;
        for (std::size_t k = 0; k < count; ++k) {
            const Four alongEdge = toX * x[k] + toY * y[k];
            const Four acrossEdge = toX * y[k] - toY * x[k];
            lesser(alongEdge, leastAlong, leastAlong);
            greater(alongEdge, mostAlong, mostAlong);
            lesser(acrossEdge, leastAcross, leastAcross);
            greater(acrossEdge, mostAcross, mostAcross);
        }
        // Not a number for an edge of length zero, which is never better.
        const Four scale = 1.0 / (toX * toX + toY * toY);
        const Four width = (mostAlong - leastAlong) * scale;
        const Four height = (mostAcross - leastAcross) * scale;
        const Four area = (mostAlong - leastAlong) * height;
        // A polygon without area makes many rectangles of area 0: the shortest is the one wanted.
        const Four perimeter =
            (mostAlong - leastAlong + mostAcross - leastAcross) * (width + height);
        const FourMask better =
            (area < leastArea) | ((area == leastArea) & (perimeter < leastPerimeter));
        leastArea = better ? area : leastArea;
        leastPerimeter = better ? perimeter : leastPerimeter;
        edgeX = better ? toX : edgeX;
        edgeY = better ? toY : edgeY;
        along = better ? width : along;
        across = better ? height : across;
    }
    int best = 0;
    for (int lane = 1; lane < 4; ++lane)
        if (leastArea[lane] < leastArea[best] ||
            (leastArea[lane] == leastArea[best] && leastPerimeter[lane] < leastPerimeter[best]))
            best = lane;
    return {Vec2(edgeX[best], edgeY[best]) * along[best],
            Vec2(-edgeY[best], edgeX[best]) * across[best]};
}

namespace {

/// The hull warped: q / (1 + w . q).
void warpAll(const double* x, const double* y, std::size_t count, const Vec2& warp, double* warpedX,
             double* warpedY) {
    for (std::size_t i = 0; i < count; i += 4) {
        Four atX;
        Four atY;
        load(x + i, atX);
        load(y + i, atY);
        const Four scale = 1.0 / (1.0 + (warp.x() * atX + warp.y() * atY));
        store(atX * scale, warpedX + i);
        store(atY * scale, warpedY + i);
    }
}

} // namespace

/// The sum over samples.
LIXEL_MULTIVERSION
double TexelExtent::sumOver(const SampleColumns& columns, std::size_t count, const Vec2& warp,
                            const MapSides& map, double scale) {
    const double squaredScale = scale * scale;
    const double wu = warp.dot(map.u);
    const double wv = warp.dot(map.v);
    Four sum{};
    for (std::size_t i = 0; i < count; i += 4) {
        Four x;
        Four y;
        load(&columns.x[i], x);
        load(&columns.y[i], y);
        // p = q / D with D = 1 + w . q has the derivative (I - q w^T / D) / D, whose inverse is
        // D (I + q w^T): nothing is divided.
        const Four ux = map.u.x() + x * wu;
        const Four uy = map.u.y() + y * wu;
        const Four vx = map.v.x() + x * wv;
        const Four vy = map.v.y() + y * wv;
        const Four inLight = (ux * ux + uy * uy) + (vx * vx + vy * vy);
        Four inPicture{};
        for (std::size_t row = 0; row < 2; ++row) {
            Four a;
            Four b;
            load(&columns.ndcFromLi[2 * row][i], a);
            load(&columns.ndcFromLi[2 * row + 1][i], b);
            const Four u = a * ux + b * uy;
            const Four v = a * vx + b * vy;
            inPicture += u * u + v * v;
        }
        // Both are squares, less a factor D each; the fourth root of eL^3 eP^2 is wanted.
        static_assert(LightPower == 0.75 && PicturePower == 0.5);
        const Four denominator = 1.0 + (warp.x() * x + warp.y() * y);
        const Four squared = denominator * denominator;
        Four light = inLight * (squared * squaredScale);
        squareRoot(light);
        Four value = light * light * light * (inPicture * squared);
        squareRoot(value);
        squareRoot(value);
        sum += value;
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void TexelExtent::reset(const std::vector<ViewSample>& samples, const Polygon2& hull,
                        const Vec2& centre) {
    // After the last vertex the first is repeated: one edge closes the polygon, and the others have
    // length 0.
    mVertices = hull.size();
    const std::size_t vertices = inFours(mVertices + 1) + 4;
    for (std::vector<double>* column : {&mHullX, &mHullY, &mWarpedX, &mWarpedY})
        if (column->size() < vertices) column->resize(vertices);
    double farthest = 0.0;
    for (std::size_t i = 0; i < vertices; ++i) {
        const Vec2 q = hull.empty() ? Vec2(0.0, 0.0) : Vec2(hull[i < mVertices ? i : 0] - centre);
        mHullX[i] = q.x();
        mHullY[i] = q.y();
        farthest = std::max(farthest, q.cwiseAbs().maxCoeff());
    }
    mScale = farthest > 0.0 ? 1.0 / farthest : 1.0;
    // Behind the samples are some of extent zero.
    mCount = samples.size();
    const std::size_t count = inFours(mCount);
    for (std::vector<double>* column : mSamples.all())
        if (column->size() < count) column->resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool real = i < mCount;
        const Vec2 q = real ? Vec2(samples[i].liPoint - centre) : Vec2(0.0, 0.0);
        mSamples.x[i] = q.x();
        mSamples.y[i] = q.y();
        // What a sample adds goes with the square root of these numbers.
        const double squared = real ? samples[i].weight * samples[i].weight : 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            mSamples.ndcFromLi[k][i] =
                real ? squared * samples[i].ndcFromLi(static_cast<Eigen::Index>(k / 2),
                                                      static_cast<Eigen::Index>(k % 2))
                     : 0.0;
    }
}

MapSides TexelExtent::warpHull(const Vec2& warp) {
    const std::size_t padded = inFours(mVertices);
    warpAll(mHullX.data(), mHullY.data(), padded + 4, warp, mWarpedX.data(), mWarpedY.data());
    return smallestMap(mWarpedX.data(), mWarpedY.data(), padded);
}

double TexelExtent::sumOver(const Vec2& warp, const MapSides& map) const {
    return sumOver(mSamples, inFours(mCount), warp, map, mScale);
}

double TexelExtent::operator()(const Vec2& warp) {
    return std::pow(sumOver(warp, warpHull(warp)) / static_cast<double>(mCount), MeanPower);
}

TexelExtent::Extent TexelExtent::extentAlong(const Vec2& normal) const {
    double least = Infinity;
    double most = -Infinity;
    for (std::size_t i = 0; i < mVertices; ++i) {
        const double along = normal.x() * mWarpedX[i] + normal.y() * mWarpedY[i];
        least = std::min(least, along);
        most = std::max(most, along);
    }
    return {normal, most - least};
}

std::optional<MapSides> TexelExtent::sidesOf(const Extent& a, const Extent& b) {
    const double sine = cross(a.normal, b.normal);
    if (!(sine > LeastAxesSine)) return std::nullopt;
    // A side runs along the other axis' lines, as far as its own coordinate goes from end to end.
    return MapSides{a.length / sine * Vec2(b.normal.y(), -b.normal.x()),
                    b.length / sine * Vec2(-a.normal.y(), a.normal.x())};
}

std::optional<MapAxes> TexelExtent::chooseAxes(const Vec2& warp,
                                               const std::optional<MapAxes>& last) {
    const MapSides rectangle = warpHull(warp);
    if (!(rectangle.u.norm() > 0.0 && rectangle.v.norm() > 0.0)) return std::nullopt;
    const auto sumFor = [&](const MapSides& sides) { return sumOver(warp, sides); };
    // What becomes of the sum where the measure gains.
    const auto after = [](double gain) { return std::pow(1.0 - gain, 1.0 / MeanPower); };
    const Vec2 along = rectangle.u.stableNormalized();
    MapAxes best{{along, Vec2(-along.y(), along.x())}};
    double bestSum = sumFor(rectangle);
    const double worthwhile = after(LeastAxesGain) * bestSum;
    const double greatestArea = GreatestAxesArea * rectangle.u.norm() * rectangle.v.norm();
    mAcross.clear();
    for (std::size_t i = 0; i < mVertices; ++i)
        mAcross.push_back(extentAlong(
            Vec2(mWarpedY[i] - mWarpedY[i + 1], mWarpedX[i + 1] - mWarpedX[i]).stableNormalized()));
    for (std::size_t i = 0; i < mVertices; ++i)
        for (std::size_t k = i + 1; k < mVertices; ++k) {
            const Extent& a = mAcross[i];
            Extent b = mAcross[k];
            if (cross(a.normal, b.normal) < 0.0) b.normal = -b.normal;
            const auto sides = sidesOf(a, b);
            if (!sides || !(std::abs(cross(sides->u, sides->v)) <= greatestArea)) continue;
            const double sum = sumFor(*sides);
            if (!(sum < std::min(bestSum, worthwhile))) continue;
            bestSum = sum;
            best.normals = {a.normal, b.normal};
        }
    if (!last) return best;
    const auto kept = sidesOf(extentAlong(last->normals[0]), extentAlong(last->normals[1]));
    if (!kept || !(sumFor(*kept) * after(TurnedAxesGain) <= bestSum)) return best;
    return MapAxes{last->normals, true};
}

} // namespace Lixel
