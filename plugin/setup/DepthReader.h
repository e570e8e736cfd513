#pragma once

#include "fit/sampling/DepthPoints.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace Ogre {
class Viewport;
} // namespace Ogre

namespace Lixel {

/// What was read of a viewport's depths, and the caller's number for it.
struct DepthReading {
    std::uint64_t number = 0;
    DepthGrid grid;
    /// What grid.depths point into; moving a reading leaves them right.
    std::vector<float> depths;
};

/** Reads a few pixels of the depth buffer that OpenGL has drawn, without waiting for it.

    The pixels are gathered on the GPU, into a small depth buffer (glBlitFramebuffer). Once a fence
    says that they are there, they are copied into memory (a pixel pack buffer), and fetched once
    another fence says so. Nothing waits: where more readings are under way than there are buffers,
    none is begun. All of OpenGL's state is left as it was. */
class DepthReader {
public:
    /// The most readings under way.
    static constexpr std::size_t Buffers = 3;
    /// Pixels at least from one column or row to the next: neighbours lie between.
    static constexpr unsigned LeastStep = 3;

    DepthReader();
    ~DepthReader();
    DepthReader(const DepthReader&) = delete;
    DepthReader& operator=(const DepthReader&) = delete;

    /// Leaves to OpenGL what readers had that are gone: its context goes, or has gone.
    static void forgetDiscarded();

    /// Whether the active render system is one whose depths can be read.
    static bool isSupported();

    /** Begins to read a viewport that was just drawn: its target must be bound still.
        @param columns, rows about as many, of pixels at odd distances; fewer of a small viewport
        @return false where none can be begun: all buffers are under way, or it cannot be read at
        all. @see isBroken */
    bool begin(const Ogre::Viewport& viewport, std::size_t columns, std::size_t rows,
               std::uint64_t number);

    /// Has readings go on, and fetches the latest one that has arrived; those before are dropped.
    /// @return whether there was one
    bool fetch(DepthReading& reading);

    /// Whether the last viewport cannot be read, such as one without a depth buffer.
    bool isBroken() const { return mIsBroken; }

private:
    struct Gl;
    struct Slot;
    struct Discarded;

    void release();
    bool isReading() const { return mSlots.front() != nullptr; }
    bool isOver(const Slot& slot) const;
    bool prepare(const Ogre::Viewport& viewport, std::size_t columns, std::size_t rows,
                 bool& isNew);

    std::unique_ptr<Gl> mGl;
    std::array<std::unique_ptr<Slot>, Buffers> mSlots;
    bool mIsBroken = false;
};

} // namespace Lixel
