#include "script/ScriptCheck.h"

#include "scene/NameList.h"
#include "script/ScriptTokens.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace Lixel {
namespace {

using Type = ScriptToken::Type;

/// Blocks within blocks. OGRE's compiler recurses into them; a material needs four.
constexpr std::size_t GreatestDepth = 32;

bool isName(const ScriptToken& token) {
    return token.type == Type::Word || token.type == Type::Quote;
}

struct Import {
    std::string target; ///< an object's name, or "*"
    std::string file;
    unsigned line;
};

/// What a check needs to know of a file.
struct ScriptOutline {
    std::vector<std::string> objects; ///< names of those at the top
    std::vector<Import> imports;
    struct Parent {
        std::string name;
        std::size_t before; ///< so many objects of the file stand before it
        unsigned line;
    };
    /// Of shadow_camera_setups.
    std::vector<Parent> parents;
};

/// All variables, each with those that its values name.
using VariableUses = std::map<std::string, std::set<std::string>>;

/// Goes through one file's statements.
class Reader {
public:
    Reader(const std::vector<ScriptToken>& tokens, const std::string& file, bool takesSetupsAlone,
           VariableUses& uses)
        : mTokens(tokens), mFile(file), mTakesSetupsAlone(takesSetupsAlone), mUses(uses) {}

    /// @return whether there is no fault
    bool read() {
        while (skipNewlines(), mNext < mTokens.size())
            if (!readStatement()) return false;
        return mDepth == 0 || fail(mTokens.back(), "a block that begins with '{' has no '}'");
    }

    ScriptOutline outline;
    ScriptFault fault{};

private:
    const ScriptToken* peek(std::size_t ahead = 0) const {
        return mNext + ahead < mTokens.size() ? &mTokens[mNext + ahead] : nullptr;
    }

    void skipNewlines() {
        while (mNext < mTokens.size() && mTokens[mNext].type == Type::Newline)
            ++mNext;
    }

    bool fail(const ScriptToken& token, const std::string& what) {
        fault = {mFile, token.line, what};
        return false;
    }

    bool readStatement() {
        const ScriptToken& first = *peek();
        if (first.type == Type::RightBrace) {
            if (mDepth == 0) return fail(first, "'}' without a '{'");
            --mDepth;
            ++mNext;
            return true;
        }
        if (first.type != Type::Word) return fail(first, "a line has to begin with a word");
        if (first.text == "import") return readImport(first);
        if (first.text == "set") return readVariable(first);
        return readObjectOrProperty(first);
    }

    bool readImport(const ScriptToken& first) {
        const ScriptToken *target = peek(1), *from = peek(2), *file = peek(3), *end = peek(4);
        if (mDepth != 0) return fail(first, "import belongs outside of all blocks");
        if (target == nullptr || !isName(*target) || from == nullptr || from->text != "from" ||
            file == nullptr || !isName(*file) || (end != nullptr && end->type != Type::Newline))
            return fail(first, "expected: import NAME from \"FILE\", or import * from \"FILE\"");
        outline.imports.push_back({target->text, file->text, first.line});
        mNext += 4;
        return true;
    }

    bool readVariable(const ScriptToken& first) {
        const ScriptToken *variable = peek(1), *value = peek(2), *end = peek(3);
        if (variable == nullptr || variable->type != Type::Variable || value == nullptr ||
            !isName(*value) ||
            (end != nullptr && end->type != Type::Newline && end->type != Type::RightBrace))
            return fail(first,
                        "expected: set $NAME VALUE, with a value of several words in quotes");
        std::set<std::string>& uses = mUses[variable->text];
        const ScriptTokens parts = tokensOf(value->text);
        for (const ScriptToken& part : parts.tokens) {
            if (!isName(part) && part.type != Type::Variable)
                return fail(first, "the value of " + variable->text + " has more than words");
            if (part.type == Type::Variable) uses.insert(part.text);
        }
        if (parts.openQuote != 0)
            return fail(first, "the value of " + variable->text +
                                   " has one quotation mark without another");
        mNext += 3;
        return true;
    }

    /// Words up to the end of the line, or a header and its block.
    bool readObjectOrProperty(const ScriptToken& first) {
        std::size_t colon = 0, length = 0;
        for (const ScriptToken* token = peek(); token != nullptr; token = peek(++length)) {
            if (token->type == Type::Newline || token->type == Type::LeftBrace ||
                token->type == Type::RightBrace)
                break;
            if (token->type == Type::Word && isMarkAndMore(token->text))
                return fail(*token, std::string(1, token->text[0]) + " needs a space after it");
            if (token->type == Type::Colon && colon != 0) return fail(*token, "a second ':'");
            if (token->type == Type::Colon) colon = length;
        }
        const std::size_t block = startOfBlock(length);
        if (block != 0) return readHeader(first, colon, length, block);
        if (colon != 0) return fail(first, "a line with ':' has to be followed by '{'");
        if (mDepth == 0)
            return fail(first, "expected: shadow_camera_setup NAME, or shadow_camera_setup NAME : "
                               "PARENT, and then its block between '{' and '}'");
        mNext += length;
        return true;
    }

    static bool isMarkAndMore(const std::string& word) {
        return word.size() > 1 && (word[0] == '{' || word[0] == '}' || word[0] == ':');
    }

    /// How far ahead the block of a header of that length begins, maybe in a line after it; 0 where
    /// no block follows.
    std::size_t startOfBlock(std::size_t length) const {
        std::size_t ahead = length;
        while (peek(ahead) != nullptr && peek(ahead)->type == Type::Newline)
            ++ahead;
        return peek(ahead) != nullptr && peek(ahead)->type == Type::LeftBrace ? ahead : 0;
    }

