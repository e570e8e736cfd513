#include "manager/NearestDepth.h"

#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

namespace Lixel {
namespace {

/// Whether it replaces what is there. So do blended surfaces, whose casters have an alpha of 1.
bool replaces(const Ogre::ColourBlendState& state) {
    const bool covers = state.sourceFactor == Ogre::SBF_ONE && state.destFactor == Ogre::SBF_ZERO;
    const bool blends = state.sourceFactor == Ogre::SBF_SOURCE_ALPHA &&
                        state.destFactor == Ogre::SBF_ONE_MINUS_SOURCE_ALPHA;
    return state.operation == Ogre::SBO_ADD && (covers || blends);
}

/// OGRE takes ONE and ZERO for no blending at all, whatever the operation.
Ogre::ColourBlendState minimumOf(Ogre::ColourBlendState state) {
    state.operation = state.alphaOperation = Ogre::SBO_MIN;
    state.sourceFactor = state.sourceFactorAlpha = Ogre::SBF_ONE;
    state.destFactor = state.destFactorAlpha = Ogre::SBF_ONE;
    return state;
}

} // namespace

NearestDepth::NearestDepth(Ogre::SceneManager& manager) : mManager(manager) {
    mManager.addRenderObjectListener(this);
}

NearestDepth::~NearestDepth() {
    mManager.removeRenderObjectListener(this);
}

void NearestDepth::notifyRenderSingleObject(Ogre::Renderable*, const Ogre::Pass* pass,
                                            const Ogre::AutoParamDataSource*,
                                            const Ogre::LightList*,
                                            bool suppressRenderStateChanges) {
    if (suppressRenderStateChanges || !replaces(pass->getBlendState())) {
        mDependsOnOrder = true;
        return;
    }
    Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    system.setColourBlendState(minimumOf(pass->getBlendState()));
    system._setDepthBufferParams(false, false, pass->getDepthFunction());
}

} // namespace Lixel
