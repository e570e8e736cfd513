#pragma once

#include "setup/FittedShadowCameraSetup.h"

namespace Lixel {

/// One option of a setup, as OGRE's StringInterface reads and sets it.
class FittedShadowCameraSetup::OptionCommand : public Ogre::ParamCommand {
public:
    explicit OptionCommand(const Option& option) : mOption(&option) {}

    Ogre::ParameterDef definition() const;
    Ogre::String doGet(const void* target) const override;
    void doSet(void* target, const Ogre::String& value) override;

private:
    const Option* mOption;
};

} // namespace Lixel
