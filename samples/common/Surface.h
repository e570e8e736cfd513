#pragma once

#include <Ogre.h>

#include <string>

namespace Lixel::Samples {

/// The material that every surface of the samples is a clone of; materials/scripts defines it.
inline constexpr const char* SurfaceTemplate = "Lixel/Surface";

/** A clone of Lixel/Surface in one colour.

    Sets ambient and diffuse of every pass to the colour and, where a texture is named, texture unit
    0 of every pass that has one. A material of that name is replaced; what still shows the old one
    keeps it.
    @param name of the clone, in OGRE's default resource group
    @param diffuseColour reflected share of light per channel, 0 to 1, multiplied by the texture
    @param textureName of a texture that exists or can be found; empty for plain colour
    @exception Ogre::ItemIdentityException when there is no material Lixel/Surface;
    Ogre::InvalidStateException when a texture is named but no pass of it has a texture unit
*/
Ogre::MaterialPtr makeSurface(const std::string& name, const Ogre::ColourValue& diffuseColour,
                              const std::string& textureName = "");

/// Grey patterns that give a large surface something to see; all tile, and keep colours bright.
enum class Pattern {
    Grain,  ///< soft, irregular spots, as on grass, sand or plaster
    Paving, ///< slabs with darker joints, two by two per repetition
};

/** The texture of a pattern, generated the first time.
    @return its name; empty where no render system makes textures
*/
std::string patternTexture(Pattern pattern);

} // namespace Lixel::Samples
