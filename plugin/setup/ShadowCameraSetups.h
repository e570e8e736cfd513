#pragma once

#include "setup/CascadesShadowCameraSetup.h"
#include "setup/ObservedShadowCameraSetup.h"
#include "setup/PlaneOptimalShadowCameraSetup.h"
#include "setup/PostProjectiveCubeShadowCameraSetup.h"
#include "setup/TechniqueShadowCameraSetup.h"

/// All of Lixel's setups.
namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/// A uniform shadow map, focused on what is visible and can be shadowed; or a stable one.
using UniformShadowCameraSetup = TechniqueShadowCameraSetup<UniformOptions>;

/// More texels near the viewer, none lost to casters behind it. Nothing has to be tuned to the
/// scene's scale. Spot lights get the uniform map.
using XPSMShadowCameraSetup = TechniqueShadowCameraSetup<XpsmOptions>;

/// Texels as small as one map can make them where the viewer looks, for suns and spots, from any
/// side. Nothing has to be tuned to the scene; the options trade time for accuracy.
using OptimalShadowCameraSetup = TechniqueShadowCameraSetup<OptimalOptions>;

/// Wimmer's light space perspective shadow map.
using LiSPSMShadowCameraSetup = TechniqueShadowCameraSetup<LiSPSMOptions>;

/// Martin's and Tan's trapezoid.
using TrapezoidalShadowCameraSetup = TechniqueShadowCameraSetup<TrapezoidalOptions>;

/// Stamminger's and Drettakis' perspective shadow map, as Kozlov mends it.
using PSMShadowCameraSetup = TechniqueShadowCameraSetup<PsmOptions>;

/// @}
} // namespace Lixel
