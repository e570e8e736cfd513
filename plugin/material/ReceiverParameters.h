#pragma once

#include "setup/ShadowMapObserver.h"

#include <OgreVector.h>

namespace Ogre {
class Light;
} // namespace Ogre

namespace Lixel {

/// What a receiver's programs need to know of one shadow map.
struct ReceiverParameters {
    /// Rows whose products with a world position are u w, v w, w and depth.
    Ogre::Vector4 rowU, rowV, rowW, rowDepth;
    /// (width, height, depth bias in units of depth, depth per world unit)
    Ogre::Vector4 sizeBias;
    /// Row whose product with a world position is greatest for the map that serves it.
    Ogre::Vector4 rowShare;
};

/// Of a map that was fitted; everything is lit where the fit has no map.
ReceiverParameters receiverParameters(const ShadowMap& map);

/// Parameters under which everything is lit.
ReceiverParameters litParameters();

/// Writes one map's parameters into the light's custom parameters.
void bindMap(Ogre::Light& light, std::size_t map, const ReceiverParameters& parameters);

/// Writes into all custom parameters of a light that it has no map: a program keeps the last
/// light's values of what the next light lacks.
void bindNoMaps(Ogre::Light& light);

/// As a parameter: beyond any depth.
inline constexpr Ogre::Real EndlessDepth = Ogre::Real(1e30);

} // namespace Lixel
