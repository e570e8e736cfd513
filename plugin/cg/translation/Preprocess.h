#pragma once

#include "cg/translation/Message.h"
#include "cg/translation/Request.h"

#include <optional>
#include <string>
#include <vector>

namespace Lixel::Cg {

/// A file that was included, by the name in the directive.
struct IncludedFile {
    std::string name;
    std::string text;
};

struct Preprocessed {
    /// Without directives other than #line and #pragma, all macros expanded.
    std::string text;
    std::vector<IncludedFile> includes;
};

/// The source with its includes, macros and conditions resolved. Nothing if there was an error,
/// which is added to messages.
std::optional<Preprocessed> preprocess(const Request& request, Messages& messages);

} // namespace Lixel::Cg
