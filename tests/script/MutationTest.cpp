// Scripts that are wrong in ways that nobody thought of: none crashes, hangs, or keeps other files
// from being read.

#include "ScriptOgre.h"

#include "script/ShadowCameraSetupManager.h"

#include <OgreDataStream.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace Lixel::Tests {
namespace {

const std::vector<std::string> Seeds{
    "// a comment\nset $side \"512 256\"\nimport Base from \"base.shadow\"\n"
    "shadow_camera_setup A : Base\n{\n    set $strength 0.5\n    technique XPSM\n"
    "    map_size $side\n    strength $strength\n    caster_material \"My \\\"Caster\\\"\"\n}\n"
    "/* more */ abstract shadow_camera_setup B\n{\n    maps 3 }\n",
    "import * from other.shadow\nset $a 1\nset $b \"$a 2\"\nshadow_camera_setup C\r\n{\r\n"
    "  technique Cascades\r\n  split_depths $b 3.5\r\n  slices Uniform\r\n  stable on\r\n}\r\n"
    "shadow_camera_setup \"D E\" : C Other\n{\n}\n"};

/// Pieces that mean something to OGRE's lexer or parser.
const std::vector<std::string> Pieces{"{",
                                      "}",
                                      ":",
                                      "\"",
                                      "$",
                                      "$a",
                                      "$b",
                                      "\n",
                                      " ",
                                      "import ",
                                      "set ",
                                      "from ",
                                      "*",
                                      "abstract ",
                                      "/*",
                                      "*/",
                                      "//",
                                      "\\",
                                      "\r",
                                      "\t",
                                      "A",
                                      "Base",
                                      "my.shadow",
                                      "base.shadow",
                                      "shadow_camera_setup ",
                                      "material ",
                                      "technique ",
                                      "maps ",
                                      "nan",
                                      "-1",
                                      "1e999",
                                      std::string(1, '\0'),
                                      "set $a \"$b\"\n",
                                      "set $b \"$a\"\n",
                                      "import * from my.shadow\n",
                                      "\xff\xfe",
                                      "other.material"};

class Mutator {
public:
    explicit Mutator(unsigned seed) : mRandom(seed) {}

    std::string mutate(std::string script) {
        for (std::size_t i = below(6) + 1; i > 0; --i)
            mutateOnce(script);
        return script;
    }

    std::size_t below(std::size_t end) { return mRandom() % end; }

private:
    void mutateOnce(std::string& script) {
        const std::size_t at = below(script.size() + 1);
        const std::size_t length = std::min<std::size_t>(below(20), script.size() - at);
        switch (below(5)) {
        case 0:
            script.erase(at, length);
            break;
        case 1:
            script.insert(at, Pieces[below(Pieces.size())]);
            break;
        case 2:
            script.insert(below(script.size() + 1), script.substr(at, length));
            break;
        case 3:
            script.replace(at, length, Pieces[below(Pieces.size())]);
            break;
        default:
            script.resize(at);
            break;
        }
    }

    std::mt19937 mRandom;
};

/// LIXEL_MUTATIONS says how many; by hand it may be more.
std::size_t mutations() {
    const char* const wanted = std::getenv("LIXEL_MUTATIONS");
    return wanted == nullptr ? 10000 : std::strtoul(wanted, nullptr, 10);
}

TEST(MutatedPresetScripts, NeitherCrashNorHangNorSpoilOthers) {
    ScriptOgre ogre;
    ogre.write("base.shadow", "abstract shadow_camera_setup Base\n{\n    maps 2\n}\n");
    ogre.write("other.shadow", "shadow_camera_setup Other\n{\n    maps 3\n}\n");
    ogre.write("other.material", "import * from base.shadow\nmaterial Some\n{\n}\n");
    ogre.write("my.shadow", "");
    ogre.initialise();
    auto& manager = ShadowCameraSetupManager::getSingleton();
    Mutator mutator(7);
    std::size_t read = 0, leftOut = 0;
    for (std::size_t i = 0; i < mutations(); ++i) {
        const std::string script = mutator.mutate(Seeds[mutator.below(Seeds.size())]);
        Ogre::DataStreamPtr stream(new Ogre::MemoryDataStream(
            "my.shadow", const_cast<char*>(script.data()), script.size(), false, true));
        manager.parseScript(stream, "Scripts");
        bool isLeftOut = false;
        for (const std::string& error : ogre.takeErrors())
            isLeftOut = isLeftOut || error.find("; the file is left out") != std::string::npos;
        ++(isLeftOut ? leftOut : read);
        manager.removeAll();
    }
    // Both outcomes must be common.
    EXPECT_GT(read, mutations() / 20);
    EXPECT_GT(leftOut, mutations() / 20);
    ogre.initialise();
    EXPECT_TRUE(ShadowCameraSetupManager::findByName("Other"));
}

} // namespace
} // namespace Lixel::Tests
