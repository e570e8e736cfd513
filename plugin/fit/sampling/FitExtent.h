#pragma once

#include "fit/focus/LightImage.h"
#include "fit/problem/ShadowFit.h"
#include "fit/sampling/ViewSamples.h"

namespace Lixel {

/** How large the texels of fits are, by TexelExtent's measure: any technique's, and of several maps
    of one light, whose values may be compared and added. */
class FitExtent {
public:
    /// @param fit that has a map, for the light of `image`
    FitExtent(const ShadowFit& fit, const LightImage& image, int mapWidth, int mapHeight);

    /// What a sample adds to the measure: its mean to the power of MeanPower is comparable with
    /// extents. Not finite where the map has no place for the sample.
    double operator()(const ViewSample& sample) const;

private:
    /// The map, in texels from its middle: rows x, y and w, acting on ℓ.
    Mat3 mMapFromOriented;
};

} // namespace Lixel
