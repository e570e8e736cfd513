/// Contract, 1: in the steady state a fit allocates nothing.
#include "fit/Divisions.h"
#include "fit/Problems.h"
#include "fit/Trials.h"

#include "fit/geometry/LowDiscrepancy.h"
#include "fit/problem/SeenPicture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdlib>
#include <functional>
#include <new>

namespace {
std::size_t allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
} // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace Lixel;
using namespace Lixel::Test;

TEST(SteadyState, CountsAllocations) {
    const std::size_t before = allocations;
    const auto* const memory = new std::vector<Vec3>(10);
    EXPECT_EQ(allocations, before + 2);
    delete memory;
}

namespace {

/// Outdoors, with a long body that has a hull.
Scene sceneOf(LightKind kind) {
    Scene scene = outdoors();
    scene.light.kind = kind;
    scene.light.wsPosition = Vec3(-8.0, 12.0, -12.0);
    scene.light.nearDistance = 0.1;
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Aabb plank{Vec3(1.0, 0.0, -9.0), Vec3(4.0, 0.2, 0.2)};
    addTurned(plank, turn, scene.casters, scene.turnedCasters);
    addTurned(plank, turn, scene.receivers, scene.turnedReceivers);
    // The ground and the boxes; the plank shadows some of them.
    scene.casters.add(scene.receivers.box(0));
    scene.setConvex(scene.casters.size() - 1, 0);
    scene.setConvex(0, 1);
    scene.setConvex(1, 2);
    return scene;
}

/// Scratch buffers change places, so that all of them have been the largest only after some frames.
constexpr int FramesToSettle = 100;
constexpr int FramesCounted = 50;

/// How much is allocated in some frames, after others.
std::size_t allocationsOf(const std::function<void()>& drawFrame) {
    for (int frame = 0; frame < FramesToSettle; ++frame)
        drawFrame();
    const std::size_t before = allocations;
    for (int frame = 0; frame < FramesCounted; ++frame)
        drawFrame();
    return allocations - before;
}

} // namespace

TEST(SteadyState, AllocatesNothing) {
    for (const Trial& trial : trials())
        for (const LightKind kind : {LightKind::Directional, LightKind::Spot}) {
            const Scene scene = sceneOf(kind);
            FitState state;
            EXPECT_TRUE(trial.fit(scene.problem(), state).hasMap());
            EXPECT_EQ(allocationsOf([&] { (void)trial.fit(scene.problem(), state); }), 0U)
                << trial.name;
        }
}

TEST(SteadyState, AllocatesNothingForWhatWasSeen) {
    for (const Trial& trial : trials()) {
        const Scene scene = sceneOf(LightKind::Directional);
        SeenSurfaces surfaces;
        for (std::size_t i = 0; i < 500; ++i) {
            const Vec2 at = lowDiscrepancy(i);
            surfaces.points.push_back(
                {Vec3(40.0 * at.x() - 20.0, -1.0, -40.0 * at.y() - 1.0), Vec3::UnitY()});
        }
        FitState state;
        SeenPicture seen;
        ShadowProblem problem = scene.problem();
        problem.seen = &seen;
        const auto drawFrame = [&] {
            seen.take(surfaces, scene.viewer, Vec3::Zero());
            (void)trial.fit(problem, state);
        };
        EXPECT_EQ(allocationsOf(drawFrame), 0U) << trial.name;
        EXPECT_GT(seen.known(), 10U);
    }
}

TEST(SteadyState, AllocatesNothingForSeveralMaps) {
    for (const Division& division : divisions())
        for (const Trial& trial : trialsThatServeAll()) {
            const Scene scene = sceneOf(division.point ? LightKind::Point : LightKind::Directional);
            DivisionRoom room;
            std::array<FitState, LightPartition::Capacity> states;
            std::size_t maps = 0;
            const auto drawFrame = [&] {
                const ShadowProblem whole = scene.problem();
                const LightPartition parts = division.divide(whole, room);
                maps = 0;
                for (std::size_t i = 0; i < parts.count; ++i)
                    if (trial.fit(problemOf(whole, parts.parts[i]), states[i]).hasMap()) ++maps;
            };
            EXPECT_EQ(allocationsOf(drawFrame), 0U) << division.name << " " << trial.name;
            EXPECT_GT(maps, 0U) << division.name << " " << trial.name;
        }
}
