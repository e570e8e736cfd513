#include "PictureKinds.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreBillboardSet.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterial.h>
#include <OgreParticleEmitter.h>
#include <OgreParticleSystem.h>
#include <OgrePass.h>
#include <OgreRenderTexture.h>
#include <OgreShadowCameraSetupLiSPSM.h>
#include <OgreStaticGeometry.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

void stopShadows(PictureScene& scene) {
    scene.sun->setCastShadows(false);
}

void shadowIntegrated(PictureScene& scene) {
    scene.castShadows(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED, "");
    scene.wear("Lixel/Surface/Integrated");
    scene.sun->setCustomShadowCameraSetup(XPSMShadowCameraSetup::create());
}

void shadowAdditive(PictureScene& scene) {
    scene.castShadows(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE, "Lixel/Receiver/Bilinear");
    scene.sun->setCustomShadowCameraSetup(OptimalShadowCameraSetup::create());
}

void shadowModulative(PictureScene& scene) {
    scene.castShadows(Ogre::SHADOWTYPE_TEXTURE_MODULATIVE, "Lixel/Receiver/Modulative");
    scene.sun->setCustomShadowCameraSetup(UniformShadowCameraSetup::create());
}

void shadowByStencil(PictureScene& scene) {
    scene.castShadows(Ogre::SHADOWTYPE_STENCIL_ADDITIVE, "");
}

void shadowByStencilModulative(PictureScene& scene) {
    scene.castShadows(Ogre::SHADOWTYPE_STENCIL_MODULATIVE, "");
}

void relateToCamera(PictureScene& scene) {
    shadowIntegrated(scene);
    scene.manager().setCameraRelativeRendering(true);
}

void showSkyAndFog(PictureScene& scene) {
    const Ogre::MaterialPtr sky = scene.surface(Ogre::ColourValue(0.2f, 0.4f, 0.9f));
    scene.manager().setSkyDome(true, sky->getName(), 5, 8, 100, true, Ogre::Quaternion::IDENTITY,
                               16, 16, -1, sky->getGroup());
    scene.manager().setFog(Ogre::FOG_LINEAR, Ogre::ColourValue(0.8f, 0.8f, 0.8f), 0, 10, 140);
}

void hideSkyAndFog(PictureScene& scene) {
    scene.manager().setSkyDome(false, "");
    scene.manager().setFog(Ogre::FOG_NONE);
}

void emitParticles(PictureScene& scene) {
    const Ogre::MaterialPtr material = scene.surface(Ogre::ColourValue(0.9f, 0.7f, 0.1f));
    Ogre::ParticleSystem* particles =
        scene.manager().createParticleSystem("particles", 40, material->getGroup());
    particles->setMaterialName(material->getName(), material->getGroup());
    particles->setDefaultDimensions(0.6f, 0.6f);
    Ogre::ParticleEmitter* emitter = particles->addEmitter("Point");
    emitter->setAngle(Ogre::Degree(0));
    emitter->setDirection(Vector3(0.3f, 1, 0));
    emitter->setParticleVelocity(6);
    emitter->setEmissionRate(40);
    emitter->setTimeToLive(1);
    scene.place().createChildSceneNode(Vector3(0, 1, 6))->attachObject(particles);
    Ogre::BillboardSet* billboards = scene.manager().createBillboardSet("billboards");
    billboards->setMaterial(material);
    billboards->setDefaultDimensions(1, 1);
    billboards->createBillboard(2, 2, 8);
    scene.place().attachObject(billboards);
}

void hideParticles(PictureScene& scene) {
    scene.manager().getParticleSystem("particles")->setVisible(false);
}

