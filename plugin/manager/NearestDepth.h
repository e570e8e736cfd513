#pragma once

#include <OgreRenderObjectListener.h>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

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

    /// Whether something was drawn that is combined in another way, so that the order matters.
    bool dependsOnOrder() const { return mDependsOnOrder; }

private:
    Ogre::SceneManager& mManager;
    bool mDependsOnOrder = false;
};

} // namespace Lixel
