#include "HardScene.h"

#include "common/Surface.h"

#include <Lixel/scene/OgreVersions.h>

#include <cmath>

namespace Lixel::Tests {
namespace {

/// Sides of OGRE's prefab cube.
constexpr float CubeSide = 100.0F;

Ogre::MaterialPtr surface(bool receives) {
    const std::string name = receives ? "HardReceiver" : "HardUnshadowed";
    Ogre::MaterialPtr found = Ogre::MaterialManager::getSingleton().getByName(name);
    if (!found) found = Samples::makeSurface(name, Ogre::ColourValue(0.8F, 0.8F, 0.8F));
    found->setReceiveShadows(receives);
    return found;
}

} // namespace

HardScene::HardScene(Samples::Stage& onStage) : stage(onStage), light(&onStage.light()) {
    setReach(100);
    setPlanes(0.1F, 1000);
    look({0, 8, 16}, {0, 0, 0});
    sun({-1, -1, -0.3F});
}

Ogre::SceneNode* HardScene::addBox(const Ogre::Vector3& centre, const Ogre::Vector3& size,
                                   bool casts, bool receives) {
    Ogre::Entity* const entity =
        manager().createEntity("Box" + std::to_string(mBoxes++), Ogre::SceneManager::PT_CUBE);
    entity->setMaterial(surface(receives));
    entity->setCastShadows(casts);
    Ogre::SceneNode* const node =
        manager().getRootSceneNode()->createChildSceneNode(toWorld(centre));
    node->setScale(size * (unit / CubeSide));
    node->attachObject(entity);
    return node;
}

void HardScene::addGround(float halfSide, int tiles) {
    const float side = 2.0F * halfSide / static_cast<float>(tiles);
    for (int x = 0; x < tiles; ++x)
        for (int z = 0; z < tiles; ++z)
            addBox({side * (static_cast<float>(x) + 0.5F) - halfSide, -0.5F,
                    side * (static_cast<float>(z) + 0.5F) - halfSide},
                   {side, 1, side}, false);
}

void HardScene::addField() {
    addGround();
    for (int x = -3; x <= 3; ++x)
        for (int z = -3; z <= 3; ++z) {
            const float height = static_cast<float>(1 + (x * z + 12) % 4);
            const Ogre::Vector3 base(8.0F * static_cast<float>(x), 0,
                                     8.0F * static_cast<float>(z) + 3);
            addBox(base + Ogre::Vector3(0, 0.5F * height, 0), {1.5F, height, 1.5F});
            // A light overhead finds something to shadow under it.
            addBox(base + Ogre::Vector3(0.5F, height + 1, 0), {3, 0.2F, 3});
        }
}

void HardScene::look(const Ogre::Vector3& eye, const Ogre::Vector3& target) {
    Ogre::SceneNode* const node = viewer().getParentSceneNode();
    node->setPosition(toWorld(eye));
    // As a difference, which far from the origin still has all its digits.
    node->setFixedYawAxis(std::abs((target - eye).normalisedCopy().y) < 0.999F);
    node->setDirection(target - eye, Ogre::Node::TS_WORLD);
}

void HardScene::setPlanes(float near, float far) {
    viewer().setNearClipDistance(near * unit);
    viewer().setFarClipDistance(far * unit);
}

void HardScene::setReach(float distance) {
    manager().setShadowFarDistance(distance * unit);
}

void HardScene::shareAmong(std::size_t maps) {
    manager().setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    const std::size_t count = maps * manager().getShadowTextureConfigList().size();
    for (const auto type :
         {Ogre::Light::LT_DIRECTIONAL, Ogre::Light::LT_SPOTLIGHT, Ogre::Light::LT_POINT})
        manager().setShadowTextureCountPerLightType(type, maps);
    const Ogre::ShadowTextureConfig one = manager().getShadowTextureConfigList().front();
    manager().setShadowTextureCount(count);
    for (std::size_t i = 0; i < count; ++i)
        manager().setShadowTextureConfig(i, one);
}

void HardScene::sun(const Ogre::Vector3& direction) {
    light->setType(Ogre::Light::LT_DIRECTIONAL);
    light->getParentSceneNode()->setDirection(direction, Ogre::Node::TS_WORLD);
}

void HardScene::sunAt(float azimuth, float elevation) {
    const Ogre::Radian a{Ogre::Degree(azimuth)};
    const Ogre::Radian e{Ogre::Degree(elevation)};
    sun({-Ogre::Math::Sin(a) * Ogre::Math::Cos(e), -Ogre::Math::Sin(e),
         -Ogre::Math::Cos(a) * Ogre::Math::Cos(e)});
}

void HardScene::spot(const Ogre::Vector3& position, const Ogre::Vector3& target,
                     float outerDegrees) {
    light->setType(Ogre::Light::LT_SPOTLIGHT);
    light->setSpotlightRange(Ogre::Degree(0.8F * outerDegrees), Ogre::Degree(outerDegrees), 1);
    light->getParentSceneNode()->setPosition(toWorld(position));
    light->getParentSceneNode()->setDirection(target - position, Ogre::Node::TS_WORLD);
}

void HardScene::sunExactly(const Ogre::Vector3& direction) {
    light->setType(Ogre::Light::LT_DIRECTIONAL);
    light->getParentSceneNode()->resetOrientation();
    setOwnDirection(direction);
}

Ogre::Vector3 HardScene::ownDirection() const {
    return Lixel::ownDirection(*light);
}

void HardScene::setOwnDirection(const Ogre::Vector3& direction) {
    Lixel::setOwnDirection(*light, direction);
}

} // namespace Lixel::Tests
