#pragma once

#include "common/Measurement.h"
#include "common/Setups.h"

#include <algorithm>
#include <functional>
#include <span>

namespace Lixel::Samples {

/// Some views of one scene under one light, drawn with a setup and with a baseline.
struct ComparedCase {
    std::string scene;
    std::string light;
    int mapSize = 0;        ///< texels, the same for both
    double error = 0.0;     ///< percent, of the setup
    double baseline = 0.0;  ///< percent, of the baseline
    double halfPixel = 0.0; ///< percent: less than any error that is not 0
    std::string reason;     ///< of the setup's fit
    /// Without any error, that of half a pixel: a mean of logarithms cannot hold a ratio of 0.
    double ratio() const { return std::max(error, halfPixel) / baseline; }
};

/// Paired geometric mean of ratios with its 95 % interval, from the spread of their logarithms.
struct GeometricMean {
    double mean = 1.0;
    double lower = 1.0;
    double upper = 1.0;
    std::size_t count = 0;
};
GeometricMean geometricMean(const std::vector<double>& ratios);

/** Compares two setups over views of a scene, under each of the first `lights` of its lights for
    which there is a map to compare on.

    A case's error is the mean over the views, each with the camera turned a little both ways. The
    map is sized for each case so that the baseline errs between 1 and 5 %: the largest power of
    two, or 1.5 times one, between 32 and 4096 that does. A light for which no size does so is left
    out, and reported through `leftOut`.

    @param stage shows `scene` already
*/
std::vector<ComparedCase> compareSetups(Stage& stage, const SampleScene& scene,
                                        const NamedSetup& setup, const NamedSetup& baseline,
                                        std::size_t lights, std::span<const SampleView> views,
                                        const std::function<void(const std::string&)>& leftOut);

} // namespace Lixel::Samples
