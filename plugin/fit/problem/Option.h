#pragma once

#include "fit/geometry/Types.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/** Options, each declared once.

    An option is a member of a plain structure, with its default there, and a line that declares its
    keyword, range, unit and use. Setups, scripts, command lines, tests and tables read these lines.
*/
namespace Lixel {
/// @addtogroup LixelFit
/// @{

/// The numbers that an option may have. They are finite, whatever its ends.
struct OptionRange {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
    /// Whether the end itself is left out.
    bool isLeastOpen = false;
    bool isGreatestOpen = false;

    LIXEL_API bool contains(double value) const noexcept;
};

constexpr OptionRange atLeast(double least) {
    return {.least = least};
}
constexpr OptionRange above(double least) {
    return {.least = least, .isLeastOpen = true};
}
constexpr OptionRange between(double least, double greatest) {
    return {.least = least, .greatest = greatest};
}
constexpr OptionRange aboveAndAtMost(double least, double greatest) {
    return {.least = least, .greatest = greatest, .isLeastOpen = true};
}
constexpr OptionRange strictlyBetween(double least, double greatest) {
    return {.least = least, .greatest = greatest, .isLeastOpen = true, .isGreatestOpen = true};
}

/// What an option's member is.
enum class OptionType {
    Flag,      ///< bool: "true" or "false"
    Count,     ///< int
    Number,    ///< double
    Plane,     ///< Vec4 (n, d), n . x + d = 0: four numbers, and n is not zero
    Ascending, ///< std::vector<double>: any number of numbers, each greater than the one before
};

/// One option of a structure of options.
struct Option {
    /// Its name in scripts and on command lines, in lower_snake_case.
    std::string_view keyword;
    OptionType type;
    /// Allowed values of a count or number, or of each of several ascending numbers.
    OptionRange range;
    /// "texels", "world units"; empty for a pure number.
    std::string_view unit;
    /// What it does, in one line.
    std::string_view use;
    /// Its member in a structure.
    void* (*member)(void* options);
};

/// How an option's values are described: "at least 0", "true or false".
LIXEL_API std::string describeValues(const Option& option);

/// The value that a structure has, as setOption reads it; numbers to the last bit.
LIXEL_API std::string optionText(const Option& option, const void* options);

/** Reads a value from text, and sets it if the option allows it.
    @return empty if it was set, else an error message with the keyword and the allowed values */
[[nodiscard]] LIXEL_API std::string setOption(const Option& option, void* options,
                                              std::string_view text);

/// What is wrong with the values of a structure, as setOption says it; empty where all are right.
[[nodiscard]] LIXEL_API std::string wrongOption(std::span<const Option> declared,
                                                const void* options);

/// The option with that keyword; null where there is none.
LIXEL_API const Option* findOption(std::span<const Option> declared, std::string_view keyword);

/// The value of a flag, count or number, as a number; NaN for other types.
LIXEL_API double optionNumber(const Option& option, const void* options);
/// Sets it, whether it is in the range or not; a count is rounded.
LIXEL_API void setOptionNumber(const Option& option, void* options, double value);

namespace Detail {

template <typename Value>
constexpr OptionType optionType() {
    if constexpr (std::is_same_v<Value, bool>) return OptionType::Flag;
    if constexpr (std::is_same_v<Value, int>) return OptionType::Count;
    if constexpr (std::is_same_v<Value, double>) return OptionType::Number;
    if constexpr (std::is_same_v<Value, Vec4>) return OptionType::Plane;
    if constexpr (std::is_same_v<Value, std::vector<double>>) return OptionType::Ascending;
}

template <typename Member>
struct MemberOf;
template <typename Structure, typename Type>
struct MemberOf<Type Structure::*> {
    using Options = Structure;
    using Value = Type;
};

} // namespace Detail

/// Declares a member: option<&XpsmOptions::strength>("strength", atLeast(0.0), "", "…").
template <auto Member>
constexpr Option option(std::string_view keyword, OptionRange range, std::string_view unit,
                        std::string_view use) {
    using Of = Detail::MemberOf<decltype(Member)>;
    return {keyword,
            Detail::optionType<typename Of::Value>(),
            range,
            unit,
            use,
            [](void* options) -> void* {
                return &(static_cast<typename Of::Options*>(options)->*Member);
            }};
}

/// Declares one whose values have no range: a flag, a plane.
template <auto Member>
constexpr Option option(std::string_view keyword, std::string_view use) {
    return option<Member>(keyword, OptionRange{}, "", use);
}

/// @}
} // namespace Lixel
