// What the log says of materials that cannot work: one line, with what to do.

#include "MaterialScene.h"

#include <Lixel/material/ShadowMaterials.h>
#include <Lixel/material/ShadowParameters.h>
#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <algorithm>

namespace Lixel::Tests {
namespace {

/// Draws two frames, or as many as OGRE lets it.
void drawIfPossible(MaterialScene& scene) {
    try {
        scene.draw();
        scene.draw();
    } catch (const Ogre::Exception&) {
        // OGRE draws nothing without programs.
    }
}

TEST(MaterialCheck, SaysNothingOfWhatIsRight) {
    LogCollector* log = nullptr;
    for (const auto& [technique, receiver, surface] :
         {std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear", "Lixel/Surface"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver", "Test/Foreign"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver", "Test/OwnReceiver"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "",
                     "Lixel/Surface/Integrated/Maps6"),
          std::tuple(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative",
                     "Lixel/Surface")}) {
        MaterialScene scene(technique, receiver);
        LogCollector collector;
        log = &collector;
        scene.wear(surface);
        scene.draw();
        scene.draw();
        EXPECT_EQ(log->count("Lixel:"), 0U)
            << surface << " under " << technique << ": " << log->all();
    }
}

struct WrongCase {
    const char* name;
    Ogre::ShadowTechnique technique;
    const char* receiver;
    const char* surface;
    std::vector<const char*> said;
};

class WrongMaterial : public testing::TestWithParam<WrongCase> {};

TEST_P(WrongMaterial, IsSaidOnceWithWhatToDo) {
    const WrongCase& wrong = GetParam();
    MaterialScene scene(wrong.technique, wrong.receiver);
    LogCollector log;
    if (!scene.stage.sceneManager().isShadowTechniqueIntegrated())
        scene.addCube(Ogre::Vector3(4, 0.5F, -4), Ogre::Vector3(1, 1, 1)); // in Lixel/Surface
    scene.wear(wrong.surface);
    drawIfPossible(scene);
    for (const char* said : wrong.said)
        EXPECT_EQ(log.count(said), 1U) << said << "\nin: " << log.all();
    EXPECT_EQ(log.count("Lixel:"), wrong.said.size()) << log.all();
}

INSTANTIATE_TEST_SUITE_P(
    Cases, WrongMaterial,
    testing::Values(
        WrongCase{"WithoutPrograms",
                  Ogre::SHADOWTYPE_TEXTURE_MODULATIVE,
                  "Lixel/Receiver/Modulative",
                  "Test/FixedFunction",
                  {"material 'Test/FixedFunction' has no programs"}},
        WrongCase{"SplitForAdditiveShadows",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/OnePass",
                  {"material 'Test/OnePass' loses its fragment program"}},
        WrongCase{"ReadsNoMap",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "Lixel/Surface",
                  {"material 'Lixel/Surface' reads no shadow map"}},
        WrongCase{"Terrain",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "OgreTerrain/Test",
                  {"OGRE's terrain, material 'OgreTerrain/Test', makes programs of its own, which "
                   "read no map as Lixel's casters write it"}},
        WrongCase{
            "WrongNumbers",
            Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
            "",
            "Test/OtherNames",
            {"'first' is bound to light_custom 100, which is parameter 0 of light 100: Lixel's "
             "parameter 100 is light_custom 6553600",
             "'second' is bound to light_custom 7077888, parameter 108: there is none",
             "material 'Test/OtherNames' reads no shadow map"}},
        WrongCase{"ForeignCaster",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/CastsByForeign",
                  {"what wears material 'Test/CastsByForeign' casts by the caster material "
                   "'Test/ForeignCaster'"}},
        WrongCase{"NoProgramThatCompiles",
                  Ogre::SHADOWTYPE_TEXTURE_MODULATIVE,
                  "Lixel/Receiver/Modulative",
                  "Test/Broken",
                  {"OGRE's own material 'BaseWhite' is drawn, which has no programs"}},
        WrongCase{"ForgottenParent",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "Test/ForgottenParent",
                  {"'lixelRowDepth0' and 17 more of its uniforms are not bound: let it inherit "
                   "Lixel/ShadowMaps3"}},
        WrongCase{"UnitBeforeTheMaps",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "Test/UnitBeforeTheMaps",
                  {"'shadowMap' is texture unit 1, and OGRE puts that map into unit 2",
                   "'diffuseMap' is texture unit 0, and DiffuseMap is unit 1"}},
        WrongCase{"UnitBeforeTheDiffuseMap",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/UnitBeforeTheDiffuseMap",
                  {"material 'Test/UnitBeforeTheDiffuseMap': 'diffuseMap' is texture unit 1, and "
                   "DiffuseMap is unit 2"}},
        WrongCase{"MoreMapsThanUnits",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "Test/MoreMapsThanUnits",
                  {"its program reads 3 shadow maps, and it has 2 texture units of content_type "
                   "shadow: inherit Lixel/Surface/Integrated/Maps3"}},
        WrongCase{"UnitBeforeTheReceiversMap",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/WearsUnitBeforeTheReceiversMap",
                  {"'shadowMap' is texture unit 0, and ShadowMap is unit 1"}},
        WrongCase{"UnitWithoutAName",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/UnitWithoutAName",
                  {"texture 'any.png' is in a unit without a name, which nothing reads"}},
        WrongCase{
            "HolesInOnePass",
            Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
            "Lixel/Receiver",
            "Test/HolesInOnePass",
            {"material 'Test/HolesInOnePass': pass 'Ambient' fills the holes of pass 'Light': "
             "give it the same alpha_rejection"}},
        WrongCase{"HolesWhereAlphaIsGreat",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver",
                  "Test/HolesWhereAlphaIsGreat",
                  {"material 'Test/HolesWhereAlphaIsGreat' has an alpha_rejection that Lixel's "
                   "casters and surfaces take for greater_equal"}},
        WrongCase{"UnitInPlaceOfAMap",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                  "",
                  "Test/UnitInPlaceOfAMap",
                  {"'shadowMap1' is texture unit 2, and OGRE puts that map into unit 3",
                   "'shadowMap2' is texture unit 3, and OGRE puts that map into unit 4"}},
        WrongCase{"AdditiveReceiver",
                  Ogre::SHADOWTYPE_TEXTURE_MODULATIVE,
                  "Lixel/Receiver/Bilinear",
                  "Lixel/Surface",
                  {"shadow receiver material 'Lixel/Receiver/Bilinear' is for additive shadows, "
                   "and this scene manager's are modulative: take "
                   "'Lixel/Receiver/Modulative/Bilinear'"}},
        WrongCase{"ModulativeReceiver",
                  Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                  "Lixel/Receiver/Modulative/Bilinear",
                  "Lixel/Surface",
                  {"shadow receiver material 'Lixel/Receiver/Modulative/Bilinear' is for "
                   "modulative shadows, and this scene manager's are additive: take "
                   "'Lixel/Receiver/Bilinear'"}},
        WrongCase{"AdditiveReceiverOfItsOwn",
                  Ogre::SHADOWTYPE_TEXTURE_MODULATIVE,
                  "Lixel/Receiver/Modulative",
                  "Test/OwnReceiver",
                  {"shadow receiver material 'Test/Receiver' is for additive shadows"}}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

/// As hardware-skinned models of OGRE's shader system, where nothing else casts.
TEST(MaterialCheck, SaysThatAllCastersAreForeign) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    LogCollector log;
    scene.wear("Test/CastsByForeign");
    scene.draw();
    scene.draw();
    EXPECT_EQ(log.count("casts by the caster material 'Test/ForeignCaster'"), 1U) << log.all();
    EXPECT_EQ(log.count("Lixel:"), 1U) << log.all();
}

TEST(MaterialCheck, SaysThatATextureOfOneTexelIsWhite) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    const Ogre::TexturePtr texel = Ogre::TextureManager::getSingleton().createManual(
        "OneTexel", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 1, 1, 0, Ogre::PF_BYTE_RGB);
    const Ogre::MaterialPtr red =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Surface")->clone("Test/OneTexel");
    red->getTechnique(0)->getPass("Light")->getTextureUnitState("DiffuseMap")->setTexture(texel);
    scene.wear("Test/OneTexel");
    LogCollector log;
    scene.draw();
    EXPECT_EQ(log.count("texture 'OneTexel' has one texel"), 1U) << log.all();
}

TEST(MaterialCheck, SaysThatInstancesAreNotPlaced) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    Ogre::SceneNode* const node = scene.addCube(Ogre::Vector3(4, 1, 0), Ogre::Vector3(1));
    const auto* const cube = static_cast<Ogre::Entity*>(node->getAttachedObject(0));
    manager.createInstanceManager("instances", cube->getMesh()->getName(),
                                  cube->getMesh()->getGroup(),
                                  Ogre::InstanceManager::HWInstancingBasic, 8);
    for (const float x : {-4.0F, 6.0F})
        manager.getRootSceneNode()
            ->createChildSceneNode(Ogre::Vector3(x, 1, 2))
            ->attachObject(manager.createInstancedEntity("Lixel/Surface", "instances"));
    LogCollector log;
    scene.draw();
    scene.draw();
    EXPECT_GE(log.count("does not place them"), 1U) << log.all();
    manager.destroyInstanceManager("instances");
}

