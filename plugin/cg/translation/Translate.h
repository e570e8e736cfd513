#pragma once

#include "cg/translation/Preprocess.h"
#include "cg/translation/Request.h"
#include "cg/translation/Translation.h"

#include <vector>

namespace Lixel::Cg {

/// Translates a Cg or HLSL program to GLSL. What is wrong with it is among the result's messages;
/// nothing is thrown. May be called from several threads at once.
Translation translate(const Request& request);

/// The same; also gives the files that it includes.
Translation translate(const Request& request, std::vector<IncludedFile>& includes);

} // namespace Lixel::Cg