    bool readHeader(const ScriptToken& first, std::size_t colon, std::size_t length,
                    std::size_t block) {
        const std::size_t type = first.text == "abstract" ? 1 : 0;
        const std::size_t endOfNames = colon != 0 ? colon : length;
        if (mTakesSetupsAlone && mDepth > 0)
            return fail(
                first, "a shadow_camera_setup has no blocks within; is a '}' missing before this?");
        if (mTakesSetupsAlone && (type >= length || peek(type)->text != "shadow_camera_setup"))
            return fail(first, "'" + first.text +
                                   "' does not belong here: a .shadow file has shadow_camera_setup "
                                   "alone, and what they import");
        if (mTakesSetupsAlone &&
            (endOfNames != type + 2 || !isName(*peek(type + 1)) || peek(type + 1)->text.empty()))
            return fail(first, "a shadow_camera_setup needs one name");
        if (colon != 0 && (colon + 1 >= length || !areNames(colon + 1, length)))
            return fail(first, "expected the name of a parent after ':'");
        if (mTakesSetupsAlone && colon != 0)
            for (std::size_t i = colon + 1; i < length; ++i)
                outline.parents.push_back({peek(i)->text, outline.objects.size(), first.line});
        if (++mDepth > GreatestDepth) return fail(first, "too many blocks within blocks");
        if (mDepth == 1 && type + 1 < endOfNames) outline.objects.push_back(peek(type + 1)->text);
        mNext += block + 1;
        return true;
    }

    bool areNames(std::size_t begin, std::size_t end) const {
        for (std::size_t i = begin; i < end; ++i)
            if (!isName(*peek(i))) return false;
        return true;
    }

    const std::vector<ScriptToken>& mTokens;
    std::size_t mNext = 0;
    std::size_t mDepth = 0;
    const std::string& mFile;
    bool mTakesSetupsAlone;
    VariableUses& mUses;
};

/// A script and all that it imports.
class Check {
public:
    explicit Check(const ScriptReader& read) : mRead(read) {}

    std::optional<ScriptFault> run(const std::string& script, const std::string& file) {
        if (!readFile(script, file)) return mFault;
        for (const auto& [variable, uses] : mUses)
            if (namesItself(variable))
                return ScriptFault{file, 1,
                                   "the variable " + variable +
                                       " is set to itself, by way of others or at once"};
        return std::nullopt;
    }

private:
    bool fail(const ScriptFault& fault) {
        mFault = fault;
        return false;
    }

    bool readFile(const std::string& script, const std::string& file) {
        const ScriptTokens parts = tokensOf(script);
        if (parts.openQuote != 0)
            return fail({file, parts.openQuote, "a quotation mark without another"});
        const bool takesSetupsAlone = file.ends_with(".shadow");
        Reader reader(parts.tokens, file, takesSetupsAlone, mUses);
        if (!reader.read()) return fail(reader.fault);
        mOpen.push_back(file);
        for (const Import& import : reader.outline.imports)
            if (!follow(import, file)) return false;
        mOpen.pop_back();
        mDone[file] = reader.outline;
        return findParents(reader.outline, file);
    }

    /// OGRE lets an object whose parent is not there go without, and finds one that stands after it
    /// before that one has inherited itself.
    bool findParents(const ScriptOutline& outline, const std::string& file) {
        for (const ScriptOutline::Parent& parent : outline.parents) {
            const auto here = outline.objects.begin() + static_cast<std::ptrdiff_t>(parent.before);
            const bool isImported = std::ranges::any_of(mDone, [&](const auto& done) {
                return done.first != file && std::ranges::find(done.second.objects, parent.name) !=
                                                 done.second.objects.end();
            });
            if (!isImported && std::find(outline.objects.begin(), here, parent.name) == here)
                return fail(
                    {file, parent.line,
                     "there is no '" + parent.name + "' before it, nor in what is imported"});
        }
        return true;
    }

    bool follow(const Import& import, const std::string& file) {
        if (std::ranges::find(mOpen, import.file) != mOpen.end())
            return fail(
                {file, import.line, "'" + import.file + "' is imported by what it imports itself"});
        if (!mDone.contains(import.file)) {
            const std::optional<std::string> script = mRead(import.file);
            if (!script) return fail({file, import.line, "there is no file '" + import.file + "'"});
            if (!readFile(*script, import.file)) return false;
        }
        const std::vector<std::string>& known = mDone[import.file].objects;
        if (import.target == "*" ? !known.empty()
                                 : std::ranges::find(known, import.target) != known.end())
            return true;
        return fail({file, import.line,
                     "'" + import.file + "' has no '" + import.target + "'; it has " +
                         (known.empty() ? "nothing" : joinNames(known))});
    }

    bool namesItself(const std::string& variable) const {
        std::set<std::string> reached;
        std::vector<std::string> open{variable};
        while (!open.empty()) {
            const auto uses = mUses.find(open.back());
            open.pop_back();
            if (uses == mUses.end()) continue;
            for (const std::string& used : uses->second) {
                if (used == variable) return true;
                if (reached.insert(used).second) open.push_back(used);
            }
        }
        return false;
    }

    const ScriptReader& mRead;
    /// Files that are being read, each imported by the one before it.
    std::vector<std::string> mOpen;
    std::map<std::string, ScriptOutline> mDone;
    VariableUses mUses;
    ScriptFault mFault{};
};

} // namespace

std::optional<ScriptFault> findScriptFault(const std::string& script, const std::string& file,
                                           const ScriptReader& read) {
    return Check(read).run(script, file);
}

} // namespace Lixel
