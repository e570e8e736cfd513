#pragma once

#include "fit/technique/LiSPSM.h"
#include "fit/technique/Optimal.h"
#include "fit/technique/PlaneOptimal.h"
#include "fit/technique/Psm.h"
#include "fit/technique/Trapezoidal.h"
#include "fit/technique/Uniform.h"
#include "fit/technique/Xpsm.h"

#include <array>

namespace Lixel {
/// @addtogroup LixelTechniques
/// @{

/// A list of types, for what is made of each.
template <typename... Types>
struct TypeList {
    static constexpr std::size_t Size = sizeof...(Types);
};

/// The options of all techniques that make one map, in the order in which lists show them.
using AllTechniques = TypeList<UniformOptions, XpsmOptions, OptimalOptions, LiSPSMOptions,
                               TrapezoidalOptions, PsmOptions, PlaneOptimalOptions>;

namespace Detail {

template <typename... Options>
std::array<const FitTechnique*, sizeof...(Options)> techniquesOf(TypeList<Options...>) {
    return {&Options::technique()...};
}

} // namespace Detail

/// All techniques that make one map.
inline std::array<const FitTechnique*, AllTechniques::Size> techniques() {
    return Detail::techniquesOf(AllTechniques());
}

/// @}
} // namespace Lixel
