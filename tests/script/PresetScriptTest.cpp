// shadow_camera_setup in scripts, as OGRE reads them: what they define, and what the log says of
// wrong ones.

#include "ScriptOgre.h"

#include "script/ShadowCameraSetupManager.h"
#include "setup/SetupList.h"
#include "setup/ShadowCameraSetups.h"

#include <OgreException.h>
#include <OgreResourceGroupManager.h>
#include <OgreScriptCompiler.h>
#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

TEST(PresetScript, DefinesASetupAndWhatGoesWithIt) {
    ScriptOgre ogre;
    EXPECT_EQ(errorsOf(ogre, R"(
shadow_camera_setup Sun
{
    technique XPSM
    strength 1.5 // an option of the technique
    guarded off
    filter_radius 2
    map_size 512 2048
    map_format pf_depth16
    shadow_technique texture_modulative
    far_distance 1e3
    self_shadow no
    caster_material My/Caster
    receiver_material "My Receiver"
}
)"),
              "");
    ASSERT_TRUE(preset("Sun"));
    const ShadowPreset& sun = *preset("Sun");
    EXPECT_EQ(sun.getOrigin(), "my.shadow");
    EXPECT_EQ(sun.getSetting("technique"), "XPSM");
    EXPECT_EQ(sun.getSetting("map_size"), "512 2048");
    EXPECT_EQ(sun.getSetting("map_format"), "PF_DEPTH16");
    EXPECT_EQ(sun.getSetting("shadow_technique"), "texture_modulative");
    EXPECT_EQ(sun.getSetting("far_distance"), "1000");
    EXPECT_EQ(sun.getSetting("self_shadow"), "false");
    EXPECT_EQ(sun.getSetting("caster_material"), "My/Caster");
    EXPECT_EQ(sun.getSetting("receiver_material"), "My Receiver");
    EXPECT_EQ(sun.getSetting("filter"), "bilinear");
    EXPECT_EQ(sun.getSetting("no_such"), "");
    const auto setup = std::dynamic_pointer_cast<XPSMShadowCameraSetup>(preset("Sun")->getSetup());
    ASSERT_TRUE(setup);
    EXPECT_EQ(setup->getOptions().strength, 1.5);
    EXPECT_FALSE(setup->getOptions().guarded);
    EXPECT_EQ(setup->getFilterRadius(), 2.0F);
}

TEST(PresetScript, DefinesEverySetupWithEveryOption) {
    ScriptOgre ogre;
    for (const SetupKind& kind : setupKinds()) {
        const auto standard = kind.create();
        std::string script =
            "shadow_camera_setup All\n{\ntechnique " + std::string(kind.name) + "\n";
        std::vector<Option> options(kind.options.begin(), kind.options.end());
        options.insert(options.end(), CommonOptions::declared().begin(),
                       CommonOptions::declared().end());
        for (const Option& option : options) {
            const std::string value = standard->getParameter(std::string(option.keyword));
            if (!value.empty()) script += std::string(option.keyword) + " " + value + "\n";
        }
        EXPECT_EQ(errorsOf(ogre, script + "}\n"), "") << kind.name;
        ASSERT_TRUE(preset("All"));
        EXPECT_EQ(typeid(*preset("All")->getSetup()), typeid(*standard)) << kind.name;
    }
}

TEST(PresetScript, GivesCascadesTheirSlices) {
    ScriptOgre ogre;
    EXPECT_EQ(errorsOf(ogre, "shadow_camera_setup Land\n{\ntechnique Cascades\nslices Uniform\n"
                             "stable true\nfollow_receivers false\nsplit_depths 1 2.5 10\n"
                             "maps 4\n}\n"),
              "");
    const auto cascades =
        std::dynamic_pointer_cast<CascadesShadowCameraSetup>(preset("Land")->getSetup());
    ASSERT_TRUE(cascades);
    EXPECT_FALSE(cascades->getOptions().followReceivers);
    EXPECT_EQ(cascades->getOptions().vsSplitDepths, (std::vector<double>{1.0, 2.5, 10.0}));
    EXPECT_NE(errorsOf(ogre, "shadow_camera_setup Land\n{\ntechnique Cascades\nstable true\n}\n")
                  .find("there is no keyword 'stable' of a shadow_camera_setup of Cascades of "
                        "Optimal"),
              std::string::npos);
}

