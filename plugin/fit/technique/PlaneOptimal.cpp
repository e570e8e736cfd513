#include "fit/technique/PlaneOptimal.h"

#include "fit/core/Declare.h"
#include "fit/core/Warp.h"
#include "fit/rule/ViewDepth.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace Lixel {
namespace {

/// Least denominator of the clamped warp, relative to about the greatest. The plane's own row w
/// would be pulled to the shared numerical bound, where the map shows little but the point that
/// bounds it. Texels at this bound are up to 8 times as small across the warp and 64 times along
/// it: 6 of the 24 bits of a float's position.
constexpr double LeastDenominator = 1.0 / 8.0;

/// The same for a local light, whose own perspective magnifies the rounding of casters near it: 2
/// of those bits are kept for that.
constexpr double LeastLampDenominator = 1.0 / 4.0;

/// Sine between light and plane below which the clamped warp fades out: 3°. A sun lower than that
/// makes shadows on the plane 20 times as long as what casts them.
constexpr double PlaneFadeSine = 0.05;

/// Sine between light and plane, or height of the viewer over the plane relative to the distance it
/// looks over, below which the viewer's picture of the plane is a line, as a float knows it.
constexpr double InThePlane = 1e-6;

/// Signed sine of the angle under which the light shines on the plane, positive on the side of its
/// normal; for a local light at the distance of its farthest receiver.
double elevation(const WarpContext& context, const Vec4& plane) {
    const double height = plane.dot(context.image.wsLight());
    if (context.image.directional()) return height;
    return std::clamp(height / context.region.lsReceiverFar, -1.0, 1.0);
}

/// Whether viewer and light see the same side of the plane, and neither sees it as a line.
bool facesBoth(const WarpContext& context, const Vec4& plane, double sine) {
    const Mat4& viewFromWorld = context.problem.viewer.viewFromWorld;
    double height = 0.0;
    if (context.perspective) {
        height = plane.dot(Vec4(viewFromWorld.inverse().col(3))) / context.region.vsReceiverFar;
    } else {
        // An orthographic viewer is a direction.
        height = -plane.head<3>().dot(-viewFromWorld.row(2).head<3>().transpose());
    }
    return std::abs(sine) > InThePlane && std::abs(height) > InThePlane && sine * height > 0.0;
}

WarpChoice planeOptimalWarp(const WarpContext& context, const PlaneOptimalOptions& options) {
    const Vec3 normal = options.wsPlane.head<3>();
    const double length = normal.norm();
    // The fit's origin is not the world's.
    const double offset = options.wsPlane.w() + normal.dot(context.problem.wsOrigin);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(offset))
        return {Vec2::Zero(), FitReason::PlaneCannotServe};
    Vec4 plane;
    plane << normal / length, offset / length;

    // Rows x, y and w of C ((n . L) I - L n^T), acting on ℓ; positive for what the viewer sees of
    // the plane.
    const LightImage& image = context.image;
    const Vec4 light = image.wsLight();
    const double height = plane.dot(light);
    const Mat4 clip = context.problem.viewer.clipFromView * context.problem.viewer.viewFromWorld;
    const Mat4 picture =
        std::copysign(1.0, height) * clip * (height * Mat4::Identity() - light * plane.transpose());
    Mat3 homography = picture({0, 1, 3}, Eigen::all) * image.wsFromOriented();

    const double sine = elevation(context, plane);
    if (options.exact) {
        if (!facesBoth(context, plane, sine)) return {Vec2::Zero(), FitReason::PlaneCannotServe};
        // A mirrored viewer's picture would turn the casters' faces.
        if (homography.determinant() < 0.0) homography.row(0) *= -1.0;
        return {.homography = homography};
    }

    const double fade = fadeBySine(std::abs(sine), PlaneFadeSine);
    if (!(fade > 0.0)) return {Vec2::Zero(), FitReason::PlaneCannotServe};
    const FocusRegion& region = context.region;
    Vec2 warp = warpOf(homography.row(2), region.liHull, region.liCentre);
    const double pull =
        pullIntoSafeSet(region.liHull, region.liCentre, 0.0, warp,
                        image.directional() ? LeastDenominator : LeastLampDenominator);
    if (fade < 1.0) return {fade * warp, FitReason::PlaneCannotServe};
    return {warp, pull < 1.0 ? FitReason::WarpClamped : FitReason::None};
}

} // namespace

const FitTechnique& PlaneOptimalOptions::technique() {
    static constexpr std::array options{
        option<&PlaneOptimalOptions::wsPlane>("plane",
                                              "the plane in the world that the map is made for"),
        option<&PlaneOptimalOptions::exact>(
            "exact",
            "whether the map is exactly the viewer's picture of the plane, free of aliasing there, "
            "while receivers that it has no place for stay lit; without, the plane picks the warp "
            "and everything is served"),
    };
    static constexpr FitTechnique declared = declare<PlaneOptimalOptions, planeOptimalWarp>(
        "PlaneOptimal", "warped as one plane wants it, such as the ground",
        "Chong and Gortler 2004", options);
    return declared;
}

} // namespace Lixel
