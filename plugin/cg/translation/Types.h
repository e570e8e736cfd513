#pragma once

#include "cg/translation/Outline.h"
#include "cg/translation/Translation.h"

#include <optional>
#include <string>
#include <string_view>

namespace Lixel::Cg {

/// A type that is a number, a vector or a matrix.
struct NumberType {
    Parameter::Base base = Parameter::Base::Float;
    bool isBool = false;
    unsigned rows = 1;
    unsigned columns = 1;
    bool isMatrix = false;
};

/// The type that these tokens name, Cg's fixed and half and vector<float, 3> included.
std::optional<NumberType> numberTypeOf(const Tokens& tokens, TokenRange range);

/// As HLSL writes it, a bool as an int.
std::string hlslNameOf(const NumberType& type);

/// Whether it is a sampler or a texture in a form that can be translated.
bool isSamplerType(std::string_view type);

/// Why a type cannot be translated; null where it is not known to be so.
const char* whyUnsupported(std::string_view type);

/// Cg's names for types that the front end knows by another, or the same name.
std::string plainTypeName(std::string_view cgName);

} // namespace Lixel::Cg