/// What is for an integrated technique has units in another order, and is drawn by the receiver.
TEST(MaterialCheck, SaysNothingOfMapUnitsThatAreNotRead) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.wear("Lixel/Surface/Integrated");
    LogCollector log;
    scene.draw();
    scene.draw();
    EXPECT_EQ(log.count("texture unit"), 0U) << log.all();
}

/// A far level of detail may do without.
TEST(MaterialCheck, SaysNothingOfFarTechniquesWithoutMaps) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton()
                                           .getByName("Lixel/Surface/Integrated")
                                           ->clone("Test/WithFarTechnique");
    Ogre::Technique* const far = material->createTechnique();
    *far = *Ogre::MaterialManager::getSingleton().getByName("Lixel/Surface")->getTechnique(0);
    far->setLodIndex(1);
    material->setLodLevels({1});
    scene.wear("Test/WithFarTechnique");
    LogCollector log;
    scene.draw();
    scene.draw();
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

TEST(MaterialCheck, SaysHowAScenesReceiverIsBoundWrongly) {
    for (const auto& [receiver, said] :
         {std::pair(
              "Test/WrongNumber",
              "'lixelRowW' is bound to light_custom 102: it takes `param_named_auto lixelRowW "
              "light_custom 6684672`"),
          std::pair("Test/Unbound",
                    "'lixelSizeBias' is not bound: it takes `param_named_auto lixelSizeBias "
                    "light_custom 6815744`")}) {
        MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, receiver);
        LogCollector log;
        scene.draw();
        scene.draw();
        EXPECT_EQ(log.count(said), 1U) << log.all();
    }
}

