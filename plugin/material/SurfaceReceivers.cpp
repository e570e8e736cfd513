#include "material/SurfaceReceivers.h"

#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreTextureUnitState.h>

#include <algorithm>

namespace Lixel {
namespace {

const char* const UnitName = "ShadowMap";

bool isForShadowMap(const Ogre::TextureUnitState* unit) {
    return unit->getContentType() == Ogre::TextureUnitState::CONTENT_SHADOW ||
           unit->getName() == UnitName;
}

} // namespace

void SurfaceReceivers::clear() {
    mMaps.clear();
    mModulativeLight = nullptr;
}

void SurfaceReceivers::notifyRenderSingleObject(Ogre::Renderable*, const Ogre::Pass* pass,
                                                const Ogre::AutoParamDataSource*,
                                                const Ogre::LightList* lights,
                                                bool suppressRenderStateChanges) {
    if (suppressRenderStateChanges ||
        mManager._getCurrentRenderStage() != Ogre::SceneManager::IRS_RENDER_RECEIVER_PASS)
        return;
    const auto& units = pass->getTextureUnitStates();
    const auto unit = std::find_if(units.begin(), units.end(), isForShadowMap);
    if (unit == units.end()) return;
    const bool additive = lights != nullptr && lights->size() == 1;
    const auto map = mMaps.find(additive ? lights->front() : mModulativeLight);
    if (map == mMaps.end()) return;
    if ((*unit)->_getTexturePtr() == map->second) return;
    (*unit)->_setTexturePtr(map->second);
    // The pass is bound already.
    Ogre::Root::getSingleton().getRenderSystem()->_setTextureUnitSettings(
        static_cast<std::size_t>(unit - units.begin()), **unit);
}

} // namespace Lixel
