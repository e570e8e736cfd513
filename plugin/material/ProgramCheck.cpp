#include "material/ProgramCheck.h"

#include "fit/ShadowParts.h"
#include "material/ShadowParameters.h"
#include "material/SharedParameters.h"

#include <OgrePass.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace Lixel {
namespace {

constexpr std::string_view Prefix = "lixel";
const char* const CasterDepth = "lixelCasterDepth";

struct MapUniform {
    std::string_view name; ///< of the first map; the others' end with the map's index
    int parameter;
};
constexpr std::array MapUniforms{
    MapUniform{"lixelRowU", LP_MAP_ROW_U},         MapUniform{"lixelRowV", LP_MAP_ROW_V},
    MapUniform{"lixelRowW", LP_MAP_ROW_W},         MapUniform{"lixelRowDepth", LP_MAP_ROW_DEPTH},
    MapUniform{"lixelSizeBias", LP_MAP_SIZE_BIAS}, MapUniform{"lixelRowShare", LP_MAP_ROW_SHARE},
};

/// In a script: the parameter's index in the upper 16 bits, the light's place in the pass below.
constexpr int LightBits = 16;
constexpr std::size_t LightMask = 0xFFFF;

std::string scriptNumber(int parameter) {
    return std::to_string(parameter << LightBits);
}

/// The parameter that a uniform of this name takes from the light, if it takes one.
std::optional<int> lightParameterOf(std::string_view uniform) {
    if (uniform == "lixelSplitDepths") return LP_SPLIT_DEPTHS;
    for (const MapUniform& known : MapUniforms) {
        if (!uniform.starts_with(known.name)) continue;
        const std::string_view map = uniform.substr(known.name.size());
        if (map.empty()) return known.parameter;
        if (map.size() == 1 && map[0] >= '0' &&
            map[0] < '0' + static_cast<char>(ShadowParts::Capacity))
            return known.parameter + LP_MAP_STEP * (map[0] - '0');
    }
    return std::nullopt;
}

/// The index of the map that a parameter is of.
int mapOf(int parameter) {
    return (parameter - LP_MAP_ROW_U) / LP_MAP_STEP;
}

bool isMapParameter(int parameter) {
    return std::any_of(MapUniforms.begin(), MapUniforms.end(), [&](const MapUniform& known) {
        return parameter == known.parameter + LP_MAP_STEP * mapOf(parameter);
    });
}

bool isLightParameter(int parameter) {
    return parameter == LP_CASTER_DEPTH || parameter == LP_SPLIT_DEPTHS ||
           isMapParameter(parameter);
}

/// Whether a number lies where Lixel's parameters do.
bool isInRange(int parameter) {
    return parameter >= LP_MAP_ROW_U &&
           parameter < LP_MAP_ROW_U + LP_MAP_STEP * static_cast<int>(ShadowParts::Capacity);
}

using Automatic = Ogre::GpuProgramParameters::AutoConstantEntry;

bool isLightCustom(const Automatic* automatic) {
    return automatic != nullptr &&
           automatic->paramType == Ogre::GpuProgramParameters::ACT_LIGHT_CUSTOM;
}

/// Of a uniform that has one of Lixel's names; empty where it is bound as it should be.
std::string wrongBindingOf(const std::string& uniform, const Automatic* automatic,
                           const Ogre::GpuProgramParameters& parameters) {
    const char* const set = SharedParameters::setOf(uniform);
    if (set != nullptr && parameters.isUsingSharedParameters(set)) return {};
    const std::optional<int> parameter = lightParameterOf(uniform);
    if (parameter && isLightCustom(automatic) &&
        static_cast<int>(automatic->data >> LightBits) == *parameter)
        return {};
    if (!parameter && set == nullptr) return {}; // a name of the application's own
    return "'" + uniform + "' is " +
           (isLightCustom(automatic) ? "bound to light_custom " + std::to_string(automatic->data)
                                     : std::string("not bound")) +
           ": it takes `" +
           (parameter ? "param_named_auto " + uniform + " light_custom " + scriptNumber(*parameter)
                      : std::string("shared_params_ref ") + set) +
           "`";
}

/// Of any other uniform: a number that was meant to be one of Lixel's.
std::string wrongNumberOf(const std::string& uniform, const Automatic* automatic) {
    if (!isLightCustom(automatic)) return {};
    const int parameter = static_cast<int>(automatic->data >> LightBits);
    const int low = static_cast<int>(automatic->data & LightMask);
    const std::string bound =
        "'" + uniform + "' is bound to light_custom " + std::to_string(automatic->data);
    if (parameter == 0 && isInRange(low) && isLightParameter(low))
        return bound + ", which is parameter 0 of light " + std::to_string(low) +
               ": Lixel's parameter " + std::to_string(low) + " is light_custom " +
               scriptNumber(low);
    if (isInRange(parameter) && !isLightParameter(parameter))
        return bound + ", parameter " + std::to_string(parameter) + ": there is none of that index";
    return {};
}

template <typename Visit>
void forPrograms(const Ogre::Pass& pass, const Visit& visit) {
    if (pass.hasVertexProgram()) visit(*pass.getVertexProgramParameters());
    if (pass.hasFragmentProgram()) visit(*pass.getFragmentProgramParameters());
}

} // namespace

std::vector<std::string> findWrongBindings(const Ogre::GpuProgramParameters& parameters) {
    std::vector<std::string> wrong;
    if (!parameters.hasNamedParameters()) return wrong;
    for (const auto& [name, definition] : parameters.getConstantDefinitions().map) {
        const Automatic* const automatic = parameters.findAutoConstantEntry(name);
        std::string line = std::string_view(name).starts_with(Prefix)
                               ? wrongBindingOf(name, automatic, parameters)
                               : wrongNumberOf(name, automatic);
        if (!line.empty()) wrong.push_back(std::move(line));
    }
    return wrong;
}

bool writesCasterDepth(const Ogre::Pass& pass) {
    if (!pass.hasVertexProgram()) return false;
    const Ogre::GpuProgramParameters& parameters = *pass.getVertexProgramParameters();
    return parameters.hasNamedParameters() &&
           parameters._findNamedConstantDefinition(CasterDepth) != nullptr;
}

std::size_t mapsRead(const Ogre::Pass& pass, std::size_t light) {
    std::size_t maps = 0;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        for (const Automatic& automatic : parameters.getAutoConstants()) {
            if (!isLightCustom(&automatic) || (automatic.data & LightMask) != light) continue;
            const int parameter = static_cast<int>(automatic.data >> LightBits);
            if (isInRange(parameter) && isMapParameter(parameter))
                maps = std::max(maps, static_cast<std::size_t>(mapOf(parameter)) + 1);
        }
    });
    return maps;
}

bool readsModulativeMap(const Ogre::Pass& pass) {
    bool reads = false;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        reads |= parameters.isUsingSharedParameters(SharedParameters::setOf("lixelLight"));
    });
    return reads;
}

} // namespace Lixel
