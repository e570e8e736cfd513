#pragma once

#include "fit/core/FitState.h"
#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowPart.h"
#include "fit/problem/ShadowProblem.h"
#include "scene/CasterFingerprint.h"
#include "scene/CasterSearch.h"
#include "scene/Fingerprint.h"

namespace Lixel {

/** A map that outlives the frame in which it was fitted.

    It is fitted for a wider view than the viewer's, and kept while it shows all that the viewer's own
    map would show, with texels that are no coarser than a bound allows. Both are asked of a fresh
    fit in each frame, so what is lost is known; what is saved is drawing, and edges of shadows stand
    still meanwhile. Where only its window is in the wrong place, that moves by whole texels: the map
    is drawn, and edges stand still.
*/
struct LastingMap {
    ShadowFit fit; ///< without a map: there is none to keep
    Vec3 wsOrigin = Vec3::Zero();
    /// Of everything except viewer and scene that it was fitted for.
    Fingerprint settings;
    FitState state;
    /// The casters in its own volume.
    CasterSearch search;
    CasterFingerprint fingerprint;
};

/// Of a light and a map's size.
void addLight(const ShadowProblem& problem, Fingerprint& settings);

/** Whether a kept map still serves.

    @param fresh fitted now, for the viewer himself
    @param bound how much coarser its texels may be than the fresh fit's, as a share
*/
bool serves(const LastingMap& kept, const Fingerprint& settings, const ShadowFit& fresh,
            const ShadowProblem& problem, double bound);

/// Keeps a fit, which was made relative to the kept map's origin.
void keep(LastingMap& kept, const ShadowFit& fit);

/** Moves a kept map's window to what is seen now, where its texels serve.

    @param problem of the map's part, in whose middle the window is to be; a wider one than the fresh
    fit's, for a map that is to last
    @return whether it moved; the map is as it was if not. Parameters as of serves
*/
bool move(LastingMap& kept, const Fingerprint& settings, const ShadowFit& fresh,
          const ShadowProblem& problem, double bound);

/// A problem with a margin around what is seen. @param share of the view's extents
ShadowProblem widened(const ShadowProblem& problem, double share);
/// A part for a view that is widened by a share: slices begin earlier and end later.
ShadowPart widened(const ShadowPart& part, double share);

/// A part relative to another origin. @param wsShift of the old origin relative to the new one
ShadowPart relocated(const ShadowPart& part, const Vec3& wsShift);

} // namespace Lixel