TEST(PresetScript, InheritsAcrossFilesWithVariables) {
    ScriptOgre ogre;
    ogre.write("base.shadow", "set $side 256\nabstract shadow_camera_setup Base\n{\n"
                              "    set $strength 0.5\n    technique XPSM\n    maps 1\n"
                              "    map_size $side\n    strength $strength\n}\n");
    EXPECT_EQ(errorsOf(ogre, "import Base from base.shadow\n"
                             "shadow_camera_setup Child : Base\n{\n    maps 1\n}\n"
                             "shadow_camera_setup Grandchild : Child\n{\n"
                             "    set $strength 3\n    map_size 64\n}\n"),
              "");
    EXPECT_FALSE(preset("Base")) << "abstract";
    ASSERT_TRUE(preset("Child") && preset("Grandchild"));
    EXPECT_EQ(preset("Child")->getSetting("map_size"), "256 256");
    EXPECT_EQ(preset("Grandchild")->getSetting("map_size"), "64 64");
    EXPECT_EQ(preset("Child")->getSetup()->getParameter("strength"), "0.5");
    EXPECT_EQ(preset("Grandchild")->getSetup()->getParameter("strength"), "3");
}

TEST(PresetScript, StandsInMaterialFilesToo) {
    ScriptOgre ogre;
    EXPECT_EQ(errorsOf(ogre, "shadow_camera_setup InMaterial\n{\n    technique LiSPSM\n}\n",
                       "my.material"),
              "");
    ASSERT_TRUE(preset("InMaterial"));
    EXPECT_EQ(preset("InMaterial")->getSetting("technique"), "LiSPSM");
}

TEST(PresetScript, IsListedAndGoesWithItsGroup) {
    ScriptOgre ogre;
    errorsOf(ogre, "shadow_camera_setup B\n{\ntechnique XPSM\n}\n"
                   "shadow_camera_setup A\n{\ntechnique XPSM\n}\n");
    const std::vector<ShadowPresetPtr> all = ShadowCameraSetupManager::list("Scripts");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all.front()->getName(), "A");
    EXPECT_EQ(ShadowCameraSetupManager::list("General").size(), 0U);
    try {
        ShadowCameraSetupManager::getByName("C");
        FAIL();
    } catch (const Ogre::Exception& exception) {
        EXPECT_NE(exception.getDescription().find("there is no shadow_camera_setup 'C'; there "
                                                  "are: A, B"),
                  std::string::npos);
    }
    const std::shared_ptr<FittedShadowCameraSetup> kept = all.front()->getSetup();
    EXPECT_TRUE(all.front()->isLoaded());
    Ogre::ResourceGroupManager::getSingleton().unloadResourceGroup("Scripts", false);
    EXPECT_FALSE(all.front()->isLoaded());
    EXPECT_TRUE(all.front()->getSetup()) << "loaded again where it is used";
    Ogre::ResourceGroupManager::getSingleton().clearResourceGroup("Scripts");
    EXPECT_FALSE(preset("A"));
    EXPECT_EQ(kept->getParameter("strength"), "2") << "what uses it goes on";
}

struct WrongScript {
    const char* name;
    const char* script;
    const char* error;
};

