#pragma once

#include "common/MapCapture.h"
#include "report/Table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Samples {

/** One scene on a stage of its own, on which the cases of a table are emulated and drawn.

    Both ways show a new setup's first frame, or of OGRE's setups the first in which they have
    settled, with the same pixels, maps and truth.
*/
class CaseStage {
public:
    /// @exception std::exception where the scene cannot be shown
    CaseStage(const SampleScene& scene, const TableOptions& options);

    void setView(const SampleView& view);
    /// Call setView first.
    void setLight(const SampleLight& light);

    /// What each pixel shows in truth.
    const ShadowTruth& truth() const { return mEmulation.truth(); }
    /// From the maps' matrices alone. Percentages are means over TableOptions::shifts.
    ClassificationError emulate(const NamedSetup& setup);
    /// Of the fits that were emulated last: MapCapture::reason.
    std::string reason() const { return mCapture.reason(); }
    /// The picture: how much of the light each pixel gets, 0 to 255, row 0 at the top.
    std::vector<std::uint8_t> draw(const NamedSetup& setup);

private:
    const Eigen::Vector3d& origin() const { return mOracle.scene().wsOrigin; }

    int mWidth;
    int mHeight;
    int mMapSize;
    int mShifts;
    double mReach; ///< SampleScene::shadowDistance
    Stage mStage;
    ShadowOracle mOracle;
    MapEmulation mEmulation;
    MapCapture mCapture;
};

} // namespace Lixel::Samples
