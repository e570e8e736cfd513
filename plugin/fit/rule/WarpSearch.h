#pragma once

#include "fit/core/WarpContext.h"

/** Searching for the warp that makes texels smallest where the viewer looks.

    A warp is named by its *spread*: a vector of the warp's direction, as long as the natural
    logarithm of the ratio between greatest and least denominator on the focus region. Around 0 and
    along each direction the expected extent has one minimum in it, whatever the region's size.
*/
namespace Lixel {

/// The warp about the centre that has this spread.
Vec2 warpOfSpread(const Polygon2& hull, const Vec2& centre, const Vec2& spread);

/// The spread of a warp that is positive on the hull.
Vec2 spreadOfWarp(const Polygon2& hull, const Vec2& centre, const Vec2& warp);

/** One frame's search: samples, measure, and the memory that keeps the choice steady. */
class WarpSearch {
public:
    /// Greatest spread looked at: a nearest texel e^8 = 3000 times as fine as the farthest.
    static constexpr double GreatestSpread = 8.0;
    /// Least spread that is probed away from where the search is.
    static constexpr double ProbedSpread = 0.7;

    /// How the view is sampled.
    struct Sampling {
        /// Samples that are kept, at most.
        std::size_t most;
        /// How much more those count around which there are many edges of shadows, from 0 to 1:
        /// @see weighByEdges
        double edgeWeight = 0.0;
    };
    /// Samples the view.
    WarpSearch(const WarpContext& context, const Sampling& sampling, RuleState state);

    /// Whether there is anything to judge warps by.
    bool usable() const { return mUniform > 0.0; }

    /// The expected extent of a spread, relative to a uniform map's; infinite beyond
    /// GreatestSpread.
    double operator()(const Vec2& spread);

    /// A spread and what the measure says of it.
    struct Judged {
        Vec2 spread = Vec2::Zero();
        double cost = 1.0;
    };
    Judged judge(const Vec2& spread) { return {spread, (*this)(spread)}; }

    /** The best spread along a unit direction, up to `greatest` of length, by golden section
        (Kiefer 1953) and with both ends.
        @param evaluations of the measure, at least 3 */
    Judged along(const Vec2& direction, double greatest, int evaluations);

    /** The best spread around `start`, by the simplex method of Nelder and Mead (1965), repeated.
        @param evaluations of the measure; with fewer than 4 it is `start` */
    Judged around(const Judged& start, int evaluations);

    /** Like around(), but from the last frame's best, `target`. That is enough from frame to frame,
        where little changes. The step shrinks while nothing better is found, and grows again when
        something is. Each frame also tries one spread elsewhere, in all directions in turn. Where
        nothing moves it comes to rest after some frames, so that a still map stands still.
        @param evaluations of the measure, at least 2 */
    Judged follow(const Vec2& target, int evaluations);

    /** The same along a unit direction, up to `greatest` of length, in 5 evaluations: the target,
        the far end, a step to either side, and the vertex of the parabola through these. */
    Judged followAlong(const Vec2& direction, double greatest, const Vec2& target);

    /** The spread to use: the part of `best` that its gain over a uniform map justifies. It is kept
        near the last frame's spread while the region hardly moves. */
    Vec2 settle(const Judged& best);

    /// The last frame's spread in this frame's light image; none after a camera cut.
    std::optional<Vec2> last() const;
    /// The last frame's best; none after a camera cut, or where there was nothing to judge by.
    std::optional<Vec2> target() const;

    /// The map's axes for a warp: @see TexelExtent::chooseAxes. None where there is nothing to judge
    /// by.
    /// @param wsLast the last map's axes, as directions in the world
    std::optional<MapAxes> axes(const Vec2& warp, const std::optional<WorldAxes>& wsLast);

    /// The focus region's hull with few vertices, which spreads are measured on.
    const Polygon2& hull() const { return mHull; }
    Vec2 warp(const Vec2& spread) const;
    Vec2 spread(const Vec2& warp) const;

private:
    /// Side of the first simplex, as a change of spread: a third more or less at one end.
    static constexpr double FirstStep = 0.3;
    /// A simplex smaller than this is done: it tells warps apart whose texels differ by a
    /// hundredth.
    static constexpr double LeastStep = 0.02;
    /// Evaluations that complete a simplex and move it once.
    static constexpr int LeastSimplex = 4;

    /// One run of the simplex method, from a simplex of side `step`; counts evaluations down.
    Judged simplexFrom(const Judged& start, double step, int& evaluations);
    /// A spread as a direction in the world.
    Vec3 wsFromSpread(const Vec2& spread) const;
    /// Remembers how far to look next, and for how long nothing has changed.
    void adaptStep(bool improved);
    /// The target, where the search has come to rest on it.
    std::optional<Judged> atRest(const Vec2& target);

    const WarpContext& mContext;
    std::optional<SearchMemory>& mMemory;
    Polygon2& mHull;
    TexelExtent& mExtent;
    double mUniform = 0.0;
    SearchMemory mNow;
    /// How much has changed since the last frame.
    double mChange = 0.0;
    bool mRests = false;
};

} // namespace Lixel
