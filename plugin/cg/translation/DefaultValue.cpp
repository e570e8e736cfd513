#include "cg/translation/DefaultValue.h"

#include <algorithm>
#include <charconv>

namespace Lixel::Cg {
namespace {

using Value = std::vector<double>;

/// Brackets in brackets beyond this are refused.
constexpr unsigned DeepestExpression = 64;

/// Components of float3, int, half4x4 and so on; 0 for what is no such type.
std::size_t componentsOf(std::string_view type) {
    for (const std::string_view base : {"float", "half", "fixed", "int", "uint", "bool"}) {
        if (!type.starts_with(base)) continue;
        const std::string_view rest = type.substr(base.size());
        const auto isCount = [](char c) { return c >= '1' && c <= '4'; };
        if (rest.empty()) return 1;
        if (rest.size() == 1 && isCount(rest[0])) return static_cast<std::size_t>(rest[0] - '0');
        if (rest.size() == 3 && isCount(rest[0]) && rest[1] == 'x' && isCount(rest[2]))
            return static_cast<std::size_t>((rest[0] - '0') * (rest[2] - '0'));
    }
    return 0;
}

class ValueReader {
public:
    ValueReader(const Tokens& tokens, TokenRange range, const Constants& constants)
        : mTokens(tokens), mAt(range.first), mLast(range.last), mConstants(constants) {}

    std::optional<Value> read() {
        auto value = sum();
        if (mAt != mLast) return {};
        return value;
    }

private:
    bool next(std::string_view text) const { return mAt < mLast && mTokens[mAt].is(text); }
    bool take(std::string_view text) {
        if (!next(text)) return false;
        ++mAt;
        return true;
    }

    std::optional<Value> sum() {
        auto left = product();
        while (left && (next("+") || next("-"))) {
            const bool plus = take("+") || !take("-");
            const auto right = product();
            left =
                combined(left, right, [plus](double a, double b) { return plus ? a + b : a - b; });
        }
        return left;
    }

    std::optional<Value> product() {
        auto left = factor();
        while (left && (next("*") || next("/"))) {
            const bool times = take("*") || !take("/");
            const auto right = factor();
            left = combined(left, right, [times](double a, double b) {
                return times ? a * b : (b == 0 ? 0 : a / b);
            });
        }
        return left;
    }

    std::optional<Value> factor() {
        if (mDepth >= DeepestExpression || mAt >= mLast) return {};
        ++mDepth;
        auto value = atom();
        --mDepth;
        return value;
    }

    std::optional<Value> atom() {
        const Token& token = mTokens[mAt];
        if (take("+")) return factor();
        if (take("-")) {
            auto value = factor();
            if (value)
                for (double& number : *value)
                    number = -number;
            return value;
        }
        if (take("{")) return list("}");
        if (take("(")) {
            if (mAt + 1 < mLast && componentsOf(mTokens[mAt].text) != 0 && mTokens[mAt + 1].is(")"))
                return cast();
            auto value = sum();
            return value && take(")") ? value : std::nullopt;
        }
        ++mAt;
        if (token.kind == Token::Kind::Number) return number(token.text);
        if (token.is("true")) return Value{1};
        if (token.is("false")) return Value{0};
        if (const std::size_t count = componentsOf(token.text); count != 0 && take("(")) {
            auto value = list(")");
            if (value && value->size() == 1) value->resize(count, value->front());
            return value && value->size() == count ? value : std::nullopt;
        }
        const auto constant = mConstants.find(token.text);
        return constant == mConstants.end() ? std::nullopt : std::optional(constant->second);
    }

    std::optional<Value> cast() {
        const std::size_t count = componentsOf(mTokens[mAt].text);
        mAt += 2;
        auto value = factor();
        if (!value || value->empty()) return {};
        if (value->size() == 1) value->resize(count, value->front());
        if (value->size() < count) return {};
        value->resize(count);
        return value;
    }

    std::optional<Value> list(std::string_view close) {
        Value all;
        while (!take(close)) {
            const auto value = sum();
            if (!value) return {};
            all.insert(all.end(), value->begin(), value->end());
            if (!take(",") && !next(close)) return {};
        }
        return all;
    }

    static std::optional<Value> number(std::string_view text) {
        double value = 0;
        const char* const last = text.data() + text.size();
        const auto [end, error] = std::from_chars(text.data(), last, value);
        if (error != std::errc()) return {};
        const std::string_view rest(end, static_cast<std::size_t>(last - end));
        if (!rest.empty() && rest != "f" && rest != "F" && rest != "u" && rest != "U" &&
            rest != "l" && rest != "L")
            return {};
        return Value{value};
    }

    template <typename Operation>
    static std::optional<Value> combined(const std::optional<Value>& a,
                                         const std::optional<Value>& b, Operation operation) {
        if (!a || !b || a->empty() || b->empty()) return {};
        if (a->size() != b->size() && a->size() != 1 && b->size() != 1) return {};
        Value result(std::max(a->size(), b->size()));
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = operation(a->size() == 1 ? a->front() : (*a)[i],
                                  b->size() == 1 ? b->front() : (*b)[i]);
        return result;
    }

    const Tokens& mTokens;
    std::size_t mAt;
    std::size_t mLast;
    const Constants& mConstants;
    unsigned mDepth = 0;
};

} // namespace

std::optional<std::vector<double>> valueOf(const Tokens& tokens, TokenRange range,
                                           const Constants& constants) {
    if (range.empty()) return {};
    return ValueReader(tokens, range, constants).read();
}

} // namespace Lixel::Cg
