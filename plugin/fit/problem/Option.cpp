#include "fit/problem/Option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace Lixel {
namespace {

/// An option's member, with its own type. Callers that only read the options do not change it.
template <typename Value>
Value& memberOf(const Option& option, const void* options) {
    return *static_cast<Value*>(option.member(const_cast<void*>(options)));
}

/// The shortest text that is read as the same number.
std::string textOf(double value) {
    std::array<char, 32> text{};
    if (value == 0.0) value = 0.0; // a zero without a sign
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string textOf(std::span<const double> values) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += ' ';
        text += textOf(value);
    }
    return text;
}

std::span<const double> numbersOf(const Vec4& v) {
    return {v.data(), 4};
}

bool isSpace(char c) {
    return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Numbers between spaces; none where anything else is among them.
std::optional<std::vector<double>> numbersIn(std::string_view text) {
    std::vector<double> numbers;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        if (text.front() == '+') text.remove_prefix(1);
        double number = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (error != std::errc() || (!text.empty() && !isSpace(text.front()))) return std::nullopt;
        numbers.push_back(number);
    }
    return numbers;
}

std::optional<bool> flagIn(std::string_view text) {
    std::string lower(trimmed(text));
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (lower == "true" || lower == "on" || lower == "yes" || lower == "1") return true;
    if (lower == "false" || lower == "off" || lower == "no" || lower == "0") return false;
    return std::nullopt;
}

bool isPlane(std::span<const double> numbers) {
    return numbers.size() == 4 &&
           std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }) &&
           (numbers[0] != 0.0 || numbers[1] != 0.0 || numbers[2] != 0.0);
}

bool isAscending(std::span<const double> numbers, const OptionRange& range) {
    return std::ranges::all_of(numbers, [&](double n) { return range.contains(n); }) &&
           std::ranges::adjacent_find(numbers, std::ranges::greater_equal()) == numbers.end();
}

std::string describeRange(const OptionRange& range) {
    const bool hasLeast = std::isfinite(range.least);
    const bool hasGreatest = std::isfinite(range.greatest);
    std::string text;
    if (hasLeast) text = (range.isLeastOpen ? "above " : "at least ") + textOf(range.least);
    if (hasGreatest) {
        if (hasLeast) text += " and ";
        text += (range.isGreatestOpen ? "below " : "at most ") + textOf(range.greatest);
    }
    return text;
}

std::string refusal(const Option& option, std::string_view text) {
    std::string message(option.keyword);
    message += ": '";
    message += text;
    message += "' is not ";
    message += describeValues(option);
    return message;
}

bool isRight(const Option& option, const void* options) {
    switch (option.type) {
    case OptionType::Flag:
        return true;
    case OptionType::Count:
    case OptionType::Number:
        return option.range.contains(optionNumber(option, options));
    case OptionType::Plane:
        return isPlane(numbersOf(memberOf<Vec4>(option, options)));
    case OptionType::Ascending:
        return isAscending(memberOf<std::vector<double>>(option, options), option.range);
    }
    return false;
}

} // namespace

bool OptionRange::contains(double value) const noexcept {
    return std::isfinite(value) && (isLeastOpen ? value > least : value >= least) &&
           (isGreatestOpen ? value < greatest : value <= greatest);
}

std::string describeValues(const Option& option) {
    const std::string range = describeRange(option.range);
    const std::string unit = option.unit.empty() ? "" : " of " + std::string(option.unit);
    switch (option.type) {
    case OptionType::Flag:
        return "true or false";
    case OptionType::Count:
        return "a whole number" + unit + (range.empty() ? "" : ", ") + range;
    case OptionType::Number:
        return "a number" + unit + (range.empty() ? "" : ", ") + range;
    case OptionType::Plane:
        return "a plane, as the four numbers of nx x + ny y + nz z + d = 0";
    case OptionType::Ascending:
        return "none, or ascending numbers" + unit + (range.empty() ? "" : ", each ") + range;
    }
    return {};
}

std::string optionText(const Option& option, const void* options) {
    switch (option.type) {
    case OptionType::Flag:
        return memberOf<bool>(option, options) ? "true" : "false";
    case OptionType::Count:
        return std::to_string(memberOf<int>(option, options));
    case OptionType::Number:
        return textOf(memberOf<double>(option, options));
    case OptionType::Plane:
        return textOf(numbersOf(memberOf<Vec4>(option, options)));
    case OptionType::Ascending:
        return textOf(memberOf<std::vector<double>>(option, options));
    }
    return {};
}

std::string setOption(const Option& option, void* options, std::string_view text) {
    if (option.type == OptionType::Flag) {
        const std::optional<bool> flag = flagIn(text);
        if (!flag) return refusal(option, text);
        memberOf<bool>(option, options) = *flag;
        return {};
    }
    const bool isNone = option.type == OptionType::Ascending && trimmed(text) == "none";
    const std::optional<std::vector<double>> numbers =
        isNone ? std::vector<double>() : numbersIn(text);
    if (!numbers) return refusal(option, text);
    const bool isOne = numbers->size() == 1;
    switch (option.type) {
    case OptionType::Count:
        if (!isOne || !option.range.contains(numbers->front()) ||
            std::abs(numbers->front()) > std::numeric_limits<int>::max() ||
            numbers->front() != std::floor(numbers->front()))
            return refusal(option, text);
        memberOf<int>(option, options) = static_cast<int>(numbers->front());
        return {};
    case OptionType::Number:
        if (!isOne || !option.range.contains(numbers->front())) return refusal(option, text);
        memberOf<double>(option, options) = numbers->front();
        return {};
    case OptionType::Plane:
        if (!isPlane(*numbers)) return refusal(option, text);
        memberOf<Vec4>(option, options) = Eigen::Map<const Vec4>(numbers->data());
        return {};
    default:
        if (!isAscending(*numbers, option.range)) return refusal(option, text);
        memberOf<std::vector<double>>(option, options) = *numbers;
        return {};
    }
}

std::string wrongOption(std::span<const Option> declared, const void* options) {
    for (const Option& option : declared)
        if (!isRight(option, options)) return refusal(option, optionText(option, options));
    return {};
}

const Option* findOption(std::span<const Option> declared, std::string_view keyword) {
    const auto found = std::ranges::find(declared, keyword, &Option::keyword);
    return found == declared.end() ? nullptr : &*found;
}

double optionNumber(const Option& option, const void* options) {
    switch (option.type) {
    case OptionType::Flag:
        return memberOf<bool>(option, options) ? 1.0 : 0.0;
    case OptionType::Count:
        return memberOf<int>(option, options);
    case OptionType::Number:
        return memberOf<double>(option, options);
    default:
        return std::numeric_limits<double>::quiet_NaN();
    }
}

void setOptionNumber(const Option& option, void* options, double value) {
    switch (option.type) {
    case OptionType::Flag:
        memberOf<bool>(option, options) = value != 0.0;
        break;
    case OptionType::Count:
        memberOf<int>(option, options) = static_cast<int>(std::lround(value));
        break;
    case OptionType::Number:
        memberOf<double>(option, options) = value;
        break;
    default:
        break;
    }
}

} // namespace Lixel
