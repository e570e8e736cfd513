#pragma once

#include "fit/focus/ImageHull.h"
#include "fit/focus/LitSurface.h"
#include "fit/focus/SelfShadowFree.h"
#include "fit/focus/SharedEdges.h"
#include "fit/geometry/BoxSet.h"

namespace Lixel {

/// A visible point of a side that has just turned away from the light.
struct LeavingPoint {
    Vec2 liPoint;
    double lsDepth; ///< distance along the light
    double vsDepth; ///< depth in front of the viewer
    double left;    ///< @see LitSurface
};

/// Scratch memory of focusing, kept between frames: nobody else reads it.
struct FocusScratch {
    ClipScratch clip;
    /// Those of the largest that cannot shadow themselves.
    SelfShadowFreeBodies selfShadowFree;
    /// The receivers that may be behind one of those.
    BoxSet behind;
    /// Of a receiver.
    LitSurface litSurface;
    BoxSet litSurfaceInView;
    /// What is in view of receivers' sides that have just turned away from the light.
    std::vector<LeavingPoint> leaving;
    /// What is left of receivers or casters after the first questions.
    BoxSet afterFirstPlanes;
    /// Half spaces that boxes are asked about.
    std::vector<HalfSpace> planes;
    std::vector<Vec3> wsPoints;
    std::vector<Vec2> points;
    ImageHull receivers;
    std::vector<FourEdges> receiverEdges;
    ImageHull casters;
    Polygon2 caster;
    Polygon2 ownImage;
    Polygon2 polygon;
};

} // namespace Lixel
