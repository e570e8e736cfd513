#pragma once

#include "HardCases.h"
#include "Judge.h"

#include "common/Setups.h"

#include <optional>

namespace Lixel::Tests {

/// What became of one case with one setup.
struct CaseResult {
    bool ok = false;
    /// What the table shows: "ok", what is lost in percent, "abort", "no map: reason", and so on.
    std::string text;
    Losses losses;
};

/// All setups that are judged: the samples', XPSM without its guard, and the exact PlaneOptimal,
/// which says what it serves.
const std::vector<Samples::NamedSetup>& judgedSetups();
/// Whether it is one of Lixel's own.
bool isLixels(const Samples::NamedSetup& setup);

/// Builds the case, with maps of the size that it asks for.
void buildCase(HardScene& scene, const HardCase& hardCase);
/** Draws its frames.
    @param judged called right before the frame that is judged, and again where one after it, with
    bad input repaired, is judged instead
*/
void drawCase(HardScene& scene, const HardCase& hardCase, const std::function<void()>& judged);

/** Builds the case on the stage, which must be new, and judges it.

    @exception whatever OGRE or the oracle throws; OGRE may also abort the process
*/
CaseResult runCase(Samples::Stage& stage, const HardCase& hardCase,
                   const Samples::NamedSetup& setup);

/** The same for several setups, in child processes, which leave the stage as it is; says "abort" where
    the child does, "hangs" where it takes longer than a time limit, and "throws: why" for an
    exception.

    The stage must not have drawn yet, and no thread but this one may use it.
    @return each setup's
*/
std::vector<CaseResult> runCaseApart(Samples::Stage& stage, const HardCase& hardCase,
                                     const std::vector<const Samples::NamedSetup*>& setups);

} // namespace Lixel::Tests
