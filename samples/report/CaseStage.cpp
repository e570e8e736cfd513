#include "report/CaseStage.h"

#include "common/OracleView.h"

namespace Lixel::Samples {
namespace {

ShadowOracle oracleOf(Stage& stage, const SampleScene& scene) {
    stage.show(scene);
    return ShadowOracle(collectTriangles(stage.sceneManager()));
}

/// The same maps, with all texels so far to the side.
std::vector<EmulatedMap> shifted(std::vector<EmulatedMap> maps, const Eigen::Vector2d& texels) {
    for (EmulatedMap& map : maps) {
        const Eigen::Vector2d ndc =
            2.0 * texels.cwiseQuotient(Eigen::Vector2d(map.width, map.height));
        map.clipFromWs.topRows<2>() += ndc * map.clipFromWs.row(3);
    }
    return maps;
}

} // namespace

CaseStage::CaseStage(const SampleScene& scene, const TableOptions& options)
    : mWidth(options.width),
      mHeight(options.height),
      mMapSize(options.mapSize),
      mShifts(options.shifts),
      mReach(static_cast<double>(scene.shadowDistance)),
      mStage({.headless = true, .width = options.width, .height = options.height}),
      mOracle(oracleOf(mStage, scene)),
      mEmulation(mOracle, casterFaces(mStage.sceneManager())),
      mCapture(mStage) {}

void CaseStage::setView(const SampleView& view) {
    mStage.setView(view);
    mEmulation.setView(oracleView(mStage.camera(), mWidth, mHeight, mReach, origin()));
}

void CaseStage::setLight(const SampleLight& light) {
    mStage.setLight(light);
    mEmulation.setLight(oracleLight(mStage.light(), origin()));
}

ClassificationError CaseStage::emulate(const NamedSetup& setup) {
    const std::vector<EmulatedMap> maps = mCapture.capture(setup, mMapSize, mReach, origin());
    // From -1/2 to 1/2, evenly; 0 of one.
    const auto shift = [this](int i) { return (2 * i + 1) / (2.0 * mShifts) - 0.5; };
    const auto errorAt = [&](int place) {
        const Eigen::Vector2d texels(shift(place % mShifts), shift(place / mShifts));
        return mEmulation.error(shifted(maps, texels));
    };
    ClassificationError mean = errorAt(0);
    const int places = mShifts * mShifts;
    for (int place = 1; place < places; ++place) {
        const ClassificationError one = errorAt(place);
        mean.error += one.error;
        mean.acne += one.acne;
        mean.leak += one.leak;
    }
    for (double* const percent : {&mean.error, &mean.acne, &mean.leak})
        *percent /= places;
    return mean;
}

std::vector<std::uint8_t> CaseStage::draw(const NamedSetup& setup) {
    mCapture.begin(setup, mMapSize, mReach, origin());
    return mCapture.nextVisibility();
}

} // namespace Lixel::Samples
