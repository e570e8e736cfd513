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
    return static_cast<const FittedShadowCameraSetup*>(
               static_cast<const Ogre::StringInterface*>(target))
        ->getParameter(Ogre::String(mOption->keyword));
}

void FittedShadowCameraSetup::OptionCommand::doSet(void* target, const Ogre::String& value) {
    static_cast<FittedShadowCameraSetup*>(static_cast<Ogre::StringInterface*>(target))
        ->setParameter(Ogre::String(mOption->keyword), value);
}

struct FittedShadowCameraSetup::OwnedOption {
    const Option* option = nullptr;
    /// The structure that it is a member of.
    void* options = nullptr;
};

FittedShadowCameraSetup::OwnedOption FittedShadowCameraSetup::find(std::string_view keyword) const {
    if (const Option* const own = findOption(mDeclared, keyword)) return {own, mOptions};
    // What is read alone is not changed.
    return {findOption(CommonOptions::declared(), keyword), const_cast<CommonOptions*>(&mCommon)};
}

bool FittedShadowCameraSetup::setParameter(const Ogre::String& keyword, const Ogre::String& value) {
    const OwnedOption found = find(keyword);
    std::string wrong;
    if (found.option != nullptr) {
        wrong = setOption(*found.option, found.options, value);
    } else {
        wrong = "there is no option '" + keyword + "' of " + (mName.empty() ? "this setup" : mName);
        wrong += "; there are: ";
        for (const Option& option : mDeclared) {
            wrong += option.keyword;
            wrong += ", ";
        }
        for (const Option& option : CommonOptions::declared()) {
            wrong += option.keyword;
            wrong += &option == &CommonOptions::declared().back() ? "" : ", ";
        }
    }
    if (!wrong.empty())
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, wrong,
                    "FittedShadowCameraSetup::setParameter");
    return true;
}

Ogre::String FittedShadowCameraSetup::getParameter(const Ogre::String& keyword) const {
    const OwnedOption found = find(keyword);
    return found.option == nullptr ? Ogre::String() : optionText(*found.option, found.options);
}

const Ogre::ParameterList& FittedShadowCameraSetup::getParameters() const {
    // OGRE's dictionary is not part of the setup's state.
    const_cast<FittedShadowCameraSetup*>(this)->declareParameters();
    return StringInterface::getParameters();
}

void FittedShadowCameraSetup::declareParameters() {
    // OGRE keeps a dictionary for each name, which goes with Root, and pointers to commands, which
    // are not its own.
    static std::map<std::string, std::vector<OptionCommand>> all;
    const std::string dictionary = "Lixel/" + mName;
    if (!createParamDictionary(dictionary)) return;
    std::vector<OptionCommand>& commands = all[dictionary];
    if (commands.empty()) {
        for (const Option& option : mDeclared)
            commands.emplace_back(option);
        for (const Option& option : CommonOptions::declared())
            commands.emplace_back(option);
    }
    for (OptionCommand& command : commands)
        getParamDictionary()->addParameter(command.definition(), &command);
}

} // namespace Lixel
