#include "script/ScriptVariables.h"

#include <algorithm>

namespace Lixel {
namespace {

/// Words that one variable may stand for: `set $b "$a $a"` doubles them.
constexpr std::size_t MostWords = 1000;
/// Variables within variables. OGRE's compiler recurses into them.
constexpr std::size_t MostLevels = 32;

/// How large variables are once they are expanded.
class Expansion {
public:
    explicit Expansion(const ScriptVariables& variables) : mVariables(variables) {}

    std::optional<ScriptFault> run() {
        for (const auto& [variable, values] : mVariables)
            if (!measure(variable)) return mFault;
        return std::nullopt;
    }

private:
    struct Size {
        std::size_t words = 0;
        std::size_t levels = 0;
    };

    bool fail(const VariableValue& value, const std::string& what) {
        mFault = {value.file, value.line, what};
        return false;
    }

    bool measure(const std::string& variable) {
        const auto values = mVariables.find(variable);
        if (values == mVariables.end() || mSizes.contains(variable)) return true;
        mOpen.push_back(variable);
        Size greatest;
        for (const VariableValue& value : values->second)
            if (!measureValue(variable, value, greatest)) return false;
        mOpen.pop_back();
        mSizes[variable] = greatest;
        return true;
    }

    bool measureValue(const std::string& variable, const VariableValue& value, Size& greatest) {
        Size size{value.words, 1};
        for (const auto& [used, times] : value.uses) {
            if (std::ranges::find(mOpen, used) != mOpen.end())
                return fail(value, "the variable " + variable + " is defined in terms of itself");
            if (mOpen.size() == MostLevels) return failForLevels(variable, value);
            if (!measure(used)) return false;
            size.words += times * mSizes[used].words;
            size.levels = std::max(size.levels, mSizes[used].levels + 1);
        }
        if (size.levels > MostLevels) return failForLevels(variable, value);
        if (size.words > MostWords)
            return fail(value, "the variable " + variable + " stands for more than " +
                                   std::to_string(MostWords) + " words");
        greatest.words = std::max(greatest.words, size.words);
        greatest.levels = std::max(greatest.levels, size.levels);
        return true;
    }

    bool failForLevels(const std::string& variable, const VariableValue& value) {
        return fail(value, "the variable " + variable + " has more than " +
                               std::to_string(MostLevels) + " variables within one another");
    }

    const ScriptVariables& mVariables;
    /// Those that are being measured, each named by the one before it.
    std::vector<std::string> mOpen;
    std::map<std::string, Size> mSizes;
    ScriptFault mFault{};
};

} // namespace

std::optional<ScriptFault> findVariableFault(const ScriptVariables& variables) {
    return Expansion(variables).run();
}

} // namespace Lixel