TEST(MaterialCheck, SaysThatCastersAreNotToldByLights) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowTextureCasterMaterial(
        Ogre::MaterialManager::getSingleton().getByName("Test/CasterByLight"));
    LogCollector log;
    scene.draw();
    EXPECT_EQ(log.count("'lixelCasterDepth' is bound to light_custom 6881280: it takes "
                        "`shared_params_ref Lixel/Caster`"),
              1U)
        << log.all();
}

TEST(MaterialCheck, SaysThatSceneMaterialsAreMissing) {
    for (const auto& [caster, receiver, said] :
         {std::tuple("Lixel/Castor", "Lixel/Receiver", "has no shadow caster material"),
          std::tuple("Lixel/Caster", "Lixel/Reciever", "has no shadow receiver material")}) {
        MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
        Ogre::SceneManager& manager = scene.stage.sceneManager();
        auto& materials = Ogre::MaterialManager::getSingleton();
        manager.setShadowTextureCasterMaterial(materials.getByName(caster));
        manager.setShadowTextureReceiverMaterial(materials.getByName(receiver));
        LogCollector log;
        drawIfPossible(scene);
        EXPECT_EQ(log.count(said), 1U) << log.all();
    }
}

TEST(ShadowMaterials, AreKnownByName) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    const std::vector<int> before = scene.draw();
    manager.setShadowTextureCasterMaterial(nullptr);
    manager.setShadowTextureReceiverMaterial(nullptr);
    setShadowMaterials(manager, "Lixel/Receiver/Bilinear");
    EXPECT_EQ(before, scene.draw());
    try {
        setShadowMaterials(manager, "Lixel/Reciever");
        FAIL() << "there is no such material";
    } catch (const Ogre::ItemIdentityException& error) {
        const std::string message = error.getDescription();
        EXPECT_NE(message.find("receiver: there is no material 'Lixel/Reciever'"),
                  std::string::npos);
        EXPECT_NE(message.find("Lixel/Receiver/Bilinear"), std::string::npos) << message;
    }
    EXPECT_EQ(before, scene.draw()) << "a wrong name changes nothing";
}

