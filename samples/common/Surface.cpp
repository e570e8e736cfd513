#include "common/Surface.h"

#include "common/Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Lixel::Samples {
namespace {

constexpr int Side = 256; ///< texels of a pattern
constexpr std::size_t Texels = std::size_t{Side} * Side;

using Grey = std::vector<float>; ///< Side x Side

std::size_t texel(int x, int y) {
    return static_cast<std::size_t>(y) * Side + static_cast<std::size_t>(x);
}

/// Tiling noise in [0, 1]: random values on a lattice of `cells`, smoothly between.
Grey latticeNoise(int cells, Random& random) {
    std::vector<float> lattice(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (float& value : lattice)
        value = random.between(0.0F, 1.0F);
    const auto at = [&](int x, int y) {
        return lattice[static_cast<std::size_t>(y % cells) * static_cast<std::size_t>(cells) +
                       static_cast<std::size_t>(x % cells)];
    };
    const auto ease = [](float t) { return t * t * (3.0F - 2.0F * t); };
    Grey noise(Texels);
    const int step = Side / cells;
    for (int y = 0; y < Side; ++y) {
        for (int x = 0; x < Side; ++x) {
            const int i = x / step;
            const int j = y / step;
            const float u = ease(static_cast<float>(x % step) / static_cast<float>(step));
            const float v = ease(static_cast<float>(y % step) / static_cast<float>(step));
            noise[texel(x, y)] = std::lerp(std::lerp(at(i, j), at(i + 1, j), u),
                                           std::lerp(at(i, j + 1), at(i + 1, j + 1), u), v);
        }
    }
    return noise;
}

Grey grain() {
    Random random(7);
    Grey sum(Texels, 0.0F);
    float weight = 0.36F;
    for (const int cells : {4, 16, 64, 256}) {
        const Grey octave = latticeNoise(cells, random);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += weight * octave[i];
        weight *= 0.75F;
    }
    for (float& value : sum)
        value = std::clamp(0.86F + 0.42F * (value - 0.5F), 0.0F, 1.0F);
    return sum;
}

Grey paving() {
    const Grey rough = grain();
    constexpr float Tones[2][2] = {{1.0F, 0.93F}, {0.9F, 0.97F}};
    constexpr int Slab = Side / 2;
    Grey grey(Texels);
    for (int y = 0; y < Side; ++y) {
        for (int x = 0; x < Side; ++x) {
            const bool joint = x % Slab < 3 || y % Slab < 3;
            const float tone = Tones[y / Slab][x / Slab];
            grey[texel(x, y)] = (joint ? 0.62F : tone) * (0.35F + 0.65F * rough[texel(x, y)]);
        }
    }
    return grey;
}

} // namespace

Ogre::MaterialPtr makeSurface(const std::string& name, const Ogre::ColourValue& diffuseColour,
                              const std::string& textureName) {
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr original = materials.getByName(SurfaceTemplate);
    if (!original)
        OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                    Ogre::String("material '") + SurfaceTemplate +
                        "' is missing: add materials/scripts and materials/programs to the "
                        "resource locations and initialise their group",
                    "makeSurface");
    if (const Ogre::MaterialPtr old = materials.getByName(name)) materials.remove(old);
    Ogre::MaterialPtr surface = materials.create(name, Ogre::RGN_DEFAULT);
    original->copyDetailsTo(surface);
    bool textured = textureName.empty();
    for (const Ogre::Technique* technique : surface->getTechniques()) {
        for (Ogre::Pass* pass : technique->getPasses()) {
            pass->setAmbient(diffuseColour);
            pass->setDiffuse(diffuseColour);
            if (!textureName.empty() && pass->getNumTextureUnitStates() > 0) {
                pass->getTextureUnitState(0)->setTextureName(textureName);
                textured = true;
            }
        }
    }
    if (!textured)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE,
                    Ogre::String("no pass of material '") + SurfaceTemplate +
                        "' has a texture unit for '" + textureName + "'",
                    "makeSurface");
    return surface;
}

std::string patternTexture(Pattern pattern) {
    auto* textures = Ogre::TextureManager::getSingletonPtr();
    if (!textures) return {};
    const bool isGrain = pattern == Pattern::Grain;
    std::string name = isGrain ? "Lixel/Samples/Grain" : "Lixel/Samples/Paving";
    const Ogre::String& group = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
    if (textures->resourceExists(name, group)) return name;
    std::vector<Ogre::uchar> bytes;
    for (const float value : isGrain ? grain() : paving())
        bytes.insert(bytes.end(), 3, static_cast<Ogre::uchar>(std::lround(255.0F * value)));
    Ogre::Image image;
    image.loadDynamicImage(bytes.data(), Side, Side, Ogre::PF_BYTE_RGB);
    textures->loadImage(name, group, image);
    return name;
}

} // namespace Lixel::Samples
