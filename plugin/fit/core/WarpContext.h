#pragma once

#include "fit/core/FitState.h"

#include <concepts>
#include <memory>
#include <optional>

/// What a technique's rule is given, and what it gives.
namespace Lixel {

/// Sine of the angle between view and light below which a warp along the view fades out. Gusev
/// (2007, step 3) switches at 0.1; the fade is complete at twice that, so that it passes his
/// threshold at half strength.
inline constexpr double FadeSine = 0.2;

/// 0 at sine 0, 1 from `complete` on, with a continuous slope.
double fadeBySine(double sine, double complete = FadeSine);

/// The light image of the view direction.
struct ViewImage {
    /// The unit direction in which it runs; zero where view and light have one direction.
    Vec2 direction = Vec2::Zero();
    /// The sine of the angle between view and light.
    double sine = 0.0;
    /// How much of a warp along the view is left: 0 for a view along the light, else up to 1.
    double fade = 0.0;

    bool vanishes() const { return !(sine > 0.0); }
    /// What a rule says whose warp fades with the view direction.
    FitReason reason() const { return fade < 1.0 ? FitReason::LightAlongView : FitReason::None; }
};

/// How far receivers are from where positions are measured, and how large their region is.
struct RegionScale {
    /// Distance over which positions are measured, in world units, and as a length in the light
    /// image; > 0.
    double wsReach;
    double liReach;
    /// Sum of the region's width and height in the light image.
    double liSize;
};

RegionScale scaleOf(const LightImage& image, const FocusRegion& region);

/// What a rule may look at to pick its warp.
struct WarpContext {
    const ShadowProblem& problem;
    const LightImage& image;
    const FocusRegion& region;
    /// ℓ of the viewer's position; its third component is <= 0 where the viewer is behind a local
    /// light.
    Vec3 viewer;
    /// ℓ of the unit view direction, and its direction in the light image.
    Vec3 viewDirection;
    ViewImage view;
    /// Whether the viewer's projection is a perspective one; an orthographic one sees everything
    /// at one size.
    bool perspective;
    /// The region's, as long as it is not cut.
    RegionScale scale;
    /// A texel of a map without warp, in the light image: what the region is thickened by where a
    /// warp has to be safe.
    double thickness;

    /// Whether some of what is seen is nearer than other: what warps along the view are for.
    bool hasDepths() const { return perspective && region.vsReceiverFar > 0.0; }
};

/// @param region the problem's, which has a map
WarpContext warpContext(const ShadowProblem& problem, const LightImage& image,
                        const FocusRegion& region);

/// What a rule may write: what it remembers, and room for its work.
struct RuleState {
    FitMemory& memory;
    RuleScratch& scratch;
};

/// A rule's choice: the warp about region.liCentre, and what kept it from its ideal.
struct WarpChoice {
    Vec2 liWarp = Vec2::Zero();
    FitReason reason = FitReason::None;
    /// The map's axes in the warped light image, where they are not to be the smallest rectangle's.
    std::optional<MapAxes> axes = std::nullopt;
    /// Rows x, y and w of the whole map, acting on ℓ, of positive determinant: instead of a warp,
    /// by a rule that wants the map to be this and no other. It is neither made safe nor fitted;
    /// the focus region is cut to what it serves, and where nothing is left the map is uniform.
    std::optional<Mat3> homography = std::nullopt;
};

/// A technique's rule, as a reference to a function object that outlives the call it is passed to.
class WarpRule {
public:
    template <std::invocable<const WarpContext&, RuleState> Function>
    WarpRule(const Function& function) // NOLINT: converts, so that a lambda can be passed
        : mFunction(std::addressof(function)),
          mCall([](const void* object, const WarpContext& context, RuleState state) {
              return WarpChoice((*static_cast<const Function*>(object))(context, state));
          }) {}
    WarpChoice operator()(const WarpContext& context, RuleState state) const {
        return mCall(mFunction, context, state);
    }

private:
    const void* mFunction;
    WarpChoice (*mCall)(const void*, const WarpContext&, RuleState);
};

} // namespace Lixel
