#pragma once

#include "common/Comparison.h"
#include "common/Setups.h"
#include "common/TruthComparison.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// What a table is made of.
struct TableOptions {
    std::vector<NamedSetup> setups = emulatedSetups();
    std::vector<std::string> kinds; ///< names of samples; empty for all that are measured
    std::string modelFile;          ///< one more scene; empty for none
    std::size_t lights = 4;
    bool firstView = false; ///< the first view of each scene alone
    int mapSize = 1024;     ///< texels; several maps of a light share as many
    int width = 640;        ///< pixels
    int height = 480;       ///< pixels
    /// Emulated maps lie at so many by so many places within a texel, and errors are their means:
    /// with more, chance says less, which is where texels happen to lie on shadows' edges.
    int shifts = 1;
    std::size_t drawn = 0; ///< of so many cases the first is drawn too; 0: none is
};

/// One scene, light and view under every setup of the table, emulated, and in some cases drawn.
struct TableCase {
    std::string scene;
    std::string view;
    std::string light;
    bool sun = true;                         ///< directional
    std::vector<ClassificationError> errors; ///< in the order of the table's setups
    std::size_t viewNumber = 1;              ///< of its scene's, from 1
    std::vector<std::string> reasons{};      ///< of the setups' fits: MapCapture::reason
    /// What is really drawn, where the case is drawn too; in the same order.
    std::vector<ClassificationError> drawnErrors{};
};

/// The errors of every setup in every scene; says on the error stream how far it is.
/// @exception std::exception where a scene cannot be shown
std::vector<TableCase> measureTable(const TableOptions& options);

/** Prints mean errors per scene, then ratios to a baseline.

    Ratios are paired geometric means with their 95 % interval, over all cases, over those of suns,
    of the scene `duel` (suns, too) and of lamps; half a pixel is added to both errors, so that no
    error at all has a ratio too. Cases in which the baseline's error is below LeastBaseline say
    nothing and are left out, and counted.
    @param setups the table's
    @param baseline index into them
*/
void printTable(const std::vector<NamedSetup>& setups, const std::vector<TableCase>& cases,
                std::size_t baseline);

/// Some of a table's cases.
using SomeCases = std::vector<const TableCase*>;
/// Those that a filter lets through.
SomeCases casesWhere(const std::vector<TableCase>& cases,
                     const std::function<bool(const TableCase&)>& filter);
SomeCases among(const SomeCases& cases, const std::function<bool(const TableCase&)>& filter);

/// Cases in which the baseline errs enough for a ratio to say something: LeastBaseline or more.
SomeCases tellingCases(const std::vector<TableCase>& cases, std::size_t baseline);

/// Cases whose ratios are shown together.
struct CaseGroup {
    std::string name;
    SomeCases cases;
};
/// "all" of some cases, and among them "suns", "duels" (suns, too) and "lamps".
std::array<CaseGroup, 4> groupsOf(const SomeCases& cases);

/// The mean of a value over cases; 0 of no cases.
double meanOf(const SomeCases& cases, const std::function<double(const TableCase&)>& value);

/// A case's error in percent, and half a pixel.
double errorForRatio(const TableCase& one, std::size_t setup);
/// The paired mean of one setup's errors over another's, by their indices.
GeometricMean ratioOf(const SomeCases& cases, std::size_t setup, std::size_t baseline);
/// Such as "0.950 [0.890, 1.020]"; "-" of no cases.
std::string describe(const GeometricMean& mean);

/// Such as "0.9500", a mean of errors in percent; "-" of no cases.
std::string describePercent(const GeometricMean& mean);

/// A setup's errors relative to a baseline's, as printTable has them over all cases, for people.
std::string describeRatio(const std::vector<TableCase>& cases, std::size_t setup,
                          std::size_t baseline);

/// Percent. About 25 pixels of a picture of 640 x 480: fewer depend on where texels happen to lie.
constexpr double LeastBaseline = 0.01;

/// Writes every case, with the error and the fit's reason of every setup, as JSON.
/// @exception std::runtime_error where the file cannot be written
void writeCases(const TableOptions& options, const std::vector<TableCase>& cases,
                const std::string& file);

} // namespace Lixel::Samples
