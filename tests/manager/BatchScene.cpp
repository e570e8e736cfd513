#include "BatchScene.h"

#include "ManagerOgre.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreHardwarePixelBuffer.h>

#include <algorithm>

// Answered by OSMesa.
extern "C" void (*glXGetProcAddressARB(const unsigned char*))();

namespace Lixel::Tests {

BatchScene::BatchScene(bool usesBatches, bool reusesMaps)
    : mScene(ogreWithManagers(), LixelSceneManager::TypeName) {
    manager().setCasterBatches(usesBatches);
    mScene.castShadows(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "Lixel/Receiver");
    mScene.wear("Lixel/Surface/Integrated");
    const auto setup = std::make_shared<XPSMShadowCameraSetup>();
    setup->setReuseMaps(reusesMaps);
    mScene.sun->setCustomShadowCameraSetup(setup);
}

std::vector<std::uint8_t> BatchScene::drawMap() {
    const Ogre::Vector3 place = mScene.viewer->getPosition();
    mScene.draw();
    mScene.viewer->setPosition(place); // from which it has moved
    finishDrawing();
    const Ogre::TexturePtr& map = manager().getShadowTexture(0);
    mDrawCalls = map->getBuffer()->getRenderTarget()->getStatistics().batchCount;
    std::vector<std::uint8_t> texels(
        Ogre::PixelUtil::getMemorySize(map->getWidth(), map->getHeight(), 1, map->getFormat()));
    map->getBuffer()->blitToMemory(
        Ogre::PixelBox(map->getWidth(), map->getHeight(), 1, map->getFormat(), texels.data()));
    return texels;
}

void finishDrawing() {
    const auto* const name = reinterpret_cast<const unsigned char*>("glFinish");
    reinterpret_cast<void (*)()>(glXGetProcAddressARB(name))();
}

std::size_t differingTexels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                            std::size_t bytes) {
    if (a.size() != b.size()) return std::max(a.size(), b.size()) / bytes;
    std::size_t count = 0;
    for (std::size_t texel = 0; texel + bytes <= a.size(); texel += bytes)
        count += std::equal(&a[texel], &a[texel] + bytes, &b[texel]) ? 0U : 1U;
    return count;
}

} // namespace Lixel::Tests
