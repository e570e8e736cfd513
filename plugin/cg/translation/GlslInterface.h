#pragma once

#include "cg/translation/Message.h"
#include "cg/translation/Request.h"
#include "cg/translation/SpirvCross.h"

#include <string>
#include <vector>

namespace Lixel::Cg {

/// How the values that go in and out of a program are declared and passed on.
struct GlslInterface {
    std::string declarations;
    std::string readInputs;   ///< statements at the begin of main
    std::string writeOutputs; ///< statements at its end
    std::vector<std::string> attributes;
    Messages messages; ///< without a place
};

GlslInterface interfaceOf(const Request& request, const RawGlsl& raw);

/// The type of a variable in GLSL, with its array; the name stands between.
std::string declarationOf(const InterfaceVariable& variable);

} // namespace Lixel::Cg
