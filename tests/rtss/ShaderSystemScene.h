#pragma once

#include "TestStage.h"
#include "common/StartedShaderSystem.h"

#include <Lixel/rtss/ShaderSystem.h>

#include <string>
#include <vector>

namespace Lixel::Tests {

using Samples::StartedShaderSystem;

/// A picture's red, green and blue, row by row from the top.
using Picture = std::vector<std::uint8_t>;

/// How much two pictures differ.
struct Difference {
    int greatest = 0;     ///< of any channel, of 255
    double percent = 0.0; ///< of channels that differ by more than 4
};
Difference differenceOf(const Picture& a, const Picture& b);
std::ostream& operator<<(std::ostream& out, const Difference& difference);

/// The most that two programs for the same surface differ by: at shadows' edges, where each rounds
/// positions and normals in its own way.
testing::AssertionResult isSame(const Picture& a, const Picture& b);
/// At least half a percent of the channels differs: what was compared is no empty picture.
testing::AssertionResult isOther(const Picture& a, const Picture& b);

/** BoxOnGround with two more boxes, under an integrated technique, without any light at first.

    Everything wears Plain, which has no programs, or Lixel's own surface. Nothing is ambient.
*/
class ShaderSystemScene : public BoxOnGround {
public:
    ShaderSystemScene();
    ~ShaderSystemScene();

    StartedShaderSystem shaderSystem;
    /// Whether the library is shut down before anything else ends.
    bool shutsDown = true;

    /// Lights with a setup each, of another technique each, whose maps are the same in each frame.
    /// Each kind has as many maps as setMaps says.
    Ogre::Light& addSun();
    Ogre::Light& addSpot();
    Ogre::Light& addLamp();
    /// How many shadow textures a light of each kind has; 0 where there is none of it.
    void setMaps(std::size_t sun, std::size_t spot, std::size_t lamp);
    /// Gives everything a material.
    void wear(const std::string& material);

    /// The next frame, drawn by programs of the shader system.
    Picture draw();
    /// The same in Lixel's surface, for six maps a light.
    Picture drawLixels();
    /// The next frame, however the viewport is set up.
    Picture drawAsItIs();
    /// Where a picture shows a world point: the index of its red.
    std::size_t redOf(const Ogre::Vector3& ws) { return 3 * pixelOf(ws); }
    /// Adds materials.
    static void parse(std::string script);
    /// Adds a material of one pass, which has these lines in a script.
    static void addMaterial(const std::string& name, const std::string& pass);
    /// Adds a square texture, without a file.
    /// @param texels red, green, blue and alpha of each, row by row
    static void addTexture(const std::string& name, std::vector<std::uint8_t> texels);
    /// Writes the last frame where the environment's LIXEL_PICTURES names a folder.
    void keepPicture(const std::string& name);

    Ogre::SceneManager& manager() { return stage.sceneManager(); }

    /// A material without programs, white and without specular light.
    static constexpr const char* Plain = "Test/Plain";

private:
    const Ogre::String mOwnScheme = stage.viewport().getMaterialScheme();
    Ogre::Light& add(const std::string& name, Ogre::Light::LightTypes type,
                     const Ogre::Vector3& position, const Ogre::Vector3& direction);
};

} // namespace Lixel::Tests
