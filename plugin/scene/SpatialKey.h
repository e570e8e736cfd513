#pragma once

#include <bit>
#include <cstdint>

namespace Lixel {

/// A float's bits as a number that grows with the float: the same order, without a scene's bounds.
inline std::uint32_t orderedBits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    constexpr std::uint32_t Sign = 0x80000000U;
    return (bits & Sign) != 0 ? ~bits : bits | Sign;
}

/// Two zero bits behind each of the low 19 bits.
inline std::uint64_t spreadBits(std::uint64_t bits) {
    bits &= 0x7FFFFU;
    bits = (bits | bits << 32) & 0x1F00000000FFFFULL;
    bits = (bits | bits << 16) & 0x1F0000FF0000FFULL;
    bits = (bits | bits << 8) & 0x100F00F00F00F00FULL;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3ULL;
    bits = (bits | bits << 2) & 0x1249249249249249ULL;
    return bits;
}

/// The size class of a box. @see spatialKey
inline std::uint64_t sizeClass(const float* halfExtents) {
    float size = halfExtents[0];
    if (halfExtents[1] > size) size = halfExtents[1];
    if (halfExtents[2] > size) size = halfExtents[2];
    // Every second exponent, which leaves 7 bits of them.
    return std::bit_cast<std::uint32_t>(size) >> 24 & 0x7FU;
}

/// How far to the left of a key the size class stands.
inline constexpr int SizeClassShift = 57;

/** Sorts boxes so that neighbours in the order are of like size and near to each other.

    Above all the size class, so that a ground is not among the stones on it; below it the centre's
    Morton code. Coordinates are taken by the bits of their floats: cells grow with the distance from
    the world's origin as the floats' own steps do, and no world needs to have bounds.

    @param centre, halfExtents of a finite box, three floats each
*/
inline std::uint64_t spatialKey(const float* centre, const float* halfExtents) {
    // 12 + 7 bits of a coordinate: its sign, exponent and 10 bits of its mantissa.
    constexpr int CoordinateShift = 32 - 19;
    std::uint64_t morton = 0;
    for (int axis = 0; axis < 3; ++axis)
        morton |= spreadBits(orderedBits(centre[axis]) >> CoordinateShift) << axis;
    return sizeClass(halfExtents) << SizeClassShift | morton;
}

} // namespace Lixel
