#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace Lixel::Tests {

/** Does steps one after the other in a child process, which leaves this one as it is: OGRE may abort
    it.

    The stage must not have drawn yet, and no thread but this one may use it.
    @param seconds that a step may take
    @param steps how many; from 0
    @param work a step, which writes the message
    @param message plain memory, filled with what the child has written
    @param done called here with each step, once its message is there
    @return empty, or how the child failed at the first step that was not done: "abort", "hangs",
    "crashes", "exits", or "throws: why"
*/
std::string runApart(unsigned seconds, std::size_t steps,
                     const std::function<void(std::size_t)>& work, std::span<std::byte> message,
                     const std::function<void(std::size_t)>& done);

/// The same for one thing to do.
std::string runApart(unsigned seconds, const std::function<void()>& work,
                     std::span<std::byte> message);

} // namespace Lixel::Tests
