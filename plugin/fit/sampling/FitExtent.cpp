#include "fit/sampling/FitExtent.h"

#include "fit/sampling/TexelExtent.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>

namespace Lixel {

FitExtent::FitExtent(const ShadowFit& fit, const LightImage& image, int mapWidth, int mapHeight) {
    const std::array<double, 3> scale = {mapWidth / 2.0, mapHeight / 2.0, 1.0};
    for (const Eigen::Index row : {0, 1, 2}) {
        const Vec4 clip = fit.clipFromLight.row(row < 2 ? row : 3);
        mMapFromOriented.row(row) =
            scale[static_cast<std::size_t>(row)] *
            Vec3(clip.x(), clip.y(), image.directional() ? clip.w() : -clip.z());
    }
}

double FitExtent::operator()(const ViewSample& sample) const {
    const Vec3 map = mMapFromOriented * Vec3(sample.liPoint.x(), sample.liPoint.y(), 1.0);
    if (!(map.z() > 0.0)) return std::numeric_limits<double>::infinity();
    // p = (x, y) / w has the derivative (d(x, y) - p dw) / w.
    const Vec2 point = map.head<2>() / map.z();
    const Eigen::Matrix2d mapFromLi = (mMapFromOriented.topLeftCorner<2, 2>() -
                                       point * mMapFromOriented.bottomLeftCorner<1, 2>()) /
                                      map.z();
    const Eigen::Matrix2d liFromMap = mapFromLi.inverse();
    return std::pow(liFromMap.norm(), LightPower) *
           std::pow((sample.ndcFromLi * liFromMap).norm(), PicturePower);
}

} // namespace Lixel
