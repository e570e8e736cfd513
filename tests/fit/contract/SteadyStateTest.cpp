/// Contract, 1: in the steady state a fit allocates nothing.
#include "fit/Problems.h"
#include "fit/Trials.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cstdlib>
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

TEST(SteadyState, AllocatesNothing) {
    for (const Trial& trial : trials())
        for (const LightKind kind : {LightKind::Directional, LightKind::Spot}) {
            Scene scene = outdoors();
            scene.light.kind = kind;
            scene.light.wsPosition = Vec3(-8.0, 12.0, -12.0);
            const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
            const Aabb plank{Vec3(1.0, 0.0, -9.0), Vec3(4.0, 0.2, 0.2)};
            addTurned(plank, turn, scene.casters, scene.turnedCasters);
            addTurned(plank, turn, scene.receivers, scene.turnedReceivers);
            FitState state;
            // Scratch buffers change places, so that all of them have been the largest only after
            // some frames.
            for (int frame = 0; frame < 100; ++frame)
                ASSERT_TRUE(trial.fit(scene.problem(), state).hasMap());
            const std::size_t before = allocations;
            for (int frame = 0; frame < 50; ++frame)
                (void)trial.fit(scene.problem(), state);
            EXPECT_EQ(allocations, before) << trial.name;
        }
}
