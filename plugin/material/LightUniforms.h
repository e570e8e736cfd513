#pragma once

#include <OgreGpuProgramParams.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Which uniforms of programs take which of a light's custom parameters (ShadowParameters.h).
namespace Lixel {

using AutomaticUniform = Ogre::GpuProgramParameters::AutoConstantEntry;

/// In a script: the parameter's index in the upper 16 bits, the light's place in the pass below.
inline constexpr int LightBits = 16;
inline constexpr std::size_t LightMask = 0xFFFF;

/// The number that a script has for a parameter of a pass's first light.
std::string scriptNumber(int parameter);

/// The index at the end of the name of one of several maps' uniforms.
std::optional<std::size_t> mapIndexIn(std::string_view uniform);

/// The parameter that a uniform of this name is meant to have; none for names that are not Lixel's.
std::optional<int> parameterMeantBy(std::string_view uniform);

/// Whether a uniform is bound to a custom parameter of a light.
bool isLightCustom(const AutomaticUniform* automatic);

/// The parameter of a light that a uniform is bound to.
int boundParameter(const AutomaticUniform& lightCustom);

/// Whether a parameter is one of Lixel's; and whether it is one of those that each map has.
bool isLightParameter(int parameter);
bool isMapParameter(int parameter);

/// The index of the map that a parameter of a map is of.
int mapOf(int parameter);

/// Whether a number lies where Lixel's parameters do.
bool isInRange(int parameter);

} // namespace Lixel
