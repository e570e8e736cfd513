// Materials that inherit Lixel's: the child's programs win, wherever in the pass they are written.

#include "MaterialScene.h"

#include <algorithm>
#include <array>

namespace Lixel::Tests {
namespace {

constexpr const char* Vertex = "vertex_program_ref Test/VP\n{\n}\n";
constexpr const char* Fragment = "fragment_program_ref Test/LightFP\n{\n}\n";
constexpr const char* Unit = "texture_unit DiffuseMap\n{\ntexture Any.png\n}\n";

void parse(const std::string& script) {
    Ogre::DataStreamPtr stream = std::make_shared<Ogre::MemoryDataStream>(
        "Inheritance.material", const_cast<char*>(script.data()), script.size(), false, true);
    Ogre::MaterialManager::getSingleton().parseScript(stream, Ogre::RGN_DEFAULT);
}

class Inheritance : public testing::TestWithParam<const char*> {
protected:
    MaterialScene scene{Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, ""};
};

TEST_P(Inheritance, OwnProgramsWinInAnyOrder) {
    std::array<std::string, 3> lines{Vertex, Fragment, Unit};
    std::sort(lines.begin(), lines.end());
    int number = 0;
    do {
        const std::string name = "Child" + std::to_string(++number);
        parse("import * from \"Lixel.material\"\nmaterial " + name + " : " + GetParam() +
              "\n{\ntechnique\n{\npass Light\n{\n" + lines[0] + lines[1] + lines[2] + "}\n}\n}\n");
        const Ogre::MaterialPtr child = Ogre::MaterialManager::getSingleton().getByName(name);
        ASSERT_TRUE(child);
        const Ogre::Pass& pass = *child->getTechnique(0)->getPass("Light");
        const std::string order = lines[0] + lines[1] + lines[2];
        EXPECT_EQ(pass.getVertexProgramName(), "Test/VP") << order;
        EXPECT_EQ(pass.getFragmentProgramName(), "Test/LightFP") << order;
        EXPECT_EQ(pass.getTextureUnitState(0)->getName(), "DiffuseMap") << order;
        EXPECT_EQ(pass.getTextureUnitState(0)->getTextureName(), "Any.png") << order;
        for (unsigned short i = 1; i < pass.getNumTextureUnitStates(); ++i)
            EXPECT_EQ(pass.getTextureUnitState(i)->getContentType(),
                      Ogre::TextureUnitState::CONTENT_SHADOW);
    } while (std::next_permutation(lines.begin(), lines.end()));
    EXPECT_EQ(number, 6);
}

TEST_P(Inheritance, OwnUnitsComeLastWhereTheyAreWrittenLast) {
    parse("import * from \"Lixel.material\"\nmaterial ChildWithUnit : " + std::string(GetParam()) +
          "\n{\ntechnique\n{\npass Light\n{\n" + Unit + "texture_unit Own\n{\n}\n}\n}\n}\n");
    const Ogre::MaterialPtr child =
        Ogre::MaterialManager::getSingleton().getByName("ChildWithUnit");
    ASSERT_TRUE(child);
    const auto& units = child->getTechnique(0)->getPass("Light")->getTextureUnitStates();
    EXPECT_EQ(units.front()->getName(), "DiffuseMap");
    EXPECT_EQ(units.back()->getName(), "Own");
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Inheritance,
                         testing::Values("Lixel/Surface", "Lixel/Surface/Integrated",
                                         "Lixel/Surface/Integrated/Maps2",
                                         "Lixel/Surface/Integrated/Maps3",
                                         "Lixel/Surface/Integrated/Maps4",
                                         "Lixel/Surface/Integrated/Maps6"),
                         [](const auto& surface) {
                             std::string name = surface.param;
                             std::erase(name, '/');
                             return name;
                         });

} // namespace
} // namespace Lixel::Tests
