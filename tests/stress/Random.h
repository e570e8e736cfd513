#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace Lixel::Tests {

/// A stream of numbers that is the same on every machine (splitmix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}

    std::uint64_t next() {
        mState += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = mState;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// Below `end`, which is at least 1.
    std::size_t below(std::size_t end) { return static_cast<std::size_t>(next() % end); }
    bool oneIn(std::size_t n) { return below(n) == 0; }
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(next() >> 40U) / 16777216.0F;
    }
    template <typename T>
    T of(std::initializer_list<T> choices) {
        return choices.begin()[below(choices.size())];
    }

private:
    std::uint64_t mState;
};

} // namespace Lixel::Tests
