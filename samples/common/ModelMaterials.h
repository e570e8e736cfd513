#pragma once

#include <Ogre.h>
#include <assimp/scene.h>

#include <string>
#include <vector>

namespace Lixel::Samples {

/** The surface of each of a model's materials.

    @param prefix of the names of materials and textures
    @param directory where the model's file lies; textures are looked for there by the path that
    the model gives and, since that is often another computer's, by their bare name
    @param notes gets a line for each texture that could not be read
    @exception Ogre::ItemIdentityException without the material Lixel/Surface
*/
std::vector<Ogre::MaterialPtr> makeModelMaterials(const aiScene& model, const std::string& prefix,
                                                  const std::string& directory,
                                                  std::vector<std::string>& notes);

/// Whether a material asks for both sides of its triangles.
bool isTwoSided(const aiMaterial& material);

} // namespace Lixel::Samples
