#pragma once

#include "cg/translation/Translate.h"

#include <map>
#include <string>

namespace Lixel::Tests {

/// A source to translate, with what it includes.
struct Source {
    Cg::Stage stage = Cg::Stage::Fragment;
    std::string text;
    Cg::Language language = Cg::Language::Cg;
    unsigned glslVersion = 330;
    std::map<std::string, std::string> includes = {};
};

/// Its request, with the file name test.cg.
Cg::Request requestOf(const Source& source);

/// Its translation, which is checked to be GLSL.
Cg::Translation translated(const Source& source);

/// Its first error, or nothing.
std::string errorOf(const Source& source);

/// The parameter of that name; a test's failure where there is none.
Cg::Parameter parameterOf(const Cg::Translation& translation, const std::string& name);

/// What is wrong with a GLSL program; empty if nothing is.
std::string problemOf(const std::string& glsl, Cg::Stage stage);

} // namespace Lixel::Tests
