#include "material/QueuedPasses.h"

#include "material/MapReads.h"
#include "scene/OgreVersions.h"

#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreRenderQueue.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreSceneManager.h>
#include <OgreTechnique.h>

#include <set>

namespace Lixel {
namespace {

class PassCollector : public Ogre::QueuedRenderableVisitor {
public:
    void visit(Ogre::RenderablePass* queued) override { passes.insert(queued->pass); }
    void visit(const Ogre::Pass* pass, Ogre::RenderableList&) override { passes.insert(pass); }

    std::set<const Ogre::Pass*> passes;
};

using Ogre::QueuedRenderableCollection;

void collectSolids(const Ogre::RenderQueueGroup& group, PassCollector& collector) {
    forPriorityGroups(group, [&](const Ogre::RenderPriorityGroup& priority) {
        for (const auto* solids :
             {&priority.getSolidsBasic(), &priority.getSolidsDiffuseSpecular(),
              &priority.getSolidsDecal(), &priority.getSolidsNoShadowReceive()})
            solids->acceptVisitor(&collector, QueuedRenderableCollection::OM_PASS_GROUP);
    });
}

void collectTransparents(const Ogre::RenderQueueGroup& group, PassCollector& collector) {
    forPriorityGroups(group, [&](const Ogre::RenderPriorityGroup& priority) {
        for (const auto* transparents :
             {&priority.getTransparents(), &priority.getTransparentsUnsorted()})
            transparents->acceptVisitor(&collector, QueuedRenderableCollection::OM_SORT_DESCENDING);
    });
}

/// The pass by which OGRE draws another's lights, outside of integrated techniques; null where
/// there is none but OGRE's own.
const Ogre::Pass* receiverOf(const Ogre::Pass& pass, Ogre::SceneManager& manager) {
    const Ogre::MaterialPtr own = pass.getParent()->getShadowReceiverMaterial();
    const Ogre::Technique* const technique = own ? own->getBestTechnique() : nullptr;
    return technique != nullptr ? technique->getPass(0) : shadowReceiverPassOf(manager);
}

} // namespace

void forQueuedPasses(Ogre::SceneManager& manager,
                     const std::function<void(const Ogre::Pass&, bool)>& visit) {
    for (const auto& group : manager.getRenderQueue()->_getQueueGroups()) {
        if (!group) continue;
        PassCollector collector;
        collectSolids(*group, collector);
        for (const Ogre::Pass* pass : collector.passes)
            visit(*pass, group->getShadowsEnabled());
    }
}

void forQueuedTechniques(Ogre::SceneManager& manager,
                         const std::function<void(Ogre::Technique&)>& visit) {
    PassCollector collector;
    for (const auto& group : manager.getRenderQueue()->_getQueueGroups()) {
        if (!group) continue;
        collectSolids(*group, collector);
        collectTransparents(*group, collector);
    }
    std::set<Ogre::Technique*> techniques;
    for (const Ogre::Pass* pass : collector.passes)
        techniques.insert(pass->getParent());
    for (Ogre::Technique* technique : techniques)
        visit(*technique);
}

bool drawsLixelsReceivers(Ogre::SceneManager& manager) {
    bool draws = false;
    forQueuedPasses(manager, [&](const Ogre::Pass& pass, bool) {
        const Ogre::Pass* const receiver =
            manager.isShadowTechniqueIntegrated() ? nullptr : receiverOf(pass, manager);
        draws |= readsMaps(pass) || (receiver != nullptr && readsMaps(*receiver));
    });
    return draws;
}

} // namespace Lixel
