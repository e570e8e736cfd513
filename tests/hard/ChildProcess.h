#pragma once

#include <functional>
#include <span>
#include <string>

namespace Lixel::Tests {

/** Does something in a child process, which leaves this one as it is: OGRE may abort it.

    The stage must not have drawn yet, and no thread but this one may use it.
    @param seconds that it may take
    @param work writes the message
    @param message plain memory, filled with what the child has written
    @return empty, or how the child failed: "abort", "hangs", "crashes", "exits", or "throws: why"
*/
std::string runApart(unsigned seconds, const std::function<void()>& work,
                     std::span<std::byte> message);

} // namespace Lixel::Tests
