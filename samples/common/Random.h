#pragma once

#include <cstdint>
#include <random>

namespace Lixel::Samples {

/// Random numbers that are the same with every standard library.
class Random {
public:
    explicit Random(std::uint32_t seed) : mEngine(seed) {}

    /// Uniform in [low, high).
    float between(float low, float high) {
        return low +
               (high - low) * static_cast<float>(mEngine() >> 8U) / static_cast<float>(1U << 24U);
    }

    /// Uniform in 0 .. count - 1.
    int below(int count) { return static_cast<int>(mEngine() % static_cast<unsigned>(count)); }

private:
    std::mt19937 mEngine;
};

} // namespace Lixel::Samples
