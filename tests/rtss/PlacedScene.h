#pragma once

#include "ShaderSystemScene.h"

namespace Lixel::Tests {

/// A scene of the shader system's with a sun and a spot, to which bent and instanced posts are added.
class ShaderSystemPlaced : public testing::Test {
protected:
    ShaderSystemPlaced();

    Ogre::RTShader::ShaderGenerator& generator() { return scene.shaderSystem.generator; }

    /// A post of many pieces, 4 high, with this many sets of texture coordinates.
    static Ogre::MeshPtr makePost(int uvSets = 1);

    /// A post whose upper end is bent. Four weights are those of two bones and of two that follow
    /// the first.
    Ogre::Entity& addPost(int weights);

    /// Has programs bend it from now on, in a material that nothing else wears.
    void skin(Ogre::Entity& entity, const std::string& material,
              Ogre::RTShader::SkinningType type = Ogre::RTShader::ST_LINEAR, bool antipodal = false,
              bool scales = false);

    /// Adds a material for instances whose matrices begin at this set of texture coordinates.
    void instanceFrom(int set);

    /// An alpha-tested material, seen from both sides, whose texture has these rows of alpha.
    static void addHoles(const std::string& name, const std::vector<std::uint8_t>& alphas);

    /// In the shader system's scheme; in others OGRE bends it.
    static bool isBentByProgram(Ogre::Entity& entity);

    ShaderSystemScene scene;
};

} // namespace Lixel::Tests