/// Each in a file of its own, with a right setup after what is wrong.
const WrongScript WrongScripts[] = {
    {"UnknownKeyword", "shadow_camera_setup Bad\n{\n    strenght 1\n}\n",
     "invalid parameters in my.shadow(3): there is no keyword 'strenght' of a shadow_camera_setup "
     "of XPSM; there are: technique, slices, maps, map_size, map_format, shadow_technique, filter, "
     "far_distance, self_shadow, caster_material, receiver_material, strength, epsilon_w, guarded, "
     "filter_radius, depth_bias, mesh_hulls"},
    {"OptionOfAnother", "shadow_camera_setup Bad\n{\n    technique Uniform\n    strength 1\n}\n",
     "my.shadow(4): there is no keyword 'strength' of a shadow_camera_setup of Uniform"},
    {"UnknownTechnique", "shadow_camera_setup Bad\n{\n    technique PSSM\n}\n",
     "my.shadow(3): technique: 'PSSM' is not one of Uniform, "},
    {"SlicesOfCascades", "shadow_camera_setup Bad\n{\n    slices Cascades\n}\n",
     "my.shadow(3): slices: 'Cascades' is not one of Uniform, "},
    {"SlicesOfNothing", "shadow_camera_setup Bad\n{\n    slices Uniform\n}\n",
     "my.shadow(3): slices: only 'technique Cascades' has slices, and this is XPSM"},
    {"NotANumber", "shadow_camera_setup Bad\n{\n    strength much\n}\n",
     "my.shadow(3): strength: 'much' is not a number, at least 0"},
    {"OutOfRange", "shadow_camera_setup Bad\n{\n    epsilon_w 1.5\n}\n",
     "my.shadow(3): epsilon_w: '1.5' is not a number, above 0 and at most 1"},
    {"NotANumberAtAll", "shadow_camera_setup Bad\n{\n    far_distance nan\n}\n",
     "my.shadow(3): far_distance: 'nan' is not 0, or a number of world units, at least 1e-18 and "
     "at "
     "most 1e+18"},
    {"DistanceOfNoFloat", "shadow_camera_setup Bad\n{\n    far_distance 1e300\n}\n",
     "my.shadow(3): far_distance: '1e300' is not 0, or a number of world units, at least 1e-18"},
    {"DistanceThatFloatsRoundToZero", "shadow_camera_setup Bad\n{\n    far_distance 1e-50\n}\n",
     "my.shadow(3): far_distance: '1e-50' is not 0, or a number of world units, at least 1e-18"},
    {"SlicesThatCount",
     "shadow_camera_setup Bad\n{\n    slices XPSM\n    slices PSM\n    slices Cascades\n}\n",
     "my.shadow(4): slices: only 'technique Cascades' has slices, and this is XPSM"},
    {"NotAFlag", "shadow_camera_setup Bad\n{\n    guarded maybe\n}\n",
     "my.shadow(3): guarded: 'maybe' is not true or false"},
    {"TooManyMaps", "shadow_camera_setup Bad\n{\n    maps 9\n}\n",
     "my.shadow(3): maps: '9' is not a whole number, at least 1 and at most 8"},
    {"WrongSize", "shadow_camera_setup Bad\n{\n    map_size 1024 x 1024\n}\n",
     "my.shadow(3): map_size: '1024 x 1024' is not one or two whole numbers of texels"},
    {"UnknownFormat", "shadow_camera_setup Bad\n{\n    map_format float32\n}\n",
     "my.shadow(3): map_format: 'float32' is not one of OGRE's pixel formats"},
    {"UnknownShadowTechnique", "shadow_camera_setup Bad\n{\n    shadow_technique stencil\n}\n",
     "my.shadow(3): shadow_technique: 'stencil' is not one of texture_additive, "},
    {"UnknownFilter", "shadow_camera_setup Bad\n{\n    filter pcf\n}\n",
     "my.shadow(3): filter: 'pcf' is not one of nearest, bilinear"},
    {"NoValue", "shadow_camera_setup Bad\n{\n    maps\n}\n", "my.shadow(3): 'maps' has no value"},
    {"UndefinedVariable", "shadow_camera_setup Bad\n{\n    maps $many\n}\n",
     "undefined variable in my.shadow(3): $many"},
    {"DefinedTwice", "shadow_camera_setup Bad\n{\n}\nshadow_camera_setup Bad\n{\n    maps 2\n}\n",
     "my.shadow(4): 'Bad' is defined already, in my.shadow"},
    {"MissingParent", "shadow_camera_setup Bad : Missing\n{\n}\n",
     "there is no 'Missing' before it, nor in what is imported in my.shadow(1); the file is left "
     "out"},
    {"MissingBrace", "shadow_camera_setup Bad\n{\n    maps 2\n",
     "is a '}' missing before this? in my.shadow(4); the file is left out"},
    {"NoName", "shadow_camera_setup\n{\n}\n", "needs one name in my.shadow(1); the file is left"},
    {"Material", "material Bad\n{\n}\n", "'material' does not belong here: a .shadow file has"},
    {"ImportOfItself", "import * from my.shadow\n",
     "circular import of 'my.shadow' in my.shadow(1); the file is left out"},
    {"VariableOfItself", "set $a \"$a\"\n",
     "the variable $a is defined in terms of itself in my.shadow(1)"},
    {"ImportOfNothing", "import * from nothing.shadow\n",
     "there is no file 'nothing.shadow' in my.shadow(1); the file is left out"},
};

