#pragma once

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace Lixel::Tests {

// What benches of whole frames have on their command line.

inline void addObjects(CLI::App& app, std::vector<std::size_t>& objects) {
    app.add_option("--objects", objects, "how many entities; several times or a list")
        ->delimiter(',')
        ->check(CLI::Range(2, 10000000))
        ->capture_default_str();
}

inline void addFrames(CLI::App& app, int& frames) {
    app.add_option("--frames", frames, "how many to measure of each kind")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
}

inline void addJson(CLI::App& app, std::string& file) {
    app.add_option("--json", file, "file to write all numbers to");
}

/// Reads the options and measures. @return the program's exit status
inline int runBench(const char* program, CLI::App& app, int argc, char** argv,
                    const std::function<void()>& measure) {
    CLI11_PARSE(app, argc, argv);
    try {
        measure();
        return 0;
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "%s: %s\n", program, exception.what());
        return 1;
    }
}

} // namespace Lixel::Tests