TEST(ShadowMaterials, AreRefusedInEachOthersPlace) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    const std::vector<int> before = scene.draw();
    for (const auto& [receiver, caster, said] :
         {std::tuple("Lixel/Caster", "Lixel/Receiver",
                     "caster: material 'Lixel/Receiver' is a "
                     "receiver"),
          std::tuple("Lixel/Caster", "Lixel/Caster",
                     "receiver: material 'Lixel/Caster' is a caster"),
          std::tuple("Lixel/Surface", "Lixel/Caster",
                     "receiver: material 'Lixel/Surface' is a surface")})
        try {
            setShadowMaterials(manager, receiver, caster);
            FAIL() << receiver << ", " << caster;
        } catch (const Ogre::InvalidParametersException& error) {
            EXPECT_NE(error.getDescription().find(said), std::string::npos)
                << error.getDescription();
        }
    EXPECT_EQ(before, scene.draw()) << "a wrong one changes nothing";
}

TEST(ShadowMaterials, OfTheOtherTechniqueAreNamedInTheFirstFrame) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "");
    LogCollector log;
    setShadowMaterials(scene.stage.sceneManager(), "Lixel/Receiver/Bilinear");
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE);
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
    scene.draw();
    EXPECT_EQ(log.count("'Lixel/Receiver/Bilinear' is for additive shadows"), 1U) << log.all();
}

/// OGRE uses a surface's own shadow materials unasked, and crashed on these.
TEST(MaterialCheck, DropsOwnMaterialsThatDoNotCompile) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    scene.wear("Lixel/Surface");
    LogCollector log;
    const std::vector<int> plain = scene.draw();
    EXPECT_EQ(log.count("cannot be drawn"), 0U) << "nothing wears one: " << log.all();
    // Not among the first views, which are looked at more closely.
    for (int i = 0; i < 5; ++i)
        scene.draw();
    scene.wear("Test/OwnBrokenReceiver");
    EXPECT_EQ(plain, scene.draw()) << "the scene manager's materials are used";
    EXPECT_EQ(log.count("'Test/OwnBrokenReceiver': its shadow_receiver_material"), 1U) << log.all();

    // What OGRE loads only when it is queued.
    Ogre::ManualObject* const sheet = scene.stage.sceneManager().createManualObject("sheet");
    sheet->begin("Test/AnotherBrokenReceiver", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const Ogre::Vector3& p :
         {Ogre::Vector3(6, 0.1F, 6), Ogre::Vector3(6, 0.1F, 7), Ogre::Vector3(7, 0.1F, 7)}) {
        sheet->position(p);
        sheet->normal(Ogre::Vector3::UNIT_Y);
    }
    sheet->triangle(0, 1, 2);
    sheet->end();
    scene.stage.sceneManager().getRootSceneNode()->attachObject(sheet);
    scene.draw();
    EXPECT_EQ(log.count("'Test/AnotherBrokenReceiver': its shadow_receiver_material"), 1U)
        << log.all();
    scene.stage.sceneManager().destroyManualObject(sheet);

    // One that an application makes while it runs.
    auto& materials = Ogre::MaterialManager::getSingleton();
    Ogre::MaterialPtr made = materials.create("Test/MadeBroken", Ogre::RGN_DEFAULT);
    materials.getByName("Lixel/Surface")->copyDetailsTo(made);
    made->getTechnique(0)->setShadowCasterMaterial(materials.getByName("Test/BrokenReceiver"));
    scene.wear("Test/MadeBroken");
    EXPECT_EQ(plain, scene.draw());
    EXPECT_EQ(log.count("'Test/MadeBroken': its shadow_caster_material 'Test/BrokenReceiver'"), 1U)
        << log.all();
}

