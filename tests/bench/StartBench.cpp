// lixel-bench-start: what Lixel's programs cost until the first frame.
//
//     lixel-bench-start [--starts K] [--json FILE]
//
// OGRE starts, reads Lixel's materials, and draws a cube with the preset Lixel/Sun: with Lixel's
// programs as they are, compiled when a material that uses them is loaded, and as plain GLSL, which
// OGRE compiles as it reads scripts. Mesa keeps on disk what it has compiled: cold starts are
// without that. All take turns, each start in a process of its own; times are medians of CPU time.
#include "FreshOgre.h"
#include "WriteJson.h"

#include "common/Median.h"

#include <Lixel/material/OnDemandPrograms.h>
#include <Lixel/scene/OgreVersions.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

namespace Lixel::Tests {
namespace {

struct StartCase {
    const char* language;
    bool isCold;
};

constexpr std::array<StartCase, 4> Cases{
    {{"lixel_glsl", true}, {"glsl", true}, {"lixel_glsl", false}, {"glsl", false}}};

/// CPU time of all threads of this process so far: OpenGL is drawn by software.
double cpuMilliseconds() {
    return 1e3 * static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

struct Start {
    double scripts = 0;    ///< milliseconds for reading them
    double firstFrame = 0; ///< milliseconds from the process's beginning until it is drawn
    std::size_t compiled = 0;
};

/// Lixel's GLSL programs, declared in one of the two ways, while it lives.
class ProgramsInLanguage {
public:
    explicit ProgramsInLanguage(const std::string& language)
        : mFolder(std::filesystem::temp_directory_path() /
                  ("lixel-bench-start-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(mFolder);
        for (const auto& file :
             std::filesystem::directory_iterator(LIXEL_MATERIALS_DIR "/programs/glsl")) {
            std::ostringstream text;
            text << std::ifstream(file.path()).rdbuf();
            std::string script = text.str();
            const std::string both = " lixel_glsl glsl";
            for (std::size_t at = 0; (at = script.find(both, at)) != std::string::npos;)
                script.replace(at, both.size(), " " + language);
            std::ofstream(mFolder / file.path().filename()) << script;
        }
    }
    ~ProgramsInLanguage() { std::filesystem::remove_all(mFolder); }
    ProgramsInLanguage(const ProgramsInLanguage&) = delete;
    ProgramsInLanguage& operator=(const ProgramsInLanguage&) = delete;

    std::string folder() const { return mFolder.string(); }

private:
    std::filesystem::path mFolder;
};

Start startOnce(const std::string& language) {
    const ProgramsInLanguage programs(language);
    Start start;
    FreshOgre ogre;
    const double read = cpuMilliseconds();
    ogre.readScripts(programs.folder());
    start.scripts = cpuMilliseconds() - read;
    ogre.drawCube("Lixel/Sun", "Lixel/Surface/Integrated/Maps3");
    ogre.picture(); // waits until it is drawn
    start.firstFrame = cpuMilliseconds();
    for (const auto& [handle, program] : programManager().getResourceIterator())
        start.compiled += isCompiled(static_cast<const Ogre::GpuProgram&>(*program)) ? 1U : 0U;
    return start;
}

/// In a process of its own.
Start startElsewhere(const StartCase& chosen) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::unique_ptr<FILE, int (*)(FILE*)> child(
        popen(((chosen.isCold ? "MESA_SHADER_CACHE_DISABLE=true '" : "'") + self + "' --once " +
               chosen.language)
                  .c_str(),
              "r"),
        pclose);
    Start start;
    if (!child || std::fscanf(child.get(), "%lf %lf %zu", &start.scripts, &start.firstFrame,
                              &start.compiled) != 3)
        throw std::runtime_error(std::string("a start with ") + chosen.language + " failed");
    return start;
}

double medianOf(const std::vector<Start>& starts, double Start::*member) {
    std::vector<double> values;
    for (const Start& start : starts)
        values.push_back(start.*member);
    return Samples::median(values);
}

void measureStarts(int starts, const std::string& jsonFile) {
    std::array<std::vector<Start>, Cases.size()> all;
    for (int i = -1; i < starts; ++i) // the first one fills caches
        for (std::size_t which = 0; which < Cases.size(); ++which) {
            const Start start = startElsewhere(Cases[which]);
            if (i >= 0) all[which].push_back(start);
        }
    fmt::print("{:<5} {:<12} {:>10} {:>15} {:>18}\n", "", "language", "scripts ms",
               "first frame ms", "programs compiled");
    nlohmann::json json = nlohmann::json::array();
    for (std::size_t which = 0; which < Cases.size(); ++which) {
        const double scripts = medianOf(all[which], &Start::scripts);
        const double firstFrame = medianOf(all[which], &Start::firstFrame);
        const std::size_t compiled = all[which].front().compiled;
        const char* const cache = Cases[which].isCold ? "cold" : "warm";
        fmt::print("{:<5} {:<12} {:>10.1f} {:>15.1f} {:>18}\n", cache, Cases[which].language,
                   scripts, firstFrame, compiled);
        json.push_back({{"cache", cache},
                        {"language", Cases[which].language},
                        {"scripts_ms", scripts},
                        {"first_frame_ms", firstFrame},
                        {"programs_compiled", compiled}});
    }
    writeJson(json, jsonFile);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    CLI::App app("What Lixel's programs cost until the first frame");
    int starts = 20;
    std::string jsonFile;
    std::string once;
    app.add_option("--starts", starts, "how often each starts")->check(CLI::Range(1, 10000));
    app.add_option("--json", jsonFile, "file for all numbers");
    app.add_option("--once", once, "start here, once, with programs in this language")->group("");
    CLI11_PARSE(app, argc, argv);
    try {
        if (once.empty()) {
            Lixel::Tests::measureStarts(starts, jsonFile);
        } else {
            const Lixel::Tests::Start start = Lixel::Tests::startOnce(once);
            fmt::print("{} {} {}\n", start.scripts, start.firstFrame, start.compiled);
        }
    } catch (const std::exception& error) {
        std::cerr << "lixel-bench-start: " << error.what() << '\n';
        return 1;
    }
}
