#pragma once

#include "cg/translation/Request.h"
#include "cg/translation/Rewrite.h"
#include "cg/translation/SpirvCross.h"
#include "cg/translation/Translation.h"

namespace Lixel::Cg {

/// Makes a program for OGRE of what SPIRV-Cross wrote: uniform parameters on their own, attributes
/// by the names that OGRE binds, varyings by their semantics and all of four components, as Cg and
/// Direct3D have them, so that programs of both stages fit together.
void finishGlsl(const Request& request, const Rewritten& source, const RawGlsl& raw,
                Translation& translation);

} // namespace Lixel::Cg
