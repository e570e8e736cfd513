// Random sequences of everything that an application may do, with frames in between.
//
//     lixel-stress --steps 10000 --seed 7
//
// A sequence that crashes, throws or shows a wrong shadow ends the program with its seed, its step
// and the last deeds. With --shrink it is then tried with fewer deeds, as long as it fails.

#include "Sequence.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace Lixel::Tests {
namespace {

void tell(const SequenceEnd& end, std::uint64_t seed) {
    fmt::print("seed {}, step {}: {}\nThe last deeds:\n", seed, end.step, end.what);
    for (const std::string& deed : end.lastDeeds)
        fmt::print("  {}\n", deed);
}

/// Drops deeds in ever smaller pieces while the rest still fails.
void shrink(Sequence sequence, SequenceEnd end) {
    std::erase_if(sequence.steps, [&](std::size_t step) { return step > end.step; });
    for (std::size_t piece = sequence.steps.size() / 2; piece > 0; piece /= 2)
        for (std::size_t at = 0; at < sequence.steps.size();) {
            Sequence less = sequence;
            const auto from = less.steps.begin() + static_cast<std::ptrdiff_t>(at);
            const auto length =
                static_cast<std::ptrdiff_t>(std::min(piece, less.steps.size() - at));
            less.steps.erase(from, from + length);
            SequenceEnd lessEnd = runSequence(less);
            if (lessEnd.failed) {
                std::erase_if(less.steps, [&](std::size_t step) { return step > lessEnd.step; });
                sequence = less;
                end = lessEnd;
            } else {
                at += piece;
            }
        }
    std::string only;
    for (const std::size_t step : sequence.steps)
        only += (only.empty() ? "" : ",") + std::to_string(step);
    fmt::print("It takes {} deeds: --seed {} --only {}\n", sequence.steps.size(), sequence.seed,
               only);
    tell(end, sequence.seed);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    std::size_t steps = 300;
    bool shrinks = false;
    Sequence sequence;
    CLI::App app("Random sequences of everything that an application may do");
    app.add_option("--steps", steps, "how many deeds")->capture_default_str();
    app.add_option("--seed", sequence.seed, "which sequence")->capture_default_str();
    app.add_option("--only", sequence.steps, "the steps to take, instead of all")->delimiter(',');
    app.add_option("--check-every", sequence.checkEvery, "frames")->capture_default_str();
    app.add_option("--picture", sequence.pictureFile, "PPM file for the wrong shadow, if any");
    app.add_flag("--shrink", shrinks, "find a short sequence that fails");
    app.add_flag("--verbose", sequence.verbose, "say each deed as it is done");
    CLI11_PARSE(app, argc, argv);
    for (std::size_t step = 0; step < steps && app.count("--only") == 0; ++step)
        sequence.steps.push_back(step);

    const SequenceEnd end = runSequence(sequence);
    fmt::print(
        "seed {}: {} deeds, {} frames, {} lights judged, {} of them with shadows, {} twice\n",
        sequence.seed, end.deeds, end.frames, end.counts.lights, end.counts.shadowed,
        end.counts.lookedTwice);
    if (!end.failed) return 0;
    tell(end, sequence.seed);
    if (shrinks) shrink(sequence, end);
    return 1;
}
