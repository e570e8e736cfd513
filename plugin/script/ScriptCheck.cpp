#include "script/ScriptCheck.h"

#include "scene/NameList.h"
#include "script/ScriptOutline.h"
#include "script/ScriptTokens.h"
#include "script/ScriptVariables.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace Lixel {
namespace {

/// Lines of a setup with those of its parents, which OGRE copies: each generation may double them.
constexpr std::size_t MostLines = 10000;

std::vector<std::string> namesOf(const std::vector<ScriptOutline::Object>& objects) {
    std::vector<std::string> names;
    for (const ScriptOutline::Object& object : objects)
        names.push_back(object.name);
    return names;
}

/// A script and all that it imports.
class Check {
public:
    explicit Check(const ScriptReader& read) : mRead(read) {}

    std::optional<ScriptFault> run(const std::string& script, const std::string& file) {
        if (!readFile(script, file)) return mFault;
        return findVariableFault(mVariables);
    }

private:
    bool fail(const ScriptFault& fault) {
        mFault = fault;
        return false;
    }

    bool readFile(const std::string& script, const std::string& file) {
        if (script.starts_with("\xEF\xBB\xBF"))
            return fail({file, 1,
                         "begins with a byte order mark, which OGRE takes for part of a word in "
                         "imported files"});
        const ScriptTokens parts = tokensOf(script);
        if (parts.openQuote != 0)
            return fail({file, parts.openQuote, "a quotation mark without another"});
        if (parts.openComment != 0)
            return fail({file, parts.openComment, "a comment that begins with '/*' has no '*/'"});
        ScriptOutline outline;
        if (const auto fault = readOutline(parts.tokens, file, outline, mVariables))
            return fail(*fault);
        mOpen.push_back(file);
        for (const ScriptOutline::Import& import : outline.imports)
            if (!follow(import, file)) return false;
        mOpen.pop_back();
        mDone[file] = namesOf(outline.objects);
        return findParents(outline, file);
    }

    /// OGRE ignores a missing parent, and uses a parent defined later before that parent's own
    /// inheritance is resolved. Reject both.
    bool findParents(const ScriptOutline& outline, const std::string& file) {
        std::set<std::string> here;
        for (const ScriptOutline::Object& object : outline.objects) {
            std::size_t lines = object.lines;
            for (const std::string& parent : object.parents) {
                if (!here.contains(parent) && !mImported.contains(parent))
                    return fail(
                        {file, object.line,
                         "there is no '" + parent + "' before it, nor in what is imported"});
                lines += mLines[parent];
            }
            if (lines > MostLines)
                return fail({file, object.line,
                             "'" + object.name + "' has more than " + std::to_string(MostLines) +
                                 " lines with those of its parents"});
            here.insert(object.name);
            mLines[object.name] = std::max(mLines[object.name], lines);
        }
        return true;
    }

    bool follow(const ScriptOutline::Import& import, const std::string& file) {
        if (std::ranges::find(mOpen, import.file) != mOpen.end())
            return fail({file, import.line, "circular import of '" + import.file + "'"});
        if (!mDone.contains(import.file)) {
            const std::optional<std::string> script = mRead(import.file);
            if (!script) return fail({file, import.line, "there is no file '" + import.file + "'"});
            if (!readFile(*script, import.file)) return false;
        }
        const std::vector<std::string>& known = mDone[import.file];
        const bool isAll = import.target == "*";
        if (isAll ? known.empty() : std::ranges::find(known, import.target) == known.end())
            return fail({file, import.line,
                         "'" + import.file + "' has no '" + import.target + "'; it has " +
                             (known.empty() ? "nothing" : joinNames(known))});
        if (isAll)
            mImported.insert(known.begin(), known.end());
        else
            mImported.insert(import.target);
        return true;
    }

    const ScriptReader& mRead;
    /// Files that are being read, each imported by the one before it.
    std::vector<std::string> mOpen;
    /// Files that were read, with the names of their objects.
    std::map<std::string, std::vector<std::string>> mDone;
    /// Objects that any file has imported so far: OGRE has one table of them for all files.
    std::set<std::string> mImported;
    /// How many lines an object of that name has with those of its parents, at most.
    std::map<std::string, std::size_t> mLines;
    ScriptVariables mVariables;
    ScriptFault mFault{};
};

} // namespace

std::optional<ScriptFault> findScriptFault(const std::string& script, const std::string& file,
                                           const ScriptReader& read) {
    return Check(read).run(script, file);
}

} // namespace Lixel
