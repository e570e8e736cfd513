#pragma once

#include "cg/translation/Message.h"
#include "cg/translation/Request.h"

#include <string>
#include <string_view>
#include <vector>

namespace Lixel::Cg {

/// A value that goes into a program or comes out of it, other than OpenGL's own.
struct InterfaceVariable {
    std::string variable; ///< its name in the text
    std::string semantic; ///< as the source has it, empty if it has none
    /// Which element of an array in the source it is; the front end makes one value of each.
    unsigned element = 0;
    enum class Base { Float, Int, Bool };
    Base base = Base::Float;
    unsigned components = 1; ///< of a vector, or of each of a matrix's columns
    unsigned columns = 1;    ///< more than 1: a matrix
    unsigned elements = 0;   ///< more than 0: an array
};

/// A texture in the text.
struct TextTexture {
    std::string variable; ///< its name in the text
    std::string texture;  ///< the source's sampler, or its texture where these are two
    std::string state;    ///< the source's sampler state, where these are two
    std::string type;     ///< such as sampler2D
};

/// GLSL as SPIRV-Cross writes it, under names that are known here. The source's uniform parameters
/// are members of one structure, GlobalsName.
struct RawGlsl {
    std::string text;
    std::vector<std::string> members; ///< what the source calls the structure's members m0, m1…
    std::vector<InterfaceVariable> inputs;
    std::vector<InterfaceVariable> outputs;
    std::vector<TextTexture> textures;
};

inline constexpr const char* GlobalsName = "lixel_globals";
inline constexpr const char* GlobalsType = "lixel_Globals";

/// Translates SPIR-V. The text is empty if there was an error, which is added to messages.
RawGlsl translateSpirv(const Request& request, const std::vector<unsigned>& code,
                       Messages& messages);

} // namespace Lixel::Cg