/// From another viewer, into a texture that a box of the picture wears.
void showTexture(PictureScene& scene) {
    const Ogre::TexturePtr texture = scene.addTexture(scene.manager().getName() + " other");
    Ogre::Camera* other = scene.manager().createCamera("other");
    other->setNearClipDistance(0.1f);
    Ogre::SceneNode* node = scene.place().createChildSceneNode(Vector3(8, 5, -10));
    node->lookAt(scene.place().getPosition(), Ogre::Node::TS_WORLD);
    node->attachObject(other);
    // Without the box: a texture cannot show itself.
    texture->getBuffer()->getRenderTarget()->addViewport(other)->setVisibilityMask(1);
    Ogre::Entity* screen =
        scene.add(Shape::Cube, Vector3(-2, 3, 7), Vector3(4, 3, 0.2f), Ogre::ColourValue::White);
    Ogre::Technique* technique = screen->getSubEntity(0)->getMaterial()->getTechnique(0);
    screen->setVisibilityFlags(2);
    for (Ogre::Pass* pass : technique->getPasses())
        if (pass->getNumTextureUnitStates() > 0) pass->getTextureUnitState(0)->setTexture(texture);
}

void hideTexture(PictureScene& scene) {
    scene.manager().getCamera("other")->getParentSceneNode()->setPosition(0, 40, 0);
}

void addSecondView(PictureScene& scene) {
    Ogre::Camera* other = scene.manager().createCamera("other");
    other->setNearClipDistance(0.1f);
    // With OGRE's far plane depths are so coarse that surfaces tie, and OGRE draws in the order of
    // addresses.
    other->setFarClipDistance(200);
    other->setProjectionType(Ogre::PT_ORTHOGRAPHIC);
    other->setOrthoWindow(20, 15);
    Ogre::SceneNode* node = scene.place().createChildSceneNode(Vector3(3, 12, 12));
    node->lookAt(scene.place().getPosition(), Ogre::Node::TS_WORLD);
    node->attachObject(other);
    scene.target->addViewport(other, 1, 0.5f, 0.5f, 0.5f, 0.5f);
}

void removeSecondView(PictureScene& scene) {
    scene.target->removeViewport(1);
}

void buildStatic(PictureScene& scene) {
    shadowIntegrated(scene);
    Ogre::Entity* cube = scene.add(Shape::Cube, Vector3(0, -30, 0), Vector3(1, 1, 1),
                                   Ogre::ColourValue(0.2f, 0.2f, 0.9f));
    Ogre::StaticGeometry* geometry = scene.manager().createStaticGeometry("static");
    geometry->setRegionDimensions(Vector3(10));
    geometry->setCastShadows(true);
    for (int i = 0; i < 12; ++i)
        geometry->addEntity(cube, Vector3(static_cast<float>(i - 6), 2, static_cast<float>(i % 5)),
                            Ogre::Quaternion::IDENTITY, Vector3(0.005f));
    geometry->build();
}

void destroyStatic(PictureScene& scene) {
    scene.manager().destroyStaticGeometry("static");
}

} // namespace

const std::vector<PictureKind>& pictureKinds() {
    static const std::vector<PictureKind> all{
        {"Integrated", Vector3::ZERO, shadowIntegrated, stopShadows},
        {"Additive", Vector3::ZERO, shadowAdditive, stopShadows},
        {"Modulative", Vector3::ZERO, shadowModulative, stopShadows},
        {"Stencil", Vector3::ZERO, shadowByStencil, stopShadows},
        {"StencilModulative", Vector3::ZERO, shadowByStencilModulative, stopShadows},
        {"CameraRelative", Vector3(70000, 0, -50000), relateToCamera, stopShadows},
        {"SkyAndFog", Vector3::ZERO, showSkyAndFog, hideSkyAndFog},
        {"Particles", Vector3::ZERO, emitParticles, hideParticles},
        {"RenderToTexture", Vector3::ZERO, showTexture, hideTexture},
        {"TwoViewports", Vector3::ZERO, addSecondView, removeSecondView},
        {"StaticGeometry", Vector3::ZERO, buildStatic, destroyStatic}};
    return all;
}

} // namespace Lixel::Tests
