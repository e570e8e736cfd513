#include "fit/Divisions.h"

#include "fit/parts/CascadeSplits.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace Lixel::Test {
namespace {

LightPartition slices(const ShadowProblem& problem, DivisionRoom& room) {
    cascadeSplits(problem, 3, {}, room.memory, room.cascades, room.vsSplits);
    return sliceView(problem.viewer, problem.light, room.vsSplits);
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

constexpr std::array Divisions{Division{"Slices", false, slices}, Division{"Faces", false, faces},
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
