#include "manager/NearestDepth.h"

#include "scene/CasterPass.h"
#include "scene/OgreVersions.h"

#include <OgrePass.h>
#include <OgrePixelFormat.h>
#include <OgreRenderSystem.h>
#include <OgreRenderTarget.h>
#include <OgreRoot.h>

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

bool storesDepthAsColour(Ogre::SceneManager& manager, const Ogre::RenderTarget& target) {
    const Ogre::PixelFormat format = target.suggestPixelFormat();
    return !Ogre::PixelUtil::isDepth(format) && !Ogre::PixelUtil::isInteger(format) &&
           isOwnProgram(casterProgramsOf(manager).fragment);
}

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
    if (suppressRenderStateChanges || !replaces(pass->getBlendState())) return;
    Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    system.setColourBlendState(minimumOf(pass->getBlendState()));
    system._setDepthBufferParams(false, false, pass->getDepthFunction());
}

} // namespace Lixel
