// Scripts that are read again: what is defined anew, and what stays as it was.

#include "ScriptOgre.h"

#include "script/ShadowCameraSetupManager.h"

#include <OgreDataStream.h>
#include <OgreResourceGroupManager.h>
#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

TEST(ReloadedPresetScript, IsReadAgain) {
    ScriptOgre ogre;
    errorsOf(ogre, "shadow_camera_setup A\n{\ntechnique XPSM\nstrength 1\n}\n");
    const ShadowPresetPtr a = preset("A");
    const auto before = a->getSetup();
    auto& manager = ShadowCameraSetupManager::getSingleton();

    ogre.write("my.shadow", "shadow_camera_setup A\n{\ntechnique Uniform\nstrength 3\n}\n"
                            "shadow_camera_setup New\n{\nmaps 2\n}\n");
    EXPECT_EQ(manager.reload("Scripts").size(), 1U);
    EXPECT_EQ(ogre.takeErrors().size(), 1U);
    EXPECT_EQ(a->getSetup(), before) << "an error keeps what is right";
    EXPECT_TRUE(preset("New"));

    ogre.write("my.shadow", "shadow_camera_setup A\n{\ntechnique XPSM\nstrength 3\n}\n");
    EXPECT_EQ(manager.reload("Scripts").size(), 0U);
    EXPECT_EQ(preset("A"), a);
    EXPECT_EQ(a->getSetup()->getParameter("strength"), "3");
    EXPECT_TRUE(preset("New")) << "what is there stays";
}

TEST(ReloadedPresetScript, OfAVariableThatIsNotSetStaysAsItWas) {
    ScriptOgre ogre;
    errorsOf(ogre, "shadow_camera_setup A\n{\nmap_size 64\n}\n");
    auto& manager = ShadowCameraSetupManager::getSingleton();
    const std::string header = "shadow_camera_setup A\n{\nmap_size 512 ";
    for (const char* const line : {"$unset\n}\n", "$b\nset $b \"$unset\"\n}\n"}) {
        ogre.write("my.shadow", header + line + "shadow_camera_setup B : A\n{\n}\n");
        EXPECT_EQ(manager.reload("Scripts").size(), 1U) << line;
        EXPECT_EQ(ogre.takeErrors().size(), 1U) << "and not once more for the child";
        EXPECT_EQ(preset("A")->getSetting("map_size"), "64 64");
    }
    // What the parent lacks, a child may set.
    ogre.write("my.shadow", "abstract shadow_camera_setup P\n{\nmap_size 512 $side\n}\n"
                            "shadow_camera_setup A : P\n{\nset $side 32\n}\n");
    EXPECT_EQ(manager.reload("Scripts").size(), 0U);
    EXPECT_EQ(preset("A")->getSetting("map_size"), "512 32");
}

TEST(ReloadedPresetScript, OfAnotherGroupIsNotReadAgain) {
    ScriptOgre ogre;
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    errorsOf(ogre, "shadow_camera_setup A\n{\nmap_size 64\n}\n");
    groups.createResourceGroup("Others", true);
    std::string script = "shadow_camera_setup A\n{\nmap_size 32\n}\n";
    Ogre::DataStreamPtr stream(
        new Ogre::MemoryDataStream("my.shadow", script.data(), script.size(), false, true));
    ogre.takeErrors();
    ShadowCameraSetupManager::getSingleton().parseScript(stream, "Others");
    const std::vector<std::string> errors = ogre.takeErrors();
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_NE(errors.front().find("'A' is defined already, in my.shadow of group Scripts"),
              std::string::npos)
        << errors.front();
    EXPECT_EQ(preset("A")->getSetting("map_size"), "64 64");
}

TEST(ReloadedPresetScript, IsLoadedAfterItWasPutBack) {
    ScriptOgre ogre;
    errorsOf(ogre, "shadow_camera_setup A\n{\ntechnique XPSM\nstrength 1\n}\n");
    const ShadowPresetPtr a = preset("A");
    const ShadowPreset::State unloaded = a->state();
    ASSERT_TRUE(a->getSetup());
    a->restore(unloaded);
    ASSERT_TRUE(a->getSetup());
    EXPECT_EQ(a->getSetup()->getParameter("strength"), "1");
}

} // namespace
} // namespace Lixel::Tests
