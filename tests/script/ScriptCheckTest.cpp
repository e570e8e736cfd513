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
    EXPECT_EQ(tokensOf(R"("a\\b \c")").tokens.front().text, R"(a\b \c)");
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
    expectFault("shadow_camera_setup A {\n}\n/* all the rest\n", "my.shadow(3): a comment");
}

TEST(ScriptCheck, FindsImportsThatOgreDoesNotSurvive) {
    expectFault("import", "expected: import NAME");
    expectFault("import A", "expected: import NAME");
    expectFault("import A from", "expected: import NAME");
    expectFault("import A of b.shadow\n", "expected: import NAME");
    expectFault("shadow_camera_setup A {\n import * from b.shadow\n}\n", "outside of all blocks");
    expectFault("import * from my.shadow\n", "my.shadow(1): circular import of 'my.shadow'",
                {{"my.shadow", Good}});
    expectFault("import * from a.shadow\n" + Good, "b.shadow(6): circular import of 'a.shadow'",
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
    // What is not imported of a file is no parent.
    const Files files{{"two.shadow", Good + "shadow_camera_setup Other {\n}\n"},
                      {"both.shadow", "import * from two.shadow\nshadow_camera_setup C {\n}\n"}};
    expectFault("import Good from two.shadow\nshadow_camera_setup A : Other {\n}\n",
                "my.shadow(2): there is no 'Other' before it", files);
    EXPECT_EQ(faultOf("import Good from two.shadow\nimport Other from two.shadow\n"
                      "shadow_camera_setup A : Other Good {\n}\n",
                      files),
              "");
    EXPECT_EQ(faultOf("import C from both.shadow\nshadow_camera_setup A : Other {\n}\n", files), "")
        << "OGRE has one table for the imports of all files";
}

TEST(ScriptCheck, FindsVariablesThatOgreDoesNotSurvive) {
    expectFault("set $a \"$a\"\n" + Good,
                "my.shadow(1): the variable $a is defined in terms of itself");
    expectFault("set $a \"1 $b\"\n" + Good + "shadow_camera_setup B {\n set $b $c\n}\n",
                "expected: set $NAME VALUE");
    expectFault("set $a \"1 $b\"\nset $b \"$c 2\"\nset $c $a\n", "expected: set $NAME VALUE");
    expectFault("set $a \"1 $b\"\nset $b \"$c 2\"\nset $c \"$a\"\n",
                "my.shadow(3): the variable $c is defined in terms of itself");
    expectFault("set $a \"1 }\"\n", "the value of $a may contain only words and variables");
    expectFault("set $a\n", "expected: set $NAME VALUE");
    expectFault("set a 1\n", "expected: set $NAME VALUE");
    expectFault("set", "expected: set $NAME VALUE");
}

TEST(ScriptCheck, BlamesTheFileThatSetsAVariable) {
    expectFault("import * from good.shadow\n",
                "good.shadow(5): the variable $a is defined in terms",
                {{"good.shadow", Good + "set $a \"$a\"\n"}});
}

TEST(ScriptCheck, FindsByteOrderMarksOfImportedFiles) {
    expectFault("import * from good.shadow\n", "good.shadow(1): begins with a byte order mark",
                {{"good.shadow", "\xEF\xBB\xBF" + Good}});
}

/// Each names the one before it so often.
std::string variables(int count, int times) {
    std::string script = "set $v0 1\n";
    for (int i = 1; i < count; ++i) {
        script += "set $v" + std::to_string(i) + " \"";
        for (int j = 0; j < times; ++j)
            script += " $v" + std::to_string(i - 1);
        script += "\"\n";
    }
    return script;
}

TEST(ScriptCheck, LimitsWhatVariablesStandFor) {
    EXPECT_EQ(faultOf(variables(9, 2)), "");
    expectFault(variables(100, 2), "my.shadow(11): the variable $v10 stands for more than 1000");
    EXPECT_EQ(faultOf(variables(32, 1)), "");
    expectFault(variables(100000, 1), "more than 32 variables within one another");
}

TEST(ScriptCheck, LimitsInheritedLines) {
    std::string script = "shadow_camera_setup P0\n{\n    maps 1\n}\n";
    for (int i = 1; i < 40; ++i) {
        const std::string parent = "P" + std::to_string(i - 1);
        script += "shadow_camera_setup P" + std::to_string(i) + " : " + parent + " " + parent +
                  "\n{\n}\n";
    }
    expectFault(script, "'P14' has more than 10000 lines with those of its parents");
}

TEST(ScriptCheck, LimitsBlocksWithinBlocks) {
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "a {\n";
    expectFault("import * from deep.material\n", "too many blocks", {{"deep.material", deep}});
}

} // namespace
} // namespace Lixel
