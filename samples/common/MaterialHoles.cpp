#include "common/MaterialHoles.h"

#include "common/MaterialPass.h"

#include <Ogre.h>

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

/// Of 255: the least alpha that is drawn; 0 where alpha cuts nothing.
double leastAlpha(const Ogre::Material& material, const Ogre::Pass& pass) {
    const Ogre::CompareFunction comparison = pass.getAlphaRejectFunction();
    if (comparison != Ogre::CMPF_ALWAYS_PASS) {
        if (comparison != Ogre::CMPF_GREATER_EQUAL && comparison != Ogre::CMPF_GREATER)
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "material '" + material.getName() +
                            "' has an alpha_rejection that is neither greater_equal nor greater",
                        "findHoles");
        if (pass.getAlphaRejectValue() > 0) return pass.getAlphaRejectValue();
    }
    const bool blended = pass.getSourceBlendFactor() == Ogre::SBF_SOURCE_ALPHA &&
                         pass.getDestBlendFactor() == Ogre::SBF_ONE_MINUS_SOURCE_ALPHA;
    return blended && material.getTransparencyCastsShadows() ? 0.5 * 255.0 : 0.0;
}

/// The texture unit whose alpha cuts; null without one.
const Ogre::TextureUnitState* alphaUnit(const Ogre::Pass& pass) {
    for (const Ogre::TextureUnitState* unit : pass.getTextureUnitStates()) {
        if (unit->getContentType() != Ogre::TextureUnitState::CONTENT_NAMED) continue;
        const Ogre::TexturePtr& texture = unit->_getTexturePtr();
        if (texture && texture->getTextureType() == Ogre::TEX_TYPE_2D &&
            texture->getWidth() * texture->getHeight() > 1)
            return unit;
    }
    return nullptr;
}

AlphaMask::Wrap wrapOf(Ogre::TextureAddressingMode mode) {
    switch (mode) {
    case Ogre::TAM_MIRROR:
        return AlphaMask::Wrap::Mirror;
    case Ogre::TAM_CLAMP:
        return AlphaMask::Wrap::Clamp;
    case Ogre::TAM_BORDER:
        return AlphaMask::Wrap::Border;
    default:
        return AlphaMask::Wrap::Repeat;
    }
}

/// The full-size picture's alpha, row by row.
std::vector<std::uint8_t> readAlpha(Ogre::Texture& texture) {
    const Ogre::uint32 width = texture.getWidth();
    const Ogre::uint32 height = texture.getHeight();
    // Compressed texels are unpacked by the driver. Others come as they are, since the driver would
    // take a channel that OGRE calls alpha, as in PF_A8, for red.
    const Ogre::PixelFormat format = Ogre::PixelUtil::isCompressed(texture.getFormat())
                                         ? Ogre::PF_BYTE_RGBA
                                         : texture.getFormat();
    std::vector<Ogre::uchar> texels(Ogre::PixelUtil::getMemorySize(width, height, 1, format));
    const Ogre::PixelBox box(width, height, 1, format, texels.data());
    texture.getBuffer()->blitToMemory(box);
    // Since 13.3 OGRE packs red where it should pack alpha into PF_A8, and cannot unpack PF_A8.
    if (format == Ogre::PF_A8) return texels;
    const std::size_t count = std::size_t{width} * height;
    std::vector<Ogre::uchar> colours(4 * count);
    Ogre::PixelUtil::bulkPixelConversion(
        box, Ogre::PixelBox(width, height, 1, Ogre::PF_BYTE_RGBA, colours.data()));
    std::vector<std::uint8_t> alpha(count);
    for (std::size_t i = 0; i < count; ++i)
        alpha[i] = colours[4 * i + 3];
    return alpha;
}

Eigen::Affine3f uvTransformOf(const Ogre::TextureUnitState& unit) {
    const Ogre::Matrix4& matrix = unit.getTextureTransform();
    Eigen::Affine3f transform = Eigen::Affine3f::Identity();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            transform(row, column) = static_cast<float>(matrix[row][column]);
    return transform;
}

} // namespace

std::optional<MaterialHoles> findHoles(const Ogre::Material& material) {
    const Ogre::Pass* const pass = firstPass(material);
    const double least = pass ? leastAlpha(material, *pass) : 0.0;
    if (least <= 0.0) return std::nullopt;
    const Ogre::TextureUnitState* const unit = alphaUnit(*pass);
    if (!unit) return std::nullopt;
    Ogre::Texture& texture = *unit->_getTexturePtr();
    if (!Ogre::PixelUtil::hasAlpha(texture.getFormat())) return std::nullopt;

    MaterialHoles holes;
    holes.mask.width = static_cast<int>(texture.getWidth());
    holes.mask.height = static_cast<int>(texture.getHeight());
    holes.mask.alpha = readAlpha(texture);
    const auto& addressing = unit->getTextureAddressingMode();
    holes.mask.wrap = {wrapOf(addressing.u), wrapOf(addressing.v)};
    holes.mask.borderAlpha = static_cast<std::uint8_t>(
        std::lround(255.0F * std::clamp(unit->getTextureBorderColour().a, 0.0F, 1.0F)));
    holes.mask.bilinear = unit->getTextureFiltering(Ogre::FT_MAG) != Ogre::FO_POINT;
    holes.mask.least = least;
    holes.uvSet = unit->getTextureCoordSet();
    holes.uvFromMesh = uvTransformOf(*unit);
    if (!holes.mask.hasHoles()) return std::nullopt;
    return holes;
}

} // namespace Lixel::Samples
