#include "common/Comparison.h"

#include "common/OracleView.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace Lixel::Samples {
namespace {

constexpr double LeastError = 1.0;    ///< percent
constexpr double GreatestError = 5.0; ///< percent

/// Powers of two, and half way between.
constexpr std::array MapSizes{4096, 3072, 2048, 1536, 1024, 768, 512, 384,
                              256,  192,  128,  96,   64,   48,  32};

/// Turns of the camera, in degrees around y, over which an error is averaged: where a few texels
/// decide, how they happen to lie on an edge would otherwise count for more than their size.
constexpr std::array Turns{-0.4F, 0.4F};

/// Some views under one light. Both setups are compared against one truth, which depends on neither
/// setup nor map.
class Case {
public:
    /// @param light index into the scene's
    Case(Stage& stage, const ShadowOracle& oracle, const SampleScene& scene, std::size_t light,
         std::span<const SampleView> views)
        : mStage(stage) {
        for (const float turn : Turns) {
            for (const SampleView& view : views) {
                mPoses.push_back({view, lightOf(scene, view, light), turn, {}});
                apply(mPoses.back());
                const Eigen::Vector3d& origin = oracle.scene().wsOrigin;
                mPoses.back().truth = oracle.classify(
                    oracleView(stage.camera(), static_cast<int>(stage.window().getWidth()),
                               static_cast<int>(stage.window().getHeight()),
                               static_cast<double>(scene.shadowDistance), origin),
                    oracleLight(stage.light(), origin));
            }
        }
    }

    /// Mean error in percent, over all turns or over the first alone.
    double errorOf(const NamedSetup& setup, int mapSize, bool allTurns) const {
        mStage.setShadowMapSize(mapSize);
        const std::size_t count = allTurns ? mPoses.size() : mPoses.size() / Turns.size();
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            apply(mPoses[i]);
            // A new one for each picture: what a setup keeps of another view is not its error.
            mStage.setShadowSetup(setup.create());
            sum += compareWithTruth(mPoses[i].truth, mStage.drawVisibility()).error;
        }
        return sum / static_cast<double>(count);
    }

    /// Half of the least mean error that is not 0, in percent; 0 where no pixel counts.
    double halfPixel() const {
        std::ptrdiff_t most = 0;
        for (const Pose& pose : mPoses)
            most = std::max(most, std::count_if(pose.truth.pixels.begin(), pose.truth.pixels.end(),
                                                [](PixelClass pixel) {
                                                    return pixel == PixelClass::Lit ||
                                                           pixel == PixelClass::Shadowed;
                                                }));
        return most == 0 ? 0.0 : 50.0 / static_cast<double>(most * std::ssize(mPoses));
    }

private:
    struct Pose {
        SampleView view;
        SampleLight light;
        float turn;
        ShadowTruth truth;
    };

    void apply(const Pose& pose) const {
        mStage.setLight(pose.light);
        mStage.setView(pose.view);
        mStage.camera().getParentSceneNode()->yaw(Ogre::Degree(pose.turn), Ogre::Node::TS_WORLD);
    }

    Stage& mStage;
    std::vector<Pose> mPoses;
};

/// Keeps the last fit's reason.
class ReasonObserver : public ShadowMapObserver {
public:
    ReasonObserver() { addShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override { reason = toString(map.fit.reason); }
    std::string reason;
};

} // namespace

GeometricMean geometricMean(const std::vector<double>& ratios) {
    GeometricMean result;
    result.count = ratios.size();
    if (ratios.empty()) return result;
    const double n = static_cast<double>(ratios.size());
    double sum = 0.0;
    for (const double r : ratios)
        sum += std::log(r);
    const double mean = sum / n;
    double squares = 0.0;
    for (const double r : ratios)
        squares += (std::log(r) - mean) * (std::log(r) - mean);
    // Normal approximation of the mean's distribution.
    const double half = ratios.size() > 1 ? 1.96 * std::sqrt(squares / (n - 1.0) / n) : 0.0;
    result.mean = std::exp(mean);
    result.lower = std::exp(mean - half);
    result.upper = std::exp(mean + half);
    return result;
}

std::vector<ComparedCase> compareSetups(Stage& stage, const SampleScene& scene,
                                        const NamedSetup& setup, const NamedSetup& baseline,
                                        std::size_t lights, std::span<const SampleView> views,
                                        const std::function<void(const std::string&)>& leftOut) {
    const ShadowOracle oracle(collectTriangles(stage.sceneManager()));
    std::vector<ComparedCase> cases;
    ReasonObserver observer;
    for (std::size_t light = 0; light < scene.lights.size(); ++light) {
        if (cases.size() == lights) break;
        const std::string& name = scene.lights[light].name;
        const Case one(stage, oracle, scene, light, views);
        // From large to small. On very coarse maps shadows vanish; the error then only measures the
        // shadowed area.
        ComparedCase best;
        best.scene = scene.name;
        best.light = name;
        for (const int size : MapSizes) {
            // One turn finds the size, all of them confirm it.
            if (one.errorOf(baseline, size, false) < LeastError) continue;
            const double error = one.errorOf(baseline, size, true);
            if (error < LeastError) continue;
            if (error <= GreatestError) {
                best.mapSize = size;
                best.baseline = error;
            }
            break;
        }
        if (best.mapSize == 0) {
            leftOut(scene.name + ", " + name);
            continue;
        }
        best.error = one.errorOf(setup, best.mapSize, true);
        best.halfPixel = one.halfPixel();
        best.reason = observer.reason;
        cases.push_back(best);
    }
    return cases;
}

} // namespace Lixel::Samples
