#include "material/LightUniforms.h"

#include "fit/parts/LightPartition.h"
#include "material/ShadowParameters.h"

#include <algorithm>
#include <array>

namespace Lixel {
namespace {

struct MapUniform {
    std::string_view name; ///< of the first map; the others' end with the map's index
    int parameter;
};
constexpr std::array MapUniforms{
    MapUniform{"lixelRowU", LP_MAP_ROW_U},         MapUniform{"lixelRowV", LP_MAP_ROW_V},
    MapUniform{"lixelRowW", LP_MAP_ROW_W},         MapUniform{"lixelRowDepth", LP_MAP_ROW_DEPTH},
    MapUniform{"lixelSizeBias", LP_MAP_SIZE_BIAS}, MapUniform{"lixelRowShare", LP_MAP_ROW_SHARE},
};

} // namespace

std::string scriptNumber(int parameter) {
    return std::to_string(parameter << LightBits);
}

std::optional<std::size_t> mapIndexIn(std::string_view uniform) {
    if (uniform.empty() || uniform.back() < '0' || uniform.back() > '9') return std::nullopt;
    return static_cast<std::size_t>(uniform.back() - '0');
}

std::optional<int> parameterMeantBy(std::string_view uniform) {
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

bool isMapParameter(int parameter) {
    return std::any_of(MapUniforms.begin(), MapUniforms.end(), [&](const MapUniform& known) {
        return parameter == known.parameter + LP_MAP_STEP * mapOf(parameter);
    });
}

bool isLightParameter(int parameter) {
    return parameter == LP_CASTER_DEPTH || parameter == LP_SPLIT_DEPTHS ||
           isMapParameter(parameter);
}

int mapOf(int parameter) {
    return (parameter - LP_MAP_ROW_U) / LP_MAP_STEP;
}

bool isInRange(int parameter) {
    return parameter >= LP_MAP_ROW_U &&
           parameter < LP_MAP_ROW_U + LP_MAP_STEP * static_cast<int>(LightPartition::Capacity);
}

bool isLightCustom(const AutomaticUniform* automatic) {
    return automatic != nullptr &&
           automatic->paramType == Ogre::GpuProgramParameters::ACT_LIGHT_CUSTOM;
}

int boundParameter(const AutomaticUniform& lightCustom) {
    return static_cast<int>(lightCustom.data >> LightBits);
}

} // namespace Lixel
