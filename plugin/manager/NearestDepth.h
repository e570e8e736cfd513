#pragma once

#include <OgreRenderObjectListener.h>

namespace Ogre {
class RenderTarget;
class SceneManager;
} // namespace Ogre

namespace Lixel {

/// Whether casters store depths by Lixel's fragment program in this target's colours.
bool storesDepthAsColour(Ogre::SceneManager& manager, const Ogre::RenderTarget& target);

/** While one lives, each texel gets the nearest of its casters' depths, in whatever order they are
    drawn.

    Casters store depths that are affine in the world, and a depth test compares those that are
    divided by w. Rounding makes the two disagree where casters are equally near within it, and the
    order of drawing decides there. So casters are combined by the minimum, without a depth test:
    before each draw, because OGRE sets caster materials back to replacing.
*/
class NearestDepth : public Ogre::RenderObjectListener {
public:
    explicit NearestDepth(Ogre::SceneManager& manager);
    ~NearestDepth() override;
    NearestDepth(const NearestDepth&) = delete;
    NearestDepth& operator=(const NearestDepth&) = delete;

    void notifyRenderSingleObject(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                  const Ogre::AutoParamDataSource* source,
                                  const Ogre::LightList* lights,
                                  bool suppressRenderStateChanges) override;

private:
    Ogre::SceneManager& mManager;
};

} // namespace Lixel
