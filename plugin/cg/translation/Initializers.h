#pragma once

#include "cg/translation/DefaultValue.h"
#include "cg/translation/Edits.h"

namespace Lixel::Cg {

/// Puts constructors around the elements of arrays of vectors, and of matrices, whose initial
/// values are one flat list of numbers: the front end wants one value for each element.
void groupInitializers(const Tokens& tokens, const Constants& constants, Edits& edits);

} // namespace Lixel::Cg
