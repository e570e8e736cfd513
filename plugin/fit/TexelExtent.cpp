#include "fit/TexelExtent.h"

#include "fit/Warp.h"

#include <Eigen/LU>

namespace Lixel {

void TexelExtent::reset(const std::vector<ViewSample>& samples, const Polygon2& hull,
                        const Vec2& centre) {
    mCentre = centre;
    mHull = hull;
    mCount = static_cast<Eigen::Index>(samples.size());
    for (Eigen::ArrayXd* column : {&mX, &mY, &mXx, &mXy, &mYx, &mYy})
        if (column->size() < mCount) column->resize(mCount);
    for (Eigen::Index i = 0; i < mCount; ++i) {
        const ViewSample& sample = samples[static_cast<std::size_t>(i)];
        mX[i] = sample.liPoint.x() - centre.x();
        mY[i] = sample.liPoint.y() - centre.y();
        mXx[i] = sample.ndcFromLi(0, 0);
        mXy[i] = sample.ndcFromLi(1, 0);
        mYx[i] = sample.ndcFromLi(0, 1);
        mYy[i] = sample.ndcFromLi(1, 1);
    }
}

double TexelExtent::operator()(const Vec2& warp) {
    warpPolygon(mHull, mCentre, warp, mWarped);
    const OrientedRectangle map = smallestRectangle(mWarped);
    // One texel's steps along the map's axes in the warped image, up to the map's size.
    const Vec2 u = (map.max.x() - map.min.x()) * Vec2(std::cos(map.angle), std::sin(map.angle));
    const Vec2 v = (map.max.y() - map.min.y()) * Vec2(-std::sin(map.angle), std::cos(map.angle));
    const double wu = warp.dot(u);
    const double wv = warp.dot(v);
    // p = q / D with D = 1 + w . q has the derivative (I - q w^T / D) / D, whose inverse is
    // D (I + q w^T): nothing is divided.
    const auto x = mX.head(mCount);
    const auto y = mY.head(mCount);
    const auto ux = u.x() + x * wu;
    const auto uy = u.y() + y * wu;
    const auto vx = v.x() + x * wv;
    const auto vy = v.y() + y * wv;
    const auto inLight = ux.square() + uy.square() + vx.square() + vy.square();
    const auto xx = mXx.head(mCount);
    const auto xy = mXy.head(mCount);
    const auto yx = mYx.head(mCount);
    const auto yy = mYy.head(mCount);
    const auto inPicture = (xx * ux + yx * uy).square() + (xy * ux + yy * uy).square() +
                           (xx * vx + yx * vy).square() + (xy * vx + yy * vy).square();
    const auto denominator = 1.0 + warp.x() * x + warp.y() * y;
    return (denominator * (inLight * inPicture).sqrt().sqrt()).sum() / static_cast<double>(mCount);
}

} // namespace Lixel
