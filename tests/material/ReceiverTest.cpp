// What receivers and casters are told, whatever draws them.

#include "MaterialScene.h"

#include <Lixel/fit/parts/LightPartition.h>
#include <Lixel/material/ShadowParameters.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreHighLevelGpuProgramManager.h>
#include <OgreShadowCameraSetup.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace Lixel::Tests {
namespace {

const Ogre::Vector3 InShadow(-2, 0, 0);
const Ogre::Vector3 InTheSun(4, 0, 4);

TEST(Receivers, OfMeshesWithoutNormalsAreShadowedModulatively) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative/Bilinear");
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == scene.lights.front());
    Ogre::ManualObject* const carpet = scene.stage.sceneManager().createManualObject("carpet");
    carpet->begin("Test/Unlit", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const Ogre::Vector3& p : {Ogre::Vector3(-20, 0.01F, -20), Ogre::Vector3(-20, 0.01F, 20),
                                   Ogre::Vector3(20, 0.01F, 20), Ogre::Vector3(20, 0.01F, -20)})
        carpet->position(p);
    carpet->quad(0, 1, 2, 3);
    carpet->end();
    carpet->setCastShadows(false);
    scene.stage.sceneManager().getRootSceneNode()->attachObject(carpet);
    const std::vector<int> picture = scene.draw();
    EXPECT_LT(picture[scene.pixelOf(InShadow)], picture[scene.pixelOf(InTheSun)] - 50);
}

/// By scale, scroll and the like of its unit: in each pass and under every technique.
TEST(Receivers, MoveTheirDiffuseMapAsItsUnitSays) {
    for (const auto& [technique, receiver, surface] :
         {std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear", "Lixel/Surface"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "", "Lixel/Surface/Integrated"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "",
                     "Lixel/Surface/Integrated/Maps2"),
          std::tuple(Ogre::SHADOWTYPE_NONE, "", "Lixel/Surface")}) {
        MaterialScene scene(technique, receiver);
        auto& materials = Ogre::MaterialManager::getSingleton();
        Ogre::MaterialPtr tiles = materials.create("Test/Tiles", Ogre::RGN_DEFAULT);
        materials.getByName(surface)->copyDetailsTo(tiles);
        // Black and white, half each.
        Ogre::uchar bytes[] = {0, 0, 0, 255, 255, 255, 255, 255};
        Ogre::Image image;
        image.loadDynamicImage(bytes, 2, 1, Ogre::PF_BYTE_RGBA);
        const Ogre::TexturePtr texture =
            Ogre::TextureManager::getSingleton().loadImage("Test/Halves", Ogre::RGN_DEFAULT, image);
        std::vector<Ogre::TextureUnitState*> units;
        for (Ogre::Pass* pass : tiles->getTechnique(0)->getPasses()) {
            Ogre::TextureUnitState* const unit = pass->getTextureUnitState("DiffuseMap");
            unit->setTextureName(texture->getName());
            unit->setTextureFiltering(Ogre::TFO_NONE);
            units.push_back(unit);
        }
        scene.wear("Test/Tiles");
        const std::vector<int> before = scene.draw();
        for (Ogre::TextureUnitState* unit : units)
            unit->setTextureScroll(0.5F, 0);
        const std::vector<int> moved = scene.draw();
        const std::size_t right = scene.pixelOf(Ogre::Vector3(5, 0, 5));
        const std::size_t left = scene.pixelOf(Ogre::Vector3(-5, 0, 5));
        EXPECT_GT(std::abs(before[right] - before[left]), 20) << surface;
        EXPECT_GT(std::abs(moved[right] - before[right]), 20) << surface << technique;
        EXPECT_GT(std::abs(moved[left] - before[left]), 20) << surface;
    }
}

/// A sphere's smooth normals turn from the light earlier than its faces do: at its terminator a
/// modulative shadow has little light to take.
TEST(Receivers, FadeModulativeShadowsWhereLightGrazes) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative");
    for (Ogre::Light* light : scene.lights)
        light->setVisible(light == scene.lights.front());
    scene.box->setVisible(false);
    const Ogre::Vector3 Middle(0, 4, 2);
    Ogre::Entity* const ball =
        scene.stage.sceneManager().createEntity(Ogre::SceneManager::PT_SPHERE);
    ball->setMaterialName("Test/Unlit");
    Ogre::SceneNode* const node =
        scene.stage.sceneManager().getRootSceneNode()->createChildSceneNode(Middle);
    node->setScale(Ogre::Vector3(0.08F));
    node->attachObject(ball);
    const std::vector<int> shadowed = scene.draw();
    scene.keepPicture("modulative-terminator");
    ball->setCastShadows(false);
    // What the ball's own shadow takes from itself.
    double least = 1;
    const std::vector<int> bare = scene.draw();
    const std::size_t width = scene.stage.window().getWidth();
    const std::size_t centre = scene.pixelOf(Middle);
    for (std::size_t y = centre / width - 50; y < centre / width + 50; ++y)
        for (std::size_t x = centre % width - 50; x < centre % width + 50; ++x) {
            const std::size_t pixel = y * width + x;
            least = std::min(least, static_cast<double>(shadowed[pixel]) / bare[pixel]);
        }
    EXPECT_LT(least, 0.99) << "it has no shadow of its own: nothing was compared";
    EXPECT_GT(least, 0.75); // the shadow colour is a half
}

TEST(Receivers, KeepNoMapOfALightThatHasNone) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    Ogre::Light& light = *scene.lights.front();
    constexpr std::size_t Last = LightPartition::Capacity - 1;
    light.setCustomParameter(LP_MAP_ROW_W + LP_MAP_STEP * Last, Ogre::Vector4(1, 2, 3, 4));
    scene.draw();
    EXPECT_EQ(light.getCustomParameter(LP_MAP_ROW_W + LP_MAP_STEP * Last),
              Ogre::Vector4(0, 0, 0, -1));
}

