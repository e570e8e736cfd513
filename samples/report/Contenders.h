#pragma once

#include "report/Table.h"

namespace Lixel::Samples {

/// Percent and percentage points by which an error has to be larger to count as worse. Less may be
/// due to how texels happen to lie on edges.
constexpr double WorseByPart = 0.05;
constexpr double WorseByPoints = 0.01;

/// Whether the first error is worse than the second beyond both.
bool isWorse(const ClassificationError& error, const ClassificationError& than);

/// Of some setups the one that errs least in a case; the first where several do.
std::size_t bestOf(const TableCase& one, const std::vector<std::size_t>& setups);

/// A setup beside another one, both by their indices, and as they are called in print.
struct SetupPair {
    std::string setup;
    std::string than;
    std::size_t first;
    std::size_t second;
};

/// Whether a case says something about a ratio: where one of both errs by LeastBaseline or more.
bool isTelling(const TableCase& one, const SetupPair& pair);
/// In how many cases the pair's first setup is worse.
std::size_t countWorse(const SomeCases& cases, const SetupPair& pair);

/// The setups of a table that claims are about, by their indices.
struct Contenders {
    /// @param setups all of emulatedSetups()
    explicit Contenders(const std::vector<NamedSetup>& setups);

    /// The cases with two more columns of errors, each case's own: bestTechnique and bestOther.
    std::vector<TableCase> withBest(std::vector<TableCase> cases) const;
    /// Whose ratios are claimed.
    std::vector<SetupPair> ratios() const;
    /// Of which the cases are counted in which the first is worse.
    std::vector<SetupPair> losses() const;

    std::size_t uniform;
    std::size_t xpsm;
    std::size_t optimal;
    std::size_t liSPSM;
    std::size_t liSPSMFactorOne;
    std::size_t liSPSMOptimal;
    std::size_t splits;
    std::size_t twoSlices;
    std::size_t threeSlices;
    std::size_t bestTechnique;
    std::size_t bestOther;
    std::vector<std::size_t> techniques; ///< Lixel's, of one map
    std::vector<std::size_t> others;     ///< Uniform, and OGRE's of one map
};

} // namespace Lixel::Samples