TEST(MaterialCheck, SaysThatMapsAreNoSlices) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    for (Ogre::Light* const light : scene.lights)
        light->setCastShadows(light == scene.lights.front());
    manager.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 3);
    manager.setShadowTextureSettings(512, 3, Ogre::PF_FLOAT32_R);
    const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton()
                                           .getByName("Lixel/Surface/Integrated/Maps3")
                                           ->clone("Test/BySplitDepths");
    // As a program of one's own has it.
    Ogre::GpuProgramParameters& parameters =
        *material->getTechnique(0)->getPasses().back()->getFragmentProgramParameters();
    const auto& uniforms = parameters.getConstantDefinitions().map;
    const auto vector = std::ranges::find_if(uniforms, [](const auto& uniform) {
        return uniform.first.starts_with("lixelRowShare") &&
               uniform.second.constType == Ogre::GCT_FLOAT4;
    });
    ASSERT_NE(vector, uniforms.end());
    parameters.setNamedAutoConstant(vector->first, Ogre::GpuProgramParameters::ACT_LIGHT_CUSTOM,
                                    static_cast<Ogre::uint32>(LP_SPLIT_DEPTHS) << 16U);
    scene.wear("Test/BySplitDepths");
    // Shadows all over the ground, seen from above: strips serve them better.
    for (int i = 0; i < 49; ++i)
        scene.addCube(
            {2.0F * static_cast<float>(i % 7 - 3), 0.5F, 2.0F * static_cast<float>(i / 7 - 3)},
            {0.5F, 1, 0.5F});
    Ogre::SceneNode* const viewer = scene.stage.camera().getParentSceneNode();
    viewer->setPosition(0, 16, 0.5F);
    viewer->lookAt({0, 0, 0}, Ogre::Node::TS_WORLD);
    for (const bool strips : {false, true}) {
        scene.lights.front()->setCustomShadowCameraSetup(CascadesShadowCameraSetup::create(
            UniformShadowCameraSetup::create(), CascadeOptions{.stripLight = strips}));
        LogCollector log;
        for (int frame = 0; frame < 64; ++frame)
            scene.draw();
        EXPECT_EQ(
            log.count("'Test/BySplitDepths' finds its map by `lixelSplitDepths`, and the maps "
                      "of light"),
            strips ? 1U : 0U)
            << log.all();
    }
}

TEST(MaterialCheck, SaysThatNothingReceives) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowTextureSelfShadow(false);
    scene.ground->getAttachedObject(0)->setCastShadows(true);
    LogCollector log;
    for (int i = 0; i < 3; ++i)
        scene.draw();
    EXPECT_EQ(log.count("Lixel:"), 0U) << "a scene that is being made: " << log.all();
    for (int i = 0; i < 60; ++i)
        scene.stage.drawFrame();
    EXPECT_EQ(log.count("receives none until SceneManager::setShadowTextureSelfShadow(true)"), 1U)
        << log.all();
}

