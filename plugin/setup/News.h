#pragma once

#include <cstdint>

namespace Lixel {

/** Whether something bad is news, or the log was told of it already.

    Each kind of trouble is told once, and again only after there was none at all for Quiet frames:
    input that is good and bad by turns does not flood the log. */
class News {
public:
    /// Some ten seconds.
    static constexpr unsigned long Quiet = 600;

    /// To be asked in every frame of trouble. @param kind below 32
    bool isNew(unsigned kind, unsigned long frame) {
        if (isOver(frame)) mTold = 0;
        mLast = frame;
        const std::uint32_t bit = std::uint32_t{1} << kind;
        const bool isNew = (mTold & bit) == 0;
        mTold |= bit;
        return isNew;
    }

    /// Whether there was no trouble for so long that the next one is news.
    bool isOver(unsigned long frame) const { return frame - mLast > Quiet; }

private:
    std::uint32_t mTold = 0;
    unsigned long mLast = 0;
};

} // namespace Lixel
