#include "material/ProgramCheck.h"

#include "fit/parts/LightPartition.h"
#include "material/ShadowParameters.h"
#include "material/SharedParameters.h"
#include "scene/OgreVersions.h"

#include <OgrePass.h>
#include <OgreTexture.h>
#include <OgreTextureUnitState.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace Lixel {
namespace {

constexpr std::string_view Prefix = "lixel";
const char* const CasterDepth = "lixelCasterDepth";
const std::string Sampler = "shadowMap";
const char* const MapIsIn = "OGRE puts that map into";

struct MapUniform {
    std::string_view name; ///< of the first map; the others' end with the map's index
    int parameter;
};
constexpr std::array MapUniforms{
    MapUniform{"lixelRowU", LP_MAP_ROW_U},         MapUniform{"lixelRowV", LP_MAP_ROW_V},
    MapUniform{"lixelRowW", LP_MAP_ROW_W},         MapUniform{"lixelRowDepth", LP_MAP_ROW_DEPTH},
    MapUniform{"lixelSizeBias", LP_MAP_SIZE_BIAS}, MapUniform{"lixelRowShare", LP_MAP_ROW_SHARE},
};

/// The programs Lixel/ShadowMaps2 and so on are for up to so many.
constexpr std::array<std::size_t, 4> NumbersOfMaps{2, 3, 4, 6};

/// So many uniforms that are not bound were not forgotten one by one: a map has six.
constexpr std::size_t ManyUnbound = 4;

/// The index at the end of a name of several maps' uniforms.
std::optional<std::size_t> mapIndexIn(std::string_view uniform) {
    if (uniform.empty() || uniform.back() < '0' || uniform.back() > '9') return std::nullopt;
    return static_cast<std::size_t>(uniform.back() - '0');
}

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
        const std::optional<std::size_t> index = mapIndexIn(map);
        if (map.size() == 1 && index && *index < LightPartition::Capacity)
            return known.parameter + LP_MAP_STEP * static_cast<int>(*index);
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
           parameter < LP_MAP_ROW_U + LP_MAP_STEP * static_cast<int>(LightPartition::Capacity);
}

using Automatic = Ogre::GpuProgramParameters::AutoConstantEntry;

bool isLightCustom(const Automatic* automatic) {
    return automatic != nullptr &&
           automatic->paramType == Ogre::GpuProgramParameters::ACT_LIGHT_CUSTOM;
}

/// The parameter of a light that a uniform is bound to.
int lightParameterOf(const Automatic& lightCustom) {
    return static_cast<int>(lightCustom.data >> LightBits);
}

/// Of a uniform that has one of Lixel's names; empty where it is bound as it should be.
std::string wrongBindingOf(const std::string& uniform, const Automatic* automatic,
                           const Ogre::GpuProgramParameters& parameters) {
    const char* const set = SharedParameters::setOf(uniform);
    if (set != nullptr && parameters.isUsingSharedParameters(set)) return {};
    const std::optional<int> parameter = lightParameterOf(uniform);
    if (parameter && isLightCustom(automatic) && lightParameterOf(*automatic) == *parameter)
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
    const int parameter = lightParameterOf(*automatic);
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

/// Of a program for several maps in which these uniforms are not bound.
std::string inheritanceInstead(const std::vector<std::string_view>& unbound) {
    std::size_t maps = 0;
    for (const std::string_view uniform : unbound)
        maps = std::max(maps, mapIndexIn(uniform).value_or(0) + 1);
    const std::size_t parent = mapsOfProgramFor(maps).value_or(NumbersOfMaps.back());
    const std::string first(unbound.front());
    return "'" + first + "' and " + std::to_string(unbound.size() - 1) +
           " more of its uniforms are not bound: let it inherit Lixel/ShadowMaps" +
           std::to_string(parent) +
           ", which binds them all (`fragment_program NAME glsl : " + "Lixel/ShadowMaps" +
           std::to_string(parent) + "`)";
}

/// The texture unit that a sampler of this name is set to; none where there is no such sampler.
std::optional<std::size_t> unitOf(const std::string& sampler,
                                  const Ogre::GpuProgramParameters& parameters) {
    const Ogre::GpuConstantDefinition* const definition =
        parameters._findNamedConstantDefinition(sampler);
    if (definition == nullptr || !definition->isSampler()) return std::nullopt;
    return static_cast<std::size_t>(textureUnitOf(parameters, *definition));
}

/// Of a pass's texture units, which hold shadow maps, in their order.
std::vector<std::size_t> mapUnitsOf(const Ogre::Pass& pass) {
    std::vector<std::size_t> units;
    for (std::size_t i = 0; i < pass.getTextureUnitStates().size(); ++i)
        if (pass.getTextureUnitStates()[i]->getContentType() ==
            Ogre::TextureUnitState::CONTENT_SHADOW)
            units.push_back(i);
    return units;
}

/// OGRE numbers units that have no name in their script.
bool isUnnamed(const Ogre::TextureUnitState& unit) {
    return unit.getName().find_first_not_of("0123456789") == std::string::npos;
}

bool isOneTexel(const Ogre::TextureUnitState& unit) {
    const Ogre::TexturePtr& texture = unit._getTexturePtr();
    return texture && texture->getWidth() == 1 && texture->getHeight() == 1;
}

template <typename Visit>
void forPrograms(const Ogre::Pass& pass, const Visit& visit) {
    if (pass.hasVertexProgram()) visit(*pass.getVertexProgramParameters());
    if (pass.hasFragmentProgram()) visit(*pass.getFragmentProgramParameters());
}

/// Slips with the unit DiffuseMap, which is the one of that index.
void addSlipsWithDiffuseMap(const Ogre::Pass& pass, std::size_t index,
                            std::vector<std::string>& wrong) {
    const auto& states = pass.getTextureUnitStates();
    const Ogre::TextureUnitState& diffuseMap = *states[index];
    if (!diffuseMap.getTextureName().empty()) {
        if (isOneTexel(diffuseMap))
            wrong.push_back("texture '" + diffuseMap.getTextureName() +
                            "' has one texel, and a program cannot tell that from no texture, "
                            "which is white: make it larger, or say diffuse and ambient");
        return;
    }
    for (const Ogre::TextureUnitState* other : states)
        if (isUnnamed(*other) && !other->getTextureName().empty())
            wrong.push_back("texture '" + other->getTextureName() +
                            "' is in a unit without a name, which nothing reads: write "
                            "`texture_unit DiffuseMap`");
}

} // namespace

