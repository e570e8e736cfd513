// The structure of scripts, and what OGRE's compiler would not survive.

#include "script/ScriptCheck.h"

#include "script/ScriptTokens.h"

#include <gtest/gtest.h>

#include <map>

namespace Lixel {
namespace {

using Files = std::map<std::string, std::string>;

/// "FILE(LINE): what"; empty for a script without a fault.
std::string faultOf(const std::string& script, const Files& files = {}) {
    const auto fault = findScriptFault(script, "my.shadow", [&](const std::string& file) {
        const auto found = files.find(file);
        return found == files.end() ? std::nullopt : std::optional(found->second);
    });
    return fault ? fault->file + "(" + std::to_string(fault->line) + "): " + fault->what : "";
}

void expectFault(const std::string& script, const std::string& part, const Files& files = {}) {
    EXPECT_NE(faultOf(script, files).find(part), std::string::npos)
        << script << "\nsays '" << faultOf(script, files) << "' instead of '" << part << "'";
}

const std::string Good = "shadow_camera_setup Good\n{\n    technique XPSM\n}\n";

TEST(ScriptTokens, AreOgres) {
    const ScriptTokens result = tokensOf("a:b {\r\n\r\n \"x \\\" y\" $v // no\n/*/ c /* d\n*/ e/f");
    std::string text;
    for (const ScriptToken& token : result.tokens)
        text += token.type == ScriptToken::Type::Newline ? "|" : "[" + token.text + "]";
    EXPECT_EQ(text, "[a][:][b][{]|[x \" y][$v]|[c][e/f]");
    EXPECT_EQ(result.tokens.back().line, 5U);
    EXPECT_EQ(result.openQuote, 0U);
    EXPECT_EQ(tokensOf("a\n\"b\nc").openQuote, 2U);
}

TEST(ScriptCheck, FindsNoFaultWhereThereIsNone) {
    EXPECT_EQ(faultOf(""), "");
    EXPECT_EQ(faultOf("// nothing\n"), "");
    EXPECT_EQ(faultOf(Good), "");
    EXPECT_EQ(faultOf("set $a 1\nset $b \"$a 2\"\n"
                      "abstract shadow_camera_setup \"A B\" {\n set $c 3\n split_depths $b $c\n}\n"
                      "shadow_camera_setup C:\"A B\"\n\n{ maps 3 }\n"),
              "");
    const Files files{{"other.shadow", Good},
                      {"Lixel.material", "import Good from other.shadow\nmaterial M\n{\ntechnique "
                                         "{\npass Light : P {\n} } }\nmaterial N : M {\n}\n"}};
    EXPECT_EQ(faultOf("import * from \"Lixel.material\"\nimport Good from other.shadow\n"
                      "shadow_camera_setup D : Good { }",
                      files),
              "");
}

TEST(ScriptCheck, FindsWrongStructure) {
    expectFault("shadow_camera_setup A\n{\n", "my.shadow(2): a block that begins");
    expectFault(Good + "}\n", "my.shadow(5): '}' without a '{'");
    expectFault("{\n}\n", "has to begin with a word");
    expectFault("shadow_camera_setup A {maps 3\n}\n", "my.shadow(1): { needs a space");
    expectFault("shadow_camera_setup A : {\n}\n", "expected the name of a parent");
    expectFault("shadow_camera_setup A : B : C {\n}\n", "a second ':'");
    expectFault("shadow_camera_setup A : B\nmaps 3\n", "has to be followed by '{'");
    expectFault("shadow_camera_setup {\n}\n", "needs one name");
    expectFault("shadow_camera_setup \"\" {\n}\n", "needs one name");
    expectFault("shadow_camera_setup A B {\n}\n", "needs one name");
    expectFault("abstract {\n}\n", "'abstract' does not belong here");
    expectFault("material A {\n}\n", "'material' does not belong here");
    expectFault("shadow_camera_setup A {\n options {\n }\n}\n",
                "my.shadow(2): a shadow_camera_setup has no blocks");
    expectFault("maps 3\n", "expected: shadow_camera_setup NAME");
    expectFault("shadow_camera_setup A {\n technique \"XPSM\n}\n",
                "my.shadow(2): a quotation mark");
}

TEST(ScriptCheck, FindsImportsThatOgreDoesNotSurvive) {
    expectFault("import", "expected: import NAME");
    expectFault("import A", "expected: import NAME");
    expectFault("import A from", "expected: import NAME");
    expectFault("import A of b.shadow\n", "expected: import NAME");
    expectFault("shadow_camera_setup A {\n import * from b.shadow\n}\n", "outside of all blocks");
    expectFault("import * from my.shadow\n", "my.shadow(1): 'my.shadow' is imported by what",
                {{"my.shadow", Good}});
    expectFault("import * from a.shadow\n" + Good, "b.shadow(6): 'a.shadow' is imported by what",
                {{"a.shadow", "import * from b.shadow\n" + Good},
                 {"b.shadow", Good + "\nimport * from a.shadow\n"}});
    expectFault("import * from none.shadow\n", "there is no file 'none.shadow'");
    expectFault("import A from good.shadow\n", "has no 'A'; it has Good", {{"good.shadow", Good}});
    expectFault("import * from empty.shadow\n", "it has nothing", {{"empty.shadow", ""}});
    expectFault("import * from bad.shadow\n", "bad.shadow(1): '}'", {{"bad.shadow", "}"}});
}

TEST(ScriptCheck, FindsParentsThatAreNotThere) {
    expectFault("shadow_camera_setup A : B {\n}\n", "there is no 'B' before it");
    expectFault("shadow_camera_setup A : A {\n}\n", "there is no 'A' before it");
    expectFault("shadow_camera_setup A : Good {\n}\n" + Good, "there is no 'Good' before it");
}

TEST(ScriptCheck, FindsVariablesThatOgreDoesNotSurvive) {
    expectFault("set $a \"$a\"\n" + Good, "the variable $a is set to itself");
    expectFault("set $a \"1 $b\"\n" + Good + "shadow_camera_setup B {\n set $b $c\n}\n",
                "expected: set $NAME VALUE");
    expectFault("set $a \"1 $b\"\nset $b \"$c 2\"\nset $c $a\n", "expected: set $NAME VALUE");
    expectFault("set $a \"1 $b\"\nset $b \"$c 2\"\nset $c \"$a\"\n", "is set to itself");
    expectFault("set $a \"1 }\"\n", "the value of $a has more than words");
    expectFault("set $a\n", "expected: set $NAME VALUE");
    expectFault("set a 1\n", "expected: set $NAME VALUE");
    expectFault("set", "expected: set $NAME VALUE");
}

TEST(ScriptCheck, LimitsBlocksWithinBlocks) {
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "a {\n";
    expectFault("import * from deep.material\n", "too many blocks", {{"deep.material", deep}});
}

} // namespace
} // namespace Lixel
