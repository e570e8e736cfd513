#include "setup/OptionCommand.h"

#include <OgreException.h>

#include <map>
#include <vector>

namespace Lixel {
namespace {

Ogre::ParameterType parameterType(OptionType type) {
    switch (type) {
    case OptionType::Flag:
        return Ogre::PT_BOOL;
    case OptionType::Count:
        return Ogre::PT_INT;
    case OptionType::Number:
        return Ogre::PT_REAL;
    default:
        return Ogre::PT_STRING;
    }
}

} // namespace

Ogre::ParameterDef FittedShadowCameraSetup::OptionCommand::definition() const {
    return {Ogre::String(mOption->keyword),
            Ogre::String(mOption->use) + " (" + describeValues(*mOption) + ")",
            parameterType(mOption->type)};
}

Ogre::String FittedShadowCameraSetup::OptionCommand::doGet(const void* target) const {
    const auto& setup = *static_cast<const FittedShadowCameraSetup*>(
        static_cast<const Ogre::StringInterface*>(target));
    return optionText(*mOption, mIsCommon ? &setup.mCommon : setup.mOptions);
}

void FittedShadowCameraSetup::OptionCommand::doSet(void* target, const Ogre::String& value) {
    auto& setup =
        *static_cast<FittedShadowCameraSetup*>(static_cast<Ogre::StringInterface*>(target));
    const std::string wrong =
        setOption(*mOption, mIsCommon ? &setup.mCommon : setup.mOptions, value);
    if (!wrong.empty())
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, wrong, "Lixel's setParameter");
}

void FittedShadowCameraSetup::declareParameters(std::string_view name) {
    // OGRE keeps a dictionary for each name, which goes with Root, and pointers to commands, which
    // are not its own.
    static std::map<std::string, std::vector<OptionCommand>, std::less<>> all;
    const std::string dictionary = "Lixel/" + std::string(name);
    if (!createParamDictionary(dictionary)) return;
    std::vector<OptionCommand>& commands = all[dictionary];
    if (commands.empty()) {
        for (const Option& option : mDeclared)
            commands.emplace_back(option, false);
        for (const Option& option : CommonOptions::declared())
            commands.emplace_back(option, true);
    }
    for (OptionCommand& command : commands)
        getParamDictionary()->addParameter(command.definition(), &command);
}

} // namespace Lixel
