#include "setup/MapProof.h"

#include "scene/Log.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgrePixelFormat.h>

#include <algorithm>

namespace Lixel {
namespace {

bool isOn = false;
std::function<void()> waitForDrawing;
ProofCount counted;

/// @param before what the texture held before it was drawn once more
void compare(const Ogre::Texture& texture, const std::vector<std::uint8_t>& before,
             const std::string& what, const std::string& how) {
    const std::vector<std::uint8_t> drawn = readTexels(texture);
    if (drawn == before) return;
    ++counted.different;
    const std::size_t size = Ogre::PixelUtil::getNumElemBytes(texture.getFormat());
    std::size_t texels = 0;
    for (std::size_t texel = 0; texel + size <= drawn.size() && texel + size <= before.size();
         texel += size)
        if (!std::equal(&drawn[texel], &drawn[texel] + size, &before[texel])) ++texels;
    logWarning("proof mode: shadow map '" + texture.getName() + "' " + what + ", and " +
               std::to_string(texels) + " of its texels are different when it is drawn " + how);
}

} // namespace

void setProofMode(bool on, const std::function<void()>& wait) {
    isOn = on;
    waitForDrawing = wait;
    counted = {};
}

bool isProofMode() {
    return isOn;
}

ProofCount proofCount() {
    return counted;
}

std::vector<std::uint8_t> readTexels(const Ogre::Texture& texture) {
    const Ogre::PixelFormat format = texture.getFormat();
    const Ogre::uint32 width = texture.getWidth();
    const Ogre::uint32 height = texture.getHeight();
    std::vector<std::uint8_t> texels(Ogre::PixelUtil::getMemorySize(width, height, 1, format));
    if (waitForDrawing) waitForDrawing();
    // Reading changes nothing, but OGRE's buffers do not know that.
    const_cast<Ogre::Texture&>(texture).getBuffer()->blitToMemory(
        Ogre::PixelBox(width, height, 1, format, texels.data()));
    return texels;
}

void proveMap(const Ogre::Texture& texture, const std::vector<std::uint8_t>& kept) {
    ++counted.maps;
    compare(texture, kept, "would have been kept", "anew");
}

void proveMapDrawnBy(const MapShortcuts& shortcuts, const Ogre::Texture& texture,
                     const std::vector<std::uint8_t>& before) {
    counted.batched += shortcuts.batches ? 1U : 0U;
    counted.layered += shortcuts.layers ? 1U : 0U;
    if (shortcuts.layers)
        compare(texture, before, "was drawn in layers", "at once, with each caster by itself");
    else
        compare(texture, before, "was drawn with casters in batches", "with each by itself");
}

} // namespace Lixel