TEST(Receivers, OfReparsedScriptsWork) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    const std::vector<int> before = scene.draw();
    // As applications do that reload their materials.
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    scene.stage.sceneManager().setShadowTextureCasterMaterial(nullptr);
    scene.stage.sceneManager().setShadowTextureReceiverMaterial(nullptr);
    groups.clearResourceGroup(Ogre::RGN_DEFAULT);
    groups.initialiseResourceGroup(Ogre::RGN_DEFAULT);
    auto& materials = Ogre::MaterialManager::getSingleton();
    scene.stage.sceneManager().setShadowTextureCasterMaterial(materials.getByName("Lixel/Caster"));
    scene.stage.sceneManager().setShadowTextureReceiverMaterial(
        materials.getByName("Lixel/Receiver/Bilinear"));
    scene.wear("Lixel/Surface");
    EXPECT_EQ(differing(before, scene.draw()), 0.0);
}

/// What OGRE's option for reversed depth buffers does to a shadow camera's projection.
class ReversedSetup : public Ogre::ShadowCameraSetup {
public:
    explicit ReversedSetup(Ogre::ShadowCameraSetupPtr inner) : mInner(std::move(inner)) {}
    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override {
        mInner->getShadowCamera(sceneManager, viewer, viewport, light, shadowCamera, iteration);
        Ogre::Matrix4 projection = shadowCamera->getProjectionMatrix();
        for (std::size_t column = 0; column < 4; ++column)
            projection[2][column] = (projection[3][column] - projection[2][column]) / 2;
        shadowCamera->setCustomProjectionMatrix(true, projection);
    }

private:
    Ogre::ShadowCameraSetupPtr mInner;
};

TEST(Casters, StoreTheSameDepthInReversedDepthBuffers) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    const std::vector<int> before = scene.draw();
    for (Ogre::Light* light : scene.lights)
        light->setCustomShadowCameraSetup(
            std::make_shared<ReversedSetup>(light->getCustomShadowCameraSetup()));
    EXPECT_GT(differing(before, scene.draw()), 1.0) << "the depths are told apart";

    auto& programs = Ogre::HighLevelGpuProgramManager::getSingleton();
    const Ogre::HighLevelGpuProgramPtr program = programs.createProgram(
        "Test/ReversedCasterVP", Ogre::RGN_DEFAULT, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    program->setSourceFile("LixelCaster.vert");
    program->setParameter("preprocessor_defines", "OGRE_REVERSED_Z=1");
    program->load();
    const Ogre::MaterialPtr caster =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster")->clone("Test/Reversed");
    Ogre::Pass& pass = *caster->getTechnique(0)->getPass(0);
    pass.setVertexProgram("Test/ReversedCasterVP");
    pass.getVertexProgramParameters()->setNamedAutoConstant(
        "worldViewProj", Ogre::GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX);
    pass.getVertexProgramParameters()->addSharedParameters("Lixel/Caster");
    scene.stage.sceneManager().setShadowTextureCasterMaterial(caster);
    EXPECT_LT(differing(before, scene.draw()), 0.05);
}

/// OGRE draws casters without lights since 13.3.2.
TEST(Casters, AreToldNothingByLights) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    const Ogre::MaterialPtr caster =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster");
    const Ogre::Pass& pass = *caster->getTechnique(0)->getPass(0);
    std::size_t seen = 0;
    for (const auto& parameters :
         {pass.getVertexProgramParameters(), pass.getFragmentProgramParameters()}) {
        for (const auto& automatic : parameters->getAutoConstantList()) {
            ++seen;
            const auto* definition =
                Ogre::GpuProgramParameters::getAutoConstantDefinition(automatic.paramType);
            EXPECT_EQ(std::string(definition->name).find("light"), std::string::npos)
                << definition->name;
        }
    }
    EXPECT_GT(seen, 0U);
}

/// Since 14, OGRE takes the texture off a unit of that type when its material is compiled anew; and
/// in every version it puts the first light's map there for every light.
TEST(Receivers, OfSceneManagersHaveNoContentType) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    for (const char* name :
         {"Lixel/Receiver", "Lixel/Receiver/Bilinear", "Lixel/Receiver/Visibility",
          "Lixel/Receiver/Modulative", "Lixel/Receiver/Modulative/Bilinear"}) {
        const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().getByName(name);
        for (const Ogre::TextureUnitState* unit :
             material->getTechnique(0)->getPass(0)->getTextureUnitStates())
            EXPECT_NE(unit->getContentType(), Ogre::TextureUnitState::CONTENT_SHADOW) << name;
    }
}

/// With separate shader objects, OGRE's default since 14, a fragment program that lacks a varying
/// of its vertex program reads rubbish from the others.
TEST(Programs, ShareOneListOfVaryings) {
    std::size_t seen = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(LIXEL_MATERIALS_DIR "/programs/glsl")) {
        const std::string name = entry.path().filename().string();
        const std::string extension = entry.path().extension().string();
        if (extension != ".vert" && extension != ".frag") continue;
        if (name.starts_with("LixelCaster")) continue; // they have a varying of their own
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const std::string source = text.str();
        ++seen;
        EXPECT_NE(source.find("#include \"LixelVaryings.glsl\""), std::string::npos) << name;
        const std::regex varying(extension == ".vert" ? "\nout " : "\nin ");
        EXPECT_FALSE(std::regex_search(source, varying)) << name << " has a varying of its own";
    }
    EXPECT_GE(seen, 4U);
}

} // namespace
} // namespace Lixel::Tests