TEST(MaterialCheck, SaysThatTexturesAreTooFew) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowTextureCount(1);
    LogCollector log;
    scene.draw();
    scene.draw();
    EXPECT_EQ(log.count("has 1 shadow textures, and the lights that cast shadows here take 3"), 1U)
        << log.all();
}

TEST(MaterialCheck, SaysThatALightHasNoSetup) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.lights.back()->setCustomShadowCameraSetup(nullptr);
    LogCollector log;
    scene.draw();
    scene.draw();
    EXPECT_EQ(log.count("light 'spot' has no setup of Lixel's"), 1U) << log.all();
}

TEST(MaterialCheck, SaysThatDepthFormatsAreNotServed) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowTextureSettings(512, 3, Ogre::PF_DEPTH16);
    LogCollector log;
    scene.draw();
    EXPECT_EQ(log.count("PF_DEPTH16 do not hold what Lixel/Caster stores"), 1U) << log.all();
}

TEST(MaterialCheck, SaysThatAFormatHoldsTooLittleDepth) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver");
    scene.stage.sceneManager().setShadowTextureSettings(512, 3, Ogre::PF_BYTE_RGBA);
    LogCollector log;
    scene.draw();
    EXPECT_EQ(log.count("do not hold what Lixel/Caster stores"), 1U) << log.all();
}

/// Every so many views one is looked at: of two that are drawn in turn not always the same.
TEST(MaterialCheck, LooksAtEachOfSeveralViews) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear("Lixel/Surface/Integrated");
    Ogre::SceneManager& manager = scene.stage.sceneManager();
    // The second sees the sky alone, and later what wears no material of Lixel's.
    Ogre::Camera* const other = manager.createCamera("other");
    Ogre::SceneNode* const node = manager.getRootSceneNode()->createChildSceneNode();
    node->attachObject(other);
    other->setNearClipDistance(0.1F);
    node->setPosition(0, 1000, 0);
    node->setDirection(Ogre::Vector3::UNIT_Z, Ogre::Node::TS_WORLD);
    scene.stage.camera().getViewport()->getTarget()->addViewport(other, 1, 0, 0, 0.5F, 1);
    for (int frame = 0; frame < 10; ++frame)
        scene.draw();
    LogCollector log;
    Ogre::SceneNode* const cube = scene.addCube(Ogre::Vector3(0, 1000, 5), Ogre::Vector3(1, 1, 1));
    static_cast<Ogre::Entity*>(cube->getAttachedObject(0))->setMaterialName("Test/Foreign");
    scene.addCube(Ogre::Vector3(0, 1004, 5), Ogre::Vector3(9, 0.1F, 9));
    for (unsigned frame = 0; frame < 70; ++frame)
        scene.stage.drawFrame();
    EXPECT_EQ(log.count("material 'Test/Foreign' reads no shadow map"), 1U) << log.all();
    scene.stage.camera().getViewport()->getTarget()->removeViewport(1);
}

/// Of a view without maps nothing is collected: it is drawn as if nobody looked.
TEST(MaterialCheck, StopsListeningWhereShadowsEnd) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear("Lixel/Surface/Integrated");
    scene.draw();
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_NONE);
    scene.draw();
    LogCollector log;
    scene.wear("Test/OtherNames");
    scene.draw();
    EXPECT_EQ(log.count("Lixel:"), 0U) << log.all();
}

/// What changes while the program runs is looked at in the next frame.
TEST(MaterialCheck, LooksAgainWhereTheTechniqueChanges) {
    MaterialScene scene(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear("Lixel/Surface/Integrated");
    for (int frame = 0; frame < 10; ++frame)
        scene.draw();
    LogCollector log;
    scene.stage.sceneManager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE);
    try {
        scene.draw();
    } catch (const Ogre::Exception&) {
        // It has no receiver that can be drawn.
    }
    EXPECT_EQ(log.count("has no shadow receiver material"), 1U) << log.all();
}

} // namespace
} // namespace Lixel::Tests