class WrongPresetScript : public testing::TestWithParam<WrongScript> {};

TEST_P(WrongPresetScript, IsLoggedWithItsLineAndTheRestIsRead) {
    ScriptOgre ogre;
    const std::string good = "shadow_camera_setup Good\n{\n    maps 1\n}\n";
    ogre.write("other.shadow", "shadow_camera_setup Other\n{\n    maps 1\n}\n");
    const std::string errors = errorsOf(ogre, GetParam().script + good);
    EXPECT_NE(errors.find(GetParam().error), std::string::npos) << errors;
    EXPECT_TRUE(preset("Other")) << "other files go on";
    const bool isLeftOut = errors.find("the file is left out") != std::string::npos;
    EXPECT_EQ(preset("Good") == nullptr, isLeftOut);
    if (const ShadowPresetPtr bad = preset("Bad")) {
        EXPECT_TRUE(bad->getSetup()) << "without the line that is wrong";
    }
}

INSTANTIATE_TEST_SUITE_P(All, WrongPresetScript, testing::ValuesIn(WrongScripts),
                         [](const auto& wrong) { return wrong.param.name; });

TEST(PresetScript, TellsTheListenerOfAnApplication) {
    struct Listener : Ogre::ScriptCompilerListener {
        void handleError(Ogre::ScriptCompiler*, Ogre::uint32, const Ogre::String&, int,
                         const Ogre::String&) override {
            ++errors;
        }
        int errors = 0;
    } listener;
    ScriptOgre ogre;
    auto& compilers = Ogre::ScriptCompilerManager::getSingleton();
    compilers.setListener(&listener);
    errorsOf(ogre, "shadow_camera_setup A\n{\nmaps 9\nmap_size $unset\n}\n");
    // OGRE's own, and that of the plugin.
    EXPECT_EQ(listener.errors, 2);
    EXPECT_EQ(compilers.getListener(), &listener);
    compilers.setListener(nullptr);
}

TEST(PresetScript, MayBeginWithAByteOrderMark) {
    ScriptOgre ogre;
    EXPECT_EQ(errorsOf(ogre, "\xEF\xBB\xBFshadow_camera_setup A\n{\nmaps 2\n}\n"), "");
    EXPECT_TRUE(preset("A"));
}

TEST(PresetScript, OfAWrongParentIsSaidOnce) {
    ScriptOgre ogre;
    const std::string errors = errorsOf(ogre, "shadow_camera_setup A\n{\nmaps 9\n}\n"
                                              "shadow_camera_setup B : A\n{\nmap_size 64\n}\n");
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    EXPECT_EQ(preset("B")->getSetting("map_size"), "64 64");
    // The file of B does not translate A itself.
    ogre.write("my.shadow", "shadow_camera_setup A\n{\nmaps 9\n}\n");
    ogre.write("other.shadow", "import * from my.shadow\nshadow_camera_setup C : A\n{\n}\n"
                               "shadow_camera_setup D : A\n{\n}\n");
    ogre.takeErrors();
    ogre.initialise();
    EXPECT_EQ(ogre.takeErrors().size(), 2U) << "once for each file that is read";
}

} // namespace
} // namespace Lixel::Tests
