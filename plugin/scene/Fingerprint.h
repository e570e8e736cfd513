#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace Lixel {

/** A number of 128 bits that stands for all values added to it, in their order.

    Each half is a chain of bijections, so that one different value always makes a different number.
    Several make the same one with a chance of one in 2¹²⁸.
*/
class Fingerprint {
public:
    void add(std::uint64_t value) {
        mLow = std::rotl((mLow ^ value) * 0x9E3779B97F4A7C15ULL, 29);
        mHigh = (std::rotl(mHigh, 31) ^ value) * 0xD6E8FEB86659FD93ULL;
    }
    void add(const void* address) { add(reinterpret_cast<std::uintptr_t>(address)); }
    void add(std::span<const float> values) {
        for (const float value : values)
            add(std::uint64_t{std::bit_cast<std::uint32_t>(value)});
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(std::string_view text) {
        add(std::uint64_t{text.size()});
        for (const char c : text)
            add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    }
    void add(const Fingerprint& other) {
        add(other.mLow);
        add(other.mHigh);
    }

    friend bool operator==(const Fingerprint&, const Fingerprint&) = default;

private:
    std::uint64_t mLow = 0;
    std::uint64_t mHigh = 0;
};

} // namespace Lixel
