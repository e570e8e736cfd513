#include "fit/TexelExtent.h"

#include "fit/Warp.h"

#include <Eigen/LU>

namespace Lixel {

void TexelExtent::reset(const std::vector<ViewSample>& samples, const Polygon2& hull,
                        const Vec2& centre) {
    mCentre = centre;
    mHull = hull;
    for (std::vector<double>* column : {&mX, &mY, &mXx, &mXy, &mYx, &mYy})
        column->clear();
    for (const ViewSample& sample : samples) {
        const Vec2 q = sample.liPoint - centre;
        const Eigen::Matrix2d ndcFromLi = sample.liFromNdc.inverse();
        mX.push_back(q.x());
        mY.push_back(q.y());
        mXx.push_back(ndcFromLi(0, 0));
        mXy.push_back(ndcFromLi(1, 0));
        mYx.push_back(ndcFromLi(0, 1));
        mYy.push_back(ndcFromLi(1, 1));
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
    double sum = 0.0;
    for (std::size_t i = 0; i < mX.size(); ++i) {
        // p = q / D with D = 1 + w . q has the derivative (I - q w^T / D) / D, whose inverse is
        // D (I + q w^T): nothing is divided.
        const double denominator = 1.0 + warp.x() * mX[i] + warp.y() * mY[i];
        const double ux = u.x() + mX[i] * wu;
        const double uy = u.y() + mY[i] * wu;
        const double vx = v.x() + mX[i] * wv;
        const double vy = v.y() + mY[i] * wv;
        const double inLight = ux * ux + uy * uy + vx * vx + vy * vy;
        const double inPictureU = (mXx[i] * ux + mYx[i] * uy) * (mXx[i] * ux + mYx[i] * uy) +
                                  (mXy[i] * ux + mYy[i] * uy) * (mXy[i] * ux + mYy[i] * uy);
        const double inPictureV = (mXx[i] * vx + mYx[i] * vy) * (mXx[i] * vx + mYx[i] * vy) +
                                  (mXy[i] * vx + mYy[i] * vy) * (mXy[i] * vx + mYy[i] * vy);
        sum += denominator * std::sqrt(std::sqrt(inLight * (inPictureU + inPictureV)));
    }
    return sum / static_cast<double>(mX.size());
}

} // namespace Lixel
