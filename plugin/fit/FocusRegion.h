#pragma once

#include "fit/ConvexVolume.h"
#include "fit/LightImage.h"
#include "fit/Polygon2.h"
#include "fit/ShadowFit.h"

namespace Lixel {

/** The convex hull of bodies in the light image, which grows body by body.

    Most bodies lie within the image of the few at its rim. So a body is first compared with the
    hull so far, as a box in the world: with the planes through the light and the hull's edges, for
    which nothing of it has to be projected, nor divided by its depth.
*/
class ImageHull {
public:
    /// Starts an empty hull in that image.
    void reset(const LightImage& image);
    void add(const Vec2& point);
    /// The hull of all points added so far.
    const Polygon2& hull();

    /// Where a box's image lies, seen from the hull at its last update: Inside it, Outside of it
    /// (an edge separates them), or neither for certain. A local light's box may reach behind the
    /// light; its part in front is what the answer is about.
    ConvexVolume::Side classify(const Box& box) const;

private:
    struct EdgePlane {
        Vec3 normal;
        Vec3 absolute;
        double offset;
    };
    void update();

    LightImage mImage;
    Polygon2 mHull;
    /// The hull at its last update, and what came since.
    std::vector<Vec2> mPoints;
    std::vector<EdgePlane> mEdges;
};

/// Scratch memory of focusing, kept between frames.
struct FocusScratch {
    ClipScratch clip;
    std::vector<Vec3> wsPoints;
    std::vector<Vec2> points;
    std::vector<Box> straddling;
    ImageHull receivers;
    ImageHull casters;
    Polygon2 caster;
    Polygon2 polygon;
};

/** The focus region: the light rays that meet a visible receiver and a caster before it.

    Gusev 2007, §3.6 takes the boxes of all receivers and of all casters; here receivers are clipped
    to the view volume first, casters that cannot reach a receiver are left out, and hulls are
    intersected instead of boxes: a large ground would otherwise make the map that of its whole box.
*/
struct FocusRegion {
    /// None, UnboundedBody, or the reason why there is nothing to focus on.
    FitReason reason = FitReason::InvalidInput;
    /// Convex hull of the region in the light image, counter-clockwise.
    Polygon2 liHull;
    /// Interior point of the hull.
    Vec2 liCentre = Vec2::Zero();
    /// Distances along the light's axis (-z of light space) of visible receivers.
    double lsReceiverNear = 0.0;
    double lsReceiverFar = 0.0;
    /// The same of the casters that matter; their near end may be in front of the receivers'.
    double lsCasterNear = 0.0;
    /// Depths in front of the viewer of the visible receivers.
    double vsReceiverNear = 0.0;
    double vsReceiverFar = 0.0;
};

/// Finds the focus region; everything in `region` is overwritten.
void findFocusRegion(const ShadowProblem& problem, const LightImage& image, FocusScratch& scratch,
                     FocusRegion& region);

} // namespace Lixel
