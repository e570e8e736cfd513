#pragma once

#include "MapProbe.h"

#include <string>

namespace Lixel::Tests {

/// What is lost of the visible points that are in shadow; shares of them in percent.
struct Losses {
    std::size_t shadowed = 0; ///< points
    double outside = 0.0;     ///< beside the map
    double behind = 0.0;      ///< w <= 0
    double clipped = 0.0;     ///< their caster is outside the depth range, which does not clamp
    double culled = 0.0;      ///< their caster is culled by the shadow camera
    double apart = 0.0; ///< the caster on their light ray falls too far beside them in the map
    /// Outside or apart, but by no more than positions of this size are rounded by as floats: no
    /// setup's fault.
    double coarse = 0.0;
    double mirrored = 0.0;   ///< the map shows their caster mirrored
    double unserved = 0.0;   ///< outside of what the map says that it serves; judged no further
    double worstApart = 0.0; ///< the largest such distance, in texels
    bool finite = true;      ///< all matrices are

    bool none() const {
        return finite && outside + behind + clipped + culled + apart + mirrored <= 0.0;
    }
};

/// How a map is used.
struct MapUse {
    bool clampsDepth = false;   ///< casters in front of the depth range are drawn all the same
    double greatestApart = 1.0; ///< texels between two points of one light ray
};

/** Checks a light's maps against the exact shadows of what the viewer sees: each point in the map
    that serves it.

    Truth is ray-traced; all that follows is done in double, with the matrices of floats that
    programs are handed. @see ProbedMap
*/
Losses judge(HardScene& scene, const std::vector<ProbedMap>& maps, const MapUse& use);

/// How many points that the viewer sees are in shadow.
std::size_t countShadowed(HardScene& scene);

/// Such as "out 52, clip 3.1", in percent; "ok" where nothing is lost.
std::string describe(const Losses& losses);

} // namespace Lixel::Tests