std::optional<std::size_t> mapsOfProgramFor(std::size_t maps) {
    const auto* const found = std::ranges::lower_bound(NumbersOfMaps, maps);
    return found != NumbersOfMaps.end() ? std::optional(*found) : std::nullopt;
}

std::vector<std::string> findWrongBindings(const Ogre::GpuProgramParameters& parameters) {
    std::vector<std::string> wrong;
    if (!parameters.hasNamedParameters()) return wrong;
    const auto& uniforms = parameters.getConstantDefinitions().map;
    const auto isUnbound = [&](const std::string& name) {
        return lightParameterOf(name) && mapIndexIn(name) &&
               parameters.findAutoConstantEntry(name) == nullptr;
    };
    std::vector<std::string_view> unbound;
    for (const auto& [name, definition] : uniforms)
        if (isUnbound(name)) unbound.push_back(name);
    const bool isForgotten = unbound.size() >= ManyUnbound;
    if (isForgotten) wrong.push_back(inheritanceInstead(unbound));
    for (const auto& [name, definition] : uniforms) {
        if (isForgotten && isUnbound(name)) continue;
        const Automatic* const automatic = parameters.findAutoConstantEntry(name);
        std::string line = std::string_view(name).starts_with(Prefix)
                               ? wrongBindingOf(name, automatic, parameters)
                               : wrongNumberOf(name, automatic);
        if (!line.empty()) wrong.push_back(std::move(line));
    }
    return wrong;
}

std::vector<std::string> findWrongUnits(const Ogre::Pass& pass, bool integrated) {
    std::vector<std::string> wrong;
    const auto check = [&](const std::string& sampler, std::size_t expected, const char* what) {
        forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
            const std::optional<std::size_t> unit = unitOf(sampler, parameters);
            if (unit && *unit != expected)
                wrong.push_back("'" + sampler + "' is texture unit " + std::to_string(*unit) +
                                ", and " + what + " unit " + std::to_string(expected) +
                                ": write units of your own behind Lixel's");
        });
    };
    const auto& states = pass.getTextureUnitStates();
    if (integrated) {
        const std::vector<std::size_t> units = mapUnitsOf(pass);
        if (!units.empty()) check(Sampler, units.front(), MapIsIn);
        for (std::size_t map = 0; map < units.size(); ++map)
            check(Sampler + std::to_string(map), units[map], MapIsIn);
        const std::size_t read = mapsRead(pass, 0);
        if (!units.empty() && read > units.size())
            wrong.push_back("its program reads " + std::to_string(read) +
                            " shadow maps, and it has " + std::to_string(units.size()) +
                            " texture units of content_type shadow: inherit "
                            "Lixel/Surface/Integrated/Maps" +
                            std::to_string(mapsOfProgramFor(read).value_or(NumbersOfMaps.back())));
    } else {
        // The first: what OGRE lends a receiver of the surface's comes behind its own.
        const auto own = std::ranges::find(states, "ShadowMap", &Ogre::TextureUnitState::getName);
        if (own != states.end() && mapsRead(pass, 0) > 0)
            check(Sampler, static_cast<std::size_t>(own - states.begin()), "ShadowMap is");
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i]->getName() != "DiffuseMap") continue;
        check("diffuseMap", i, "DiffuseMap is");
        addSlipsWithDiffuseMap(pass, i, wrong);
    }
    return wrong;
}

bool writesCasterDepth(const Ogre::Pass& pass) {
    if (!pass.hasVertexProgram()) return false;
    const Ogre::GpuProgramParameters& parameters = *pass.getVertexProgramParameters();
    if (parameters.hasNamedParameters() &&
        parameters._findNamedConstantDefinition(CasterDepth) != nullptr)
        return true;
    const auto isLixels = [](const Automatic& automatic) {
        return isLightCustom(&automatic) && isInRange(lightParameterOf(automatic));
    };
    const auto& automatics = parameters.getAutoConstants();
    return std::any_of(automatics.begin(), automatics.end(), isLixels);
}

std::size_t mapsRead(const Ogre::Pass& pass, std::size_t light) {
    std::size_t maps = 0;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        for (const Automatic& automatic : parameters.getAutoConstants()) {
            if (!isLightCustom(&automatic) || (automatic.data & LightMask) != light) continue;
            const int parameter = lightParameterOf(automatic);
            if (isInRange(parameter) && isMapParameter(parameter))
                maps = std::max(maps, static_cast<std::size_t>(mapOf(parameter)) + 1);
        }
    });
    return maps;
}

bool hasMapUnits(const Ogre::Pass& pass) {
    return !mapUnitsOf(pass).empty();
}

bool readsMaps(const Ogre::Pass& pass) {
    return mapsRead(pass, 0) > 0 || readsModulativeMap(pass);
}

bool readsModulativeMap(const Ogre::Pass& pass) {
    bool reads = false;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        reads |= parameters.isUsingSharedParameters(SharedParameters::setOf("lixelLight"));
    });
    return reads;
}

} // namespace Lixel
