#pragma once

#include "fit/technique/Techniques.h"
#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** The setup of one technique, named by its structure of options.

        light->setCustomShadowCameraSetup(Lixel::XPSMShadowCameraSetup::create({.strength = 1}));

    @tparam Options such as XpsmOptions: what they do is said there
*/
template <TechniqueOptions Options>
class LIXEL_API TechniqueShadowCameraSetup : public FittedShadowCameraSetup {
public:
    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    static std::shared_ptr<TechniqueShadowCameraSetup> create(const Options& options = {}) {
        return std::make_shared<TechniqueShadowCameraSetup>(options);
    }
    /// Use create().
    explicit TechniqueShadowCameraSetup(const Options& options = {})
        : FittedShadowCameraSetup(Options::technique().name, Options::technique().options,
                                  &mOptions) {
        setOptions(options);
    }

    const Options& getOptions() const { return mOptions; }
    /// Sets all of the technique's options; what is not named has its default.
    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    void setOptions(const Options& options) {
        checkOptions(Options::technique().options, &options);
        mOptions = options;
    }

protected:
    ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept override {
        return fitMap(problem, mOptions, state);
    }
    bool dependsOnlyOnOptions() const noexcept override { return true; }

private:
    Options mOptions;
};

/// @}
} // namespace Lixel
