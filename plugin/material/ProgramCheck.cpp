#include "material/ProgramCheck.h"

#include "material/LightUniforms.h"
#include "material/SharedParameters.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace Lixel {
namespace {

constexpr std::string_view Prefix = "lixel";

/// The programs Lixel/ShadowMaps2 and so on are for up to so many.
constexpr std::array<std::size_t, 4> NumbersOfMaps{2, 3, 4, 6};

/// From so many unbound uniforms on, inheriting is advised instead of a line for each: a map has
/// six.
constexpr std::size_t ManyUnbound = 4;

/// Of a uniform that has one of Lixel's names; empty where it is bound as it should be.
std::string wrongBindingOf(const std::string& uniform, const AutomaticUniform* automatic,
                           const Ogre::GpuProgramParameters& parameters) {
    const char* const set = SharedParameters::setOf(uniform);
    if (set != nullptr && parameters.isUsingSharedParameters(set)) return {};
    const std::optional<int> parameter = parameterMeantBy(uniform);
    if (parameter && isLightCustom(automatic) && boundParameter(*automatic) == *parameter)
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
std::string wrongNumberOf(const std::string& uniform, const AutomaticUniform* automatic) {
    if (!isLightCustom(automatic)) return {};
    const int parameter = boundParameter(*automatic);
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
    const std::size_t parent = mapsOfParentFor(maps);
    const std::string name = "Lixel/ShadowMaps" + std::to_string(parent);
    const std::string first(unbound.front());
    return "'" + first + "' and " + std::to_string(unbound.size() - 1) +
           " more of its uniforms are not bound: let it inherit " + name + ", which binds " +
           (maps > parent ? "those of " + std::to_string(parent) + " maps"
                          : std::string("them all")) +
           " (`fragment_program NAME glsl : " + name + "`)";
}

} // namespace

std::size_t mapsOfParentFor(std::size_t maps) {
    const auto* const found = std::ranges::lower_bound(NumbersOfMaps, maps);
    return found != NumbersOfMaps.end() ? *found : NumbersOfMaps.back();
}

std::vector<std::string> findWrongBindings(const Ogre::GpuProgramParameters& parameters) {
    std::vector<std::string> wrong;
    if (!parameters.hasNamedParameters()) return wrong;
    const auto& uniforms = parameters.getConstantDefinitions().map;
    const auto isUnbound = [&](const std::string& name) {
        return parameterMeantBy(name) && mapIndexIn(name) &&
               parameters.findAutoConstantEntry(name) == nullptr;
    };
    std::vector<std::string_view> unbound;
    for (const auto& [name, definition] : uniforms)
        if (isUnbound(name)) unbound.push_back(name);
    const bool isForgotten = unbound.size() >= ManyUnbound;
    if (isForgotten) wrong.push_back(inheritanceInstead(unbound));
    for (const auto& [name, definition] : uniforms) {
        if (isForgotten && isUnbound(name)) continue;
        const AutomaticUniform* const automatic = parameters.findAutoConstantEntry(name);
        std::string line = std::string_view(name).starts_with(Prefix)
                               ? wrongBindingOf(name, automatic, parameters)
                               : wrongNumberOf(name, automatic);
        if (!line.empty()) wrong.push_back(std::move(line));
    }
    return wrong;
}

} // namespace Lixel
