#include "setup/CascadesShadowCameraSetup.h"

#include "setup/DivisionMemory.h"
#include "setup/OptimalShadowCameraSetup.h"

#include <OgreException.h>

#include <algorithm>
#include <cmath>

namespace Lixel {
namespace {

/// Relative rounding of a near plane's depth that comes from a projection matrix in float.
constexpr double NearRounding = 0x1p-16;

/// Depth of the near plane on the viewer's axis; 0 where it is not in front of the viewer.
double vsNearOf(const Mat4& clipFromView) {
    const Eigen::RowVector4d plane = clipFromView.row(2) + clipFromView.row(3);
    const double depth = plane[3] / plane[2];
    return std::isfinite(depth) ? std::max(depth, 0.0) : 0.0;
}

} // namespace

CascadesShadowCameraSetup::CascadesShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& technique)
    : mTechnique(std::dynamic_pointer_cast<const FittedShadowCameraSetup>(technique)) {
    if (!mTechnique || dynamic_cast<const CascadesShadowCameraSetup*>(mTechnique.get()) != nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "technique: cascades are made of one of Lixel's setups, but not of cascades",
                    "CascadesShadowCameraSetup");
}

std::shared_ptr<CascadesShadowCameraSetup> CascadesShadowCameraSetup::create() {
    return create(OptimalShadowCameraSetup::create());
}

void CascadesShadowCameraSetup::setUniformity(Ogre::Real uniformity) {
    if (!(uniformity >= 0) || !(uniformity <= 1))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "uniformity: it must be between 0 (logarithmic) and 1 (equal depths)",
                    "CascadesShadowCameraSetup::setUniformity");
    mOptions.uniformity = uniformity;
}

void CascadesShadowCameraSetup::setSplitDepths(const std::vector<Ogre::Real>& depths) {
    Ogre::Real last = 0;
    for (const Ogre::Real depth : depths) {
        if (!(depth > last) || !std::isfinite(depth))
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "depths: they must be positive, finite and ascending",
                        "CascadesShadowCameraSetup::setSplitDepths");
        last = depth;
    }
    mSplitDepths = depths;
}

void CascadesShadowCameraSetup::setSplitPadding(Ogre::Real worldUnits) {
    if (!(worldUnits >= 0) || !std::isfinite(worldUnits))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "worldUnits: the padding must be finite and not negative",
                    "CascadesShadowCameraSetup::setSplitPadding");
    mSplitPadding = worldUnits;
}

ShadowFit CascadesShadowCameraSetup::fit(const ShadowProblem& problem,
                                         FitState& state) const noexcept {
    return fitAs(*mTechnique, problem, state);
}

std::size_t CascadesShadowCameraSetup::mapsOfSun(std::size_t maps) const noexcept {
    return mSplitDepths.empty() ? maps : std::min(maps, mSplitDepths.size() + 1);
}

LightPartition CascadesShadowCameraSetup::divide(const ShadowProblem& problem, std::size_t maps,
                                                 DivisionMemory& memory) const noexcept {
    if (needsParts(problem.light)) return FittedShadowCameraSetup::divide(problem, maps, memory);
    if (mSplitDepths.empty())
        cascadeSplits(problem, static_cast<int>(maps), mOptions, memory.cascades, memory.vsSplits);
    else
        // No slice ends before the viewer sees anything.
        memory.vsSplits.assign(
            std::upper_bound(mSplitDepths.begin(), mSplitDepths.end(),
                             vsNearOf(problem.viewer.clipFromView) * (1.0 + NearRounding)),
            mSplitDepths.end());
    if (memory.vsSplits.size() > maps - 1) memory.vsSplits.resize(maps - 1);
    return sliceView(problem.viewer, problem.light, memory.vsSplits,
                     static_cast<double>(mSplitPadding));
}

} // namespace Lixel
