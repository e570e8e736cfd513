#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace Lixel::Samples {

/** Calls `work(begin, end)` for consecutive parts of 0 .. count - 1, on all processors.

    @param step length of each part but perhaps the last; at least 1
*/
template <typename Work>
void forEachPart(std::size_t count, std::size_t step, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t begin = next.fetch_add(step); begin < count; begin = next.fetch_add(step))
            work(begin, std::min(begin + step, count));
    };
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        helpers.emplace_back(run);
    run();
}

} // namespace Lixel::Samples
