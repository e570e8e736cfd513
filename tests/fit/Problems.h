#pragma once

#include "fit/Constants.h"

#include "fit/core/FitState.h"
#include "fit/geometry/BodyHull.h"
#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowProblem.h"

#include <rapidcheck.h>

#include <cstdint>
#include <iosfwd>
#include <random>

namespace Lixel {

std::ostream& operator<<(std::ostream& out, const Aabb& box);
std::ostream& operator<<(std::ostream& out, FitReason reason);

} // namespace Lixel

/// Shadow problems: built by hand for examples, drawn at random for properties.
namespace Lixel::Test {

/// A box that is turned about its middle, within the box that a set has of it.
struct TurnedBox {
    /// Of the set's box.
    std::size_t index = 0;
    /// Before it was turned.
    Aabb box;
    Mat3 turn = Mat3::Identity();
    BodyHull hull;
};

/// A body of a set that says that it shadows nothing of itself.
struct ConvexBox {
    /// Of the set's box.
    std::size_t index = 0;
    /// The same for the body among casters as among receivers; greater than 0.
    std::uintptr_t number = 0;
    PlacedBox around;
    /// It says so of what faces the light alone.
    std::optional<Relief> relief = std::nullopt;
    /// It says that it is the box.
    bool isBox = false;
};

/// Around a part of a relief, in its own space.
Aabb boxOf(const ReliefCell& cell);

/// Those of a set's bodies that are turned boxes, by ascending index, and that are convex.
struct TurnedBoxes final : BodyShapes {
    std::vector<TurnedBox> all;
    std::vector<ConvexBox> convex;

    const TurnedBox* find(std::size_t index) const;
    /// The number of a convex body; 0 of others.
    std::uintptr_t numberOf(std::size_t index) const noexcept;
    /// Whether what a body says of itself leaves a point of it for light to fall on: nothing else
    /// of it needs a shadow.
    bool mayBeLit(std::size_t index, const ShadowLight& light, const Vec3& ws) const;
    /// A relief with cells; null of other bodies.
    const ConvexBox* findRelief(std::size_t index) const;
    /// Boxes around what a relief may shadow of itself with.
    std::vector<PlacedBox> slopesOf(std::size_t index, const ShadowLight& light) const;
    void clear();
    const BodyHull* hullOf(std::size_t index, Transform3& wsFromBody) const noexcept override;
    const void* identityOf(std::size_t index) const noexcept override;
    bool isSelfShadowFree(std::size_t index, SelfShadowFree& body) const noexcept override;
};

/// Adds a box that is turned to a set.
void addTurned(const Aabb& box, const Mat3& turn, BoxSet& set, TurnedBoxes& turned);

/// A shadow problem that owns its bodies.
struct Scene {
    ShadowViewer viewer;
    ShadowLight light;
    BoxSet casters;
    BoxSet receivers;
    TurnedBoxes turnedCasters;
    TurnedBoxes turnedReceivers;
    int mapWidth = 1024;
    int mapHeight = 1024;
    double filterRadius = 1.0;
    bool depthClamp = true;
    /// A length that is typical of the scene, in world units: what "tiny" is compared with.
    double size = 1.0;

