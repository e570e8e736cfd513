#include "setup/CascadesShadowCameraSetup.h"

#include "fit/parts/CascadeDivision.h"
#include "fit/parts/CascadeMemory.h"
#include "setup/DivisionMemory.h"
#include "setup/ShadowCameraSetups.h"
#include "setup/StillLight.h"

#include <OgreException.h>
#include <OgreShadowCameraSetupPSSM.h>

#include <algorithm>

namespace Lixel {
namespace {

/// What slices remember beside.
struct SliceMemory : DivisionMemory {
    void addMemory(Fingerprint& memory) const override {
        memory.add(cascades.nearest);
        memory.add(cascades.farthest);
        addFrame(cascades.view.fingerprint, memory);
        addVector(cascades.view.wsEye, memory);
        memory.add(cascades.view.vsReceiverNear);
        memory.add(cascades.change);
        const StripMemory& strips = cascades.strips;
        addVector(strips.wsDirection, memory);
        for (const double share : strips.shares)
            memory.add(share);
        memory.add(std::uint64_t{strips.count});
        memory.add(strips.change);
        memory.add(std::uint64_t{strips.next});
    }

    CascadeMemory cascades;
    CascadeScratch scratch;
    std::vector<double> vsSplits;
};

} // namespace

CascadesShadowCameraSetup::CascadesShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& technique,
                                                     const CascadeOptions& options)
    : FittedShadowCameraSetup("Cascades", CascadeOptions::declared(), &mOptions),
      mTechnique(std::dynamic_pointer_cast<const FittedShadowCameraSetup>(technique)) {
    const char* wrong = nullptr;
    if (!technique)
        wrong = "technique: there is none in a null pointer";
    else if (!mTechnique)
        wrong = "technique: cascades are made of one of Lixel's setups, and this is another";
    else if (dynamic_cast<const CascadesShadowCameraSetup*>(mTechnique.get()) != nullptr)
        wrong = "technique: cascades are not made of cascades";
    if (wrong != nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, wrong, "CascadesShadowCameraSetup");
    setOptions(options);
}

std::shared_ptr<CascadesShadowCameraSetup>
CascadesShadowCameraSetup::create(const CascadeOptions& options) {
    return create(OptimalShadowCameraSetup::create(), options);
}

std::shared_ptr<CascadesShadowCameraSetup>
CascadesShadowCameraSetup::create(const Ogre::PSSMShadowCameraSetup* pssm,
                                  const Ogre::ShadowCameraSetupPtr& technique) {
    const char* const function = "CascadesShadowCameraSetup::create";
    if (pssm == nullptr)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "pssm: there is none in a null pointer",
                    function);
    CascadeOptions options;
    std::vector<double>& depths = options.vsSplitDepths;
    depths.assign(pssm->getSplitPoints().begin(), pssm->getSplitPoints().end());
    if (depths.size() < 3)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "pssm: it has no slices yet; call calculateSplitPoints or setSplitPoints first",
                    function);
    options.splitPadding = static_cast<double>(pssm->getSplitPadding());
    try {
        checkOptions(CascadeOptions::declared(), &options);
    } catch (const Ogre::InvalidParametersException& wrong) {
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "pssm: " + wrong.getDescription(),
                    function);
    }
    // The first slice begins where the view does, and the last one ends where shadows do.
    depths.pop_back();
    depths.erase(depths.begin());
    auto cascades = create(technique ? technique : OptimalShadowCameraSetup::create(), options);
    cascades->mServesOgresReceivers = true;
    return cascades;
}

void CascadesShadowCameraSetup::setOptions(const CascadeOptions& options) {
    checkOptions(CascadeOptions::declared(), &options);
    mOptions = options;
}

void CascadesShadowCameraSetup::setSplitDepths(const std::vector<Ogre::Real>& depths) {
    CascadeOptions options = mOptions;
    options.vsSplitDepths.assign(depths.begin(), depths.end());
    setOptions(options);
}

ShadowFit CascadesShadowCameraSetup::fit(const ShadowProblem& problem,
                                         FitState& state) const noexcept {
    return fitAs(*mTechnique, problem, state);
}

std::size_t CascadesShadowCameraSetup::mapsOfSun(std::size_t maps) const noexcept {
    const std::size_t depths = mOptions.vsSplitDepths.size();
    return depths == 0 ? maps : std::min(maps, depths + 1);
}

std::unique_ptr<DivisionMemory> CascadesShadowCameraSetup::makeDivisionMemory() const {
    return std::make_unique<SliceMemory>();
}

LightPartition CascadesShadowCameraSetup::divide(const ShadowProblem& problem, std::size_t maps,
                                                 DivisionMemory& memory) const noexcept {
    auto& own = static_cast<SliceMemory&>(memory);
    const auto divided = [&](const ShadowProblem& whole) {
        double vsPadding = mOptions.splitPadding;
        if (mServesOgresReceivers) vsPadding = std::max(vsPadding, 2.0 * vsNearOf(problem.viewer));
        return divideView(whole, maps, mOptions, vsPadding, own.cascades, own.scratch, own.vsSplits,
                          [this](const ShadowProblem& part, FitState& state) {
                              return fitAs(*mTechnique, part, state);
                          });
    };
    if (!needsParts(problem.light)) return divided(problem);
    const LightPartition parts = FittedShadowCameraSetup::divide(problem, maps, memory);
    if (parts.count != 1 || maps == 1) return parts;
    // One cone serves the lamp, and would leave maps over.
    LightPartition shared = divided(problemOf(problem, parts.parts.front()));
    shared.servesAll = parts.servesAll;
    return shared;
}

} // namespace Lixel
