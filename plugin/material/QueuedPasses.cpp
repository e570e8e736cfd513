#include "material/QueuedPasses.h"

#include "scene/OgreVersions.h"

#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSceneManager.h>

#include <set>

namespace Lixel {
namespace {

class PassCollector : public Ogre::QueuedRenderableVisitor {
public:
    void visit(Ogre::RenderablePass* queued) override { passes.insert(queued->pass); }
    void visit(const Ogre::Pass* pass, Ogre::RenderableList&) override { passes.insert(pass); }

    std::set<const Ogre::Pass*> passes;
};

} // namespace

void forQueuedPasses(Ogre::SceneManager& manager,
                     const std::function<void(const Ogre::Pass&, bool)>& visit) {
    for (const auto& group : manager.getRenderQueue()->_getQueueGroups()) {
        if (!group) continue;
        PassCollector collector;
        forPriorityGroups(*group, [&](const Ogre::RenderPriorityGroup& priority) {
            for (const auto* solids :
                 {&priority.getSolidsBasic(), &priority.getSolidsDiffuseSpecular(),
                  &priority.getSolidsNoShadowReceive()})
                solids->acceptVisitor(&collector, Ogre::QueuedRenderableCollection::OM_PASS_GROUP);
        });
        for (const Ogre::Pass* pass : collector.passes)
            visit(*pass, group->getShadowsEnabled());
    }
}

} // namespace Lixel