    ShadowProblem problem() const;
    /// Adds a body that casts and receives.
    void addBody(const Aabb& box);
    /// The same, which says that it is convex.
    void addConvexBody(const Aabb& box);
    /// Has a caster and a receiver, which must be at one place, say that they are one convex body.
    void setConvex(std::size_t caster, std::size_t receiver,
                   const std::optional<Relief>& relief = std::nullopt, bool isBox = false);
};

/// How far inside the border of the scene's map a texel coordinate is; negative outside.
double insideBorder(const Vec2& texel, const Scene& scene);

/// Prints every number of the scene, so that a failure can be made an example.
std::ostream& operator<<(std::ostream& out, const Scene& scene);

/// OpenGL's projections; farDepth may be infinite.
Mat4 frustum(double left, double right, double bottom, double top, double nearDepth,
             double farDepth);
Mat4 perspective(double fovY, double aspect, double nearDepth, double farDepth);
Mat4 orthographic(double halfWidth, double halfHeight, double nearDepth, double farDepth);
/// View space from world axes for an eye that looks along `forward`; `up` need not be orthogonal.
Mat4 lookAlong(const Vec3& eye, const Vec3& forward, const Vec3& up = Vec3::UnitY());

/// A direction turned by an angle in radians about a unit axis.
Vec3 turned(const Vec3& direction, const Vec3& unitAxis, double angle);

Vec3 eyeOf(const ShadowViewer& viewer);
/// Unit view direction in world axes.
Vec3 forwardOf(const ShadowViewer& viewer);

/** A plain outdoor scene: a flat ground of 200 x 200, nine boxes standing on it 4 to 28 units
    ahead, and a viewer of 60° at height 2 that looks slightly down. Light comes from the side. */
Scene outdoors();

/// A scene scaled about the problem's origin; the same fit is expected.
Scene scaled(const Scene& scene, double factor);

/// Uniformly random numbers and vectors of one seed.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : mEngine(seed) {}
    double in(double lower, double upper);
    std::size_t below(std::size_t count);
    bool chance(double probability) { return in(0.0, 1.0) < probability; }
    /// In the cube -1 … 1.
    Vec3 cube();
    Vec3 direction();

private:
    std::mt19937_64 mEngine;
};

/// Seeds of dice: any, whatever RapidCheck's size, and none simpler than another.
rc::Gen<std::uint64_t> anySeed();
Dice anyDice();

/** Any valid scene.

    1 to 60 bodies of random size and role, flat, thin and zero-sized ones among them, ahead of the
    viewer and behind it; viewers with perspective, off-axis and orthographic projections, with
    and without a far plane, mirrored too; directional and spot lights along every special axis.
    Shrinks by leaving out bodies.
*/
rc::Gen<Scene> anyScene();

/// The same, where in every other scene some of the bodies are turned, and say so, and in two of
/// three some that cast and receive say that they are convex.
rc::Gen<Scene> anySceneOfHulls();

/// Names the instances of a parameterised test by the parameter's `name`.
struct ByName {
    template <typename Info>
    std::string operator()(const Info& info) const {
        return info.param.name;
    }
};

/// Whether the focus region of a scene's last fit is too small for its warp to be told from float's
/// rounding: the shared fit shortens any warp there.
bool isLostInRounding(const Scene& scene, const FitState& state);

/// What is sampled of the problem's focus region.
std::vector<ViewSample> samplesOf(const ShadowProblem& problem, const SampleCount& count);

/// Clip coordinates of a world point.
Vec4 clipOf(const Mat4& clipFromWorld, const Vec3& ws);

/// The light as a homogeneous world point: its position, or the direction towards it.
Vec4 homogeneousLight(const ShadowLight& light);

/// d(pixel or texel) / d(world direction) at x, of a map or picture with `size` pixels.
Vec2 derivative(const Mat4& clipFromWorld, const Vec2& size, const Vec3& x, const Vec3& d);

/// Texel coordinates of a world point, w > 0 being assumed.
Vec2 texelOf(const Mat4& clipFromWorld, const Scene& scene, const Vec3& ws);

/// How far inside of what a map serves a point is: the least of its half spaces' values, infinite
/// for a map that serves everything.
double servedMargin(const ShadowFit& fit, const Vec3& ws);

/// The matrix that a graphics card gets.
Mat4 roundedToFloat(const Mat4& m);

/// The least of the volume's plane distances at p; >= 0 inside.
double inside(const ConvexVolume& volume, const Vec3& p);

/// How far the points reach along d.
double support3(const std::vector<Vec3>& points, const Vec3& d);

} // namespace Lixel::Test
