#pragma once

#include <OgreRenderQueueListener.h>

namespace Lixel::Tests {

/// Lets OGRE do everything but draw, unless it is told to.
class SkipDrawing : public Ogre::RenderQueueListener {
public:
    void renderQueueStarted(Ogre::uint8, const Ogre::String&, bool& skip) override { skip = skips; }
    bool skips = true;
};

} // namespace Lixel::Tests
