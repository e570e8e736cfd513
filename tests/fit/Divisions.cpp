#include "fit/Divisions.h"

#include "fit/focus/LightImage.h"
#include "fit/geometry/Polygon2.h"
#include "fit/parts/CascadeDivision.h"
#include "fit/technique/Optimal.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace Lixel::Test {
namespace {

LightPartition slices(const ShadowProblem& problem, DivisionRoom& room) {
    cascadeSplits(problem, 3, {}, room.memory, room.cascades, room.vsSplits);
    return sliceView(problem.viewer, problem.light, room.vsSplits);
}

/// Three strips of the focus region's extent along a slanting direction.
LightPartition strips(const ShadowProblem& problem, DivisionRoom& room) {
    const LightImage image(problem.light);
    findFocusRegion(problem, image, room.focusing, room.region);
    if (!hasMap(room.region.reason)) return wholeLight(problem.light);
    const Vec2 liDirection(0.8, 0.6);
    const double liBegin = -support(room.region.liHull, -liDirection);
    const double liEnd = support(room.region.liHull, liDirection);
    const std::array<double, 2> liSplits{liBegin + 0.3 * (liEnd - liBegin),
                                         liBegin + 0.6 * (liEnd - liBegin)};
    return stripLight(problem.light, image, liDirection, liSplits);
}

/// Slices or strips, as Optimal's texels are smaller.
LightPartition chosen(const ShadowProblem& problem, DivisionRoom& room) {
    static const PartFit optimal = [](const ShadowProblem& part, FitState& state) {
        return fitMap(part, OptimalOptions{}, state);
    };
    return divideView(problem, 3, {}, 0.0, room.memory, room.cascades, room.vsSplits, optimal);
}

LightPartition cube(const ShadowProblem& problem, DivisionRoom&) {
    return cubeAround(problem.light);
}

LightPartition faces(const ShadowProblem& problem, DivisionRoom& room) {
    return facesOfView(problem.viewer, problem.light, room.aiming);
}

LightPartition aimed(const ShadowProblem& problem, DivisionRoom& room) {
    return aimedSpot(problem, room.aiming);
}

constexpr std::array Divisions{
    Division{"Slices", false, slices},      Division{"Strips", false, strips},
    Division{"Chosen", false, chosen},      Division{"Faces", false, faces},
    Division{"FacesOfAPoint", true, faces}, Division{"Cube", true, cube},
    Division{"Aimed", true, aimed}};

} // namespace

std::span<const Division> divisions() {
    return Divisions;
}

const Division& divisionNamed(const std::string& name) {
    const auto found = std::ranges::find(Divisions, name, &Division::name);
    if (found == Divisions.end()) throw std::out_of_range("there is no division '" + name + "'");
    return *found;
}

} // namespace Lixel::Test
