#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/** Four numbers, or eight in single precision, that are worked on at once: a register of AVX2, or
    two of SSE2.

    These are GCC's vector types: GCC does not vectorise loops over short arrays by itself.
    Everything here is inlined into each clone of a function (Multiversion.h), and so compiled for
    its processor.
*/
namespace Lixel {

using Four = double __attribute__((vector_size(32)));
/// What comparing two gives, for each lane all bits or none; and their bits.
using FourMask = std::int64_t __attribute__((vector_size(32)));
using FourBits = std::uint64_t __attribute__((vector_size(32)));
/// A vector in space for each lane.
using FourVectors = std::array<Four, 3>;

using EightFloats = float __attribute__((vector_size(32)));
using EightMask = std::int32_t __attribute__((vector_size(32)));
using EightBits = std::uint32_t __attribute__((vector_size(32)));

// References where values would do: how wide vectors are passed depends on the processor.

[[gnu::always_inline]] inline void load(const double* from, Four& result) {
    std::memcpy(&result, from, sizeof(result));
}

[[gnu::always_inline]] inline void store(const Four& value, double* to) {
    std::memcpy(to, &value, sizeof(value));
}

[[gnu::always_inline]] inline void load(const float* from, EightFloats& result) {
    std::memcpy(&result, from, sizeof(result));
}

/// The same of memory that is aligned as a register of AVX2 is: one load, where GCC otherwise makes
/// two of halves.
[[gnu::always_inline]] inline void loadAligned(const float* from, EightFloats& result) {
    std::memcpy(&result, __builtin_assume_aligned(from, sizeof(result)), sizeof(result));
}

/// The lesser and the greater; b where either is not a number.
[[gnu::always_inline]] inline void lesser(const Four& a, const Four& b, Four& result) {
    result = a < b ? a : b;
}
[[gnu::always_inline]] inline void greater(const Four& a, const Four& b, Four& result) {
    result = a > b ? a : b;
}

/// A vector of four numbers, to be broadcast one by one.
template <typename Vector>
std::array<double, 4> parts(const Vector& v) {
    return {v[0], v[1], v[2], v[3]};
}

/// The lanes of a mask, or the signs of any lanes, as bits.
[[gnu::always_inline]] inline unsigned bitsOf(const FourMask& mask) {
#ifdef __SSE2__
    // What every x86-64 has an instruction for takes GCC a dozen of them.
    const auto low = __builtin_shufflevector(mask, mask, 0, 1);
    const auto high = __builtin_shufflevector(mask, mask, 2, 3);
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(low)) |
                                 _mm_movemask_pd(reinterpret_cast<__m128d>(high)) << 2);
#else
    FourBits bits;
    std::memcpy(&bits, &mask, sizeof(bits));
    bits >>= 63;
    return static_cast<unsigned>(bits[0] | (bits[1] << 1) | (bits[2] << 2) | (bits[3] << 3));
#endif
}

[[gnu::always_inline]] inline unsigned bitsOf(const EightMask& mask) {
#ifdef __SSE2__
    const auto low = __builtin_shufflevector(mask, mask, 0, 1, 2, 3);
    const auto high = __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(low)) |
                                 _mm_movemask_ps(reinterpret_cast<__m128>(high)) << 4);
#else
    EightBits bits;
    std::memcpy(&bits, &mask, sizeof(bits));
    unsigned result = 0;
    for (unsigned lane = 0; lane < 8; ++lane)
        result |= bits[lane] >> 31 << lane;
    return result;
#endif
}

} // namespace Lixel
