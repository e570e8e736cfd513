#pragma once

#include "PictureScene.h"

#include <Lixel/manager/LixelSceneManager.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// A PictureScene of LixelSceneManager with one map, whose casters' draws are counted.
class BatchScene {
public:
    /// @param reusesMaps whether a map is kept where nothing has changed
    explicit BatchScene(bool usesBatches, bool reusesMaps = false);

    PictureScene& scene() { return mScene; }
    LixelSceneManager& manager() { return static_cast<LixelSceneManager&>(mScene.manager()); }
    /// Draws a frame. @return the map's texels
    std::vector<std::uint8_t> drawMap();
    /// Draw calls of the last map.
    std::size_t drawCalls() const { return mDrawCalls; }

private:
    PictureScene mScene;
    std::size_t mDrawCalls = 0;
};

/// Waits until all that is drawn is drawn: Mesa's textures have old texels until then.
void finishDrawing();

/// How many texels of a map differ, of that many bytes each.
std::size_t differingTexels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                            std::size_t bytes = 4);

} // namespace Lixel::Tests
