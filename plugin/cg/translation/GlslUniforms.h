#pragma once

#include "cg/translation/Edits.h"
#include "cg/translation/Rewrite.h"
#include "cg/translation/SpirvCross.h"
#include "cg/translation/Translation.h"

#include <string>

namespace Lixel::Cg {

/// Replaces, in SPIRV-Cross's text, the members of the structure of globals by uniforms of their
/// own, and returns these uniforms' declarations. Numbers, vectors and rows of matrices are padded
/// to four components: so OGRE fills them for Cg and Direct3D, and scripts may give four numbers to
/// a float3. Adds the parameters to the translation.
std::string replaceGlobals(const Rewritten& source, const RawGlsl& raw, const Tokens& tokens,
                           Edits& edits, Translation& translation);

/// A name for GLSL: no reserved word, no two underscores in a row, and none of those taken.
std::string glslNameFor(const std::string& prefix, const std::string& name,
                        const std::vector<std::string>& taken);

} // namespace Lixel::Cg
