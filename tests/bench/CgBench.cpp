// lixel-bench-cg: what programs in Cg cost.
//
//     lixel-bench-cg [--programs N] [--json FILE]
//
// Each of N programs, half of them vertex and half fragment programs, is translated for the first
// time, found in memory, and found on disk by another cache; and OGRE starts with all of them,
// without a cache folder's files and with them. Times are CPU time of all threads, in milliseconds.

#include "DrawingOgre.h"
#include "WriteJson.h"

#include "cg/translation/Cache.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <OgrePlugin.h>
#include <OgreStringInterface.h>

#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>

namespace Lixel::Tests {
namespace {

double cpuMilliseconds() {
    return 1e3 * static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// The numbered program: lights and shadows of the kind that articles have, each a little
/// different.
std::string sourceOf(int number) {
    return "static const float number = " + std::to_string(number) + R"(;
struct Varyings {
    float4 position : POSITION; float4 shadow : TEXCOORD0; float3 normal : TEXCOORD1; };
Varyings vertex_main(float4 position : POSITION, float3 normal : NORMAL,
                     uniform float4x4 worldViewProj, uniform float4x4 world,
                     uniform float4x4 textureViewProj) {
    Varyings v;
    v.position = mul(worldViewProj, position);
    v.shadow = mul(textureViewProj, mul(world, position));
    v.normal = mul((float3x3)world, normal) + number * 1e-6;
    return v;
}
float lit(sampler2D map, float4 uv, float2 texel) {
    float sum = 0;
    for (int y = 0; y < 2; y++)
        for (int x = 0; x < 2; x++)
            sum += tex2D(map, uv.xy / uv.w + float2(x, y) * texel).x < uv.z / uv.w ? 0 : 0.25;
    return sum;
}
float4 fragment_main(float4 shadow : TEXCOORD0, float3 normal : TEXCOORD1,
                     uniform sampler2D map : TEXUNIT0, uniform float4 light, uniform float2 texel,
                     uniform float4 colour = float4(1, 1, 1, 1)) : COLOR {
    float diffuse = saturate(dot(normalize(normal), light.xyz));
    return colour * diffuse * lit(map, shadow, texel) + number * 1e-6;
})";
}

Cg::Request requestOf(int number) {
    Cg::Request request;
    const bool isVertex = number % 2 == 0;
    request.stage = isVertex ? Cg::Stage::Vertex : Cg::Stage::Fragment;
    request.entry = isVertex ? "vertex_main" : "fragment_main";
    request.source = sourceOf(number / 2);
    request.file = "program" + std::to_string(number / 2) + ".cg";
    return request;
}

/// CPU time for each program.
double translateAll(Cg::TranslationCache& cache, int programs) {
    const double begin = cpuMilliseconds();
    for (int i = 0; i < programs; ++i)
        if (!cache.translate(requestOf(i)).succeeded()) throw std::runtime_error("not translated");
    return (cpuMilliseconds() - begin) / programs;
}

/// CPU time until OGRE has read and loaded all programs.
double startWith(int programs, const std::filesystem::path& cacheFolder) {
    DrawingOgre ogre(GL3Plus);
    for (Ogre::Plugin* plugin : ogre.root().getInstalledPlugins())
        if (auto* settings = dynamic_cast<Ogre::StringInterface*>(plugin))
            settings->setParameter("cache_folder", cacheFolder.string());
    std::string script;
    for (int i = 0; i < programs / 2; ++i) {
        const std::string number = std::to_string(i);
        ogre.write("program" + number + ".cg", sourceOf(i));
        for (const auto& [kind, profile] :
             {std::pair{"vertex", "arbvp1"}, std::pair{"fragment", "arbfp1"}})
            script += std::string(kind) + "_program " + kind + number + " cg { source program" +
                      number + ".cg\n entry_point " + kind + "_main\n profiles " + profile +
                      "\n}\n";
        script += "material M" + number + " { technique { pass { vertex_program_ref vertex" +
                  number + " { }\n fragment_program_ref fragment" + number + " { } } } }\n";
    }
    ogre.write("programs.material", script);
    const double begin = cpuMilliseconds();
    ogre.readScripts();
    return cpuMilliseconds() - begin;
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    CLI::App app{"What programs in Cg cost."};
    int programs = 100;
    std::string json;
    app.add_option("--programs", programs, "how many")->check(CLI::Range(2, 10000));
    app.add_option("--json", json, "write the numbers to this file too");
    CLI11_PARSE(app, argc, argv);

    const auto folder =
        std::filesystem::temp_directory_path() / ("lixel-bench-cg-" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    Lixel::Cg::TranslationCache cache;
    cache.setFolder(folder);
    double begin = cpuMilliseconds();
    cache.translate(requestOf(programs));
    const double veryFirst = cpuMilliseconds() - begin;
    const double first = translateAll(cache, programs);
    const double inMemory = translateAll(cache, programs);
    Lixel::Cg::TranslationCache other;
    other.setFolder(folder);
    const double onDisk = translateAll(other, programs);
    std::filesystem::remove_all(folder);
    const double coldStart = startWith(programs, folder);
    const double warmStart = startWith(programs, folder);
    std::filesystem::remove_all(folder);

    fmt::print("{} programs, CPU time in ms\n", programs);
    fmt::print("the process's first translation   {:8.2f}\n", veryFirst);
    fmt::print("a first translation               {:8.2f}\n", first);
    fmt::print("found in memory                   {:8.3f}\n", inMemory);
    fmt::print("found on disk                     {:8.3f}\n", onDisk);
    fmt::print("a start with all, nothing on disk {:8.1f}\n", coldStart);
    fmt::print("a start with all, all on disk     {:8.1f}\n", warmStart);
    writeJson({{"programs", programs},
               {"process_first_ms", veryFirst},
               {"first_ms", first},
               {"in_memory_ms", inMemory},
               {"on_disk_ms", onDisk},
               {"cold_start_ms", coldStart},
               {"warm_start_ms", warmStart}},
              json);
    return 0;
}
