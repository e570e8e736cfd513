#include "report/CaseStage.h"

#include "common/OracleView.h"

namespace Lixel::Samples {
namespace {

ShadowOracle oracleOf(Stage& stage, const SampleScene& scene) {
    stage.show(scene);
    return ShadowOracle(collectTriangles(stage.sceneManager()));
}

} // namespace

CaseStage::CaseStage(const SampleScene& scene, const TableOptions& options)
    : mWidth(options.width),
      mHeight(options.height),
      mMapSize(options.mapSize),
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
    return mEmulation.error(mCapture.capture(setup, mMapSize, mReach, origin()));
}

std::vector<std::uint8_t> CaseStage::draw(const NamedSetup& setup) {
    mCapture.begin(setup, mMapSize, mReach, origin());
    return mCapture.nextVisibility();
}

} // namespace Lixel::Samples
