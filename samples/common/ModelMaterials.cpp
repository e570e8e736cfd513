#include "common/ModelMaterials.h"

#include "common/Surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace Lixel::Samples {
namespace {

namespace fs = std::filesystem;

/// An encoded picture and the name of its format: "png".
struct EncodedImage {
    std::vector<char> bytes;
    std::string format;
};

Ogre::ColourValue colourOf(const aiMaterial& material) {
    const Ogre::ColourValue unknown(0.72F, 0.72F, 0.70F);
    aiColor4D colour;
    if (material.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS &&
        material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS)
        return unknown;
    if (!std::isfinite(colour.r) || !std::isfinite(colour.g) || !std::isfinite(colour.b))
        return unknown;
    const auto channel = [](float value) { return std::clamp(value, 0.0F, 1.0F); };
    return Ogre::ColourValue(channel(colour.r), channel(colour.g), channel(colour.b));
}

std::string diffuseTextureOf(const aiMaterial& material) {
    aiString path;
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
        if (material.GetTexture(type, 0, &path) == aiReturn_SUCCESS && path.length > 0)
            return path.C_Str();
    return {};
}

std::optional<EncodedImage> readFile(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    EncodedImage image{{std::istreambuf_iterator<char>(stream), {}}, path.extension().string()};
    if (!stream || image.bytes.empty()) return std::nullopt;
    if (!image.format.empty()) image.format.erase(0, 1);
    return image;
}

/// Looks beside the model by the given path, then by the bare name.
std::optional<EncodedImage> findFile(const std::string& directory, std::string reference) {
    std::replace(reference.begin(), reference.end(), '\\', '/');
    const fs::path path(reference);
    if (auto image = readFile(fs::path(directory) / path)) return image;
    return readFile(fs::path(directory) / path.filename());
}

std::optional<Ogre::Image> decode(EncodedImage encoded) {
    Ogre::StringUtil::toLowerCase(encoded.format);
    // By the extension, then by what the bytes begin with.
    for (const std::string& format : {encoded.format, std::string()}) {
        try {
            auto stream = std::make_shared<Ogre::MemoryDataStream>(
                encoded.bytes.data(), encoded.bytes.size(), false, true);
            Ogre::Image image;
            image.load(stream, format);
            if (image.getWidth() > 0 && image.getHeight() > 0) return image;
        } catch (const Ogre::Exception&) {
            continue; // no codec, or a broken picture: the caller notes it
        }
    }
    return std::nullopt;
}

std::optional<Ogre::Image> decodeEmbedded(const aiTexture& texture) {
    if (!texture.pcData || texture.mWidth == 0) return std::nullopt;
    const auto* bytes = reinterpret_cast<const char*>(texture.pcData);
    if (texture.mHeight == 0) // encoded; the width is its size in bytes
        return decode({{bytes, bytes + texture.mWidth}, texture.achFormatHint});
    Ogre::Image image(Ogre::PF_BYTE_BGRA, texture.mWidth, texture.mHeight);
    std::memcpy(image.getData(), bytes, image.getSize());
    return image;
}

/// Loads one diffuse texture; empty when nobody can read it.
std::string loadTexture(const aiScene& model, const std::string& reference,
                        const std::string& prefix, const std::string& directory) {
    auto* textures = Ogre::TextureManager::getSingletonPtr();
    if (!textures) return {};
    std::optional<Ogre::Image> image;
    if (const aiTexture* embedded = model.GetEmbeddedTexture(reference.c_str()))
        image = decodeEmbedded(*embedded);
    else if (auto encoded = findFile(directory, reference))
        image = decode(std::move(*encoded));
    if (!image) return {};
    std::string name = prefix + "/" + reference;
    const Ogre::String& group = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
    if (const auto old = textures->getByName(name, group)) textures->remove(old);
    textures->loadImage(name, group, *image);
    return name;
}

} // namespace

bool isTwoSided(const aiMaterial& material) {
    int twoSided = 0;
    return material.Get(AI_MATKEY_TWOSIDED, twoSided) == aiReturn_SUCCESS && twoSided != 0;
}

std::vector<Ogre::MaterialPtr> makeModelMaterials(const aiScene& model, const std::string& prefix,
                                                  const std::string& directory,
                                                  std::vector<std::string>& notes) {
    std::vector<Ogre::MaterialPtr> materials;
    // By the model's references: several materials may share one. Empty where it cannot be read.
    std::map<std::string, std::string> textures;
    for (unsigned i = 0; i < model.mNumMaterials; ++i) {
        const aiMaterial& material = *model.mMaterials[i];
        Ogre::ColourValue colour = colourOf(material);
        std::string texture;
        if (const std::string reference = diffuseTextureOf(material); !reference.empty()) {
            const auto [known, isNew] = textures.try_emplace(reference);
            if (isNew) {
                known->second = loadTexture(model, reference, prefix, directory);
                if (known->second.empty())
                    notes.push_back("texture '" + reference +
                                    "' cannot be read: plain colour instead");
            }
            texture = known->second;
            // Black is what exporters write beside a texture.
            if (!texture.empty() && std::max({colour.r, colour.g, colour.b}) < 0.02F)
                colour = Ogre::ColourValue::White;
        }
        materials.push_back(makeSurface(prefix + "/material" + std::to_string(i), colour, texture));
    }
    return materials;
}

} // namespace Lixel::Samples
