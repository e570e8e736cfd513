#pragma once

#include <string>
#include <string_view>

namespace Lixel::Cg {

/// A source, before its preprocessing, with numbers as the front end reads them: Cg also has 2f, 2h
/// and .25x. What is not a number, comments and strings stay as they are, and so do all lines. It
/// ends with a newline.
std::string withPlainLiterals(std::string_view source);

} // namespace Lixel::Cg
