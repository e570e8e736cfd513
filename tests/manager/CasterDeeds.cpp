// What may happen to casters between two frames.
#include "CasterDeeds.h"

#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <array>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

constexpr const char* PanelMesh = "caster panel";

Ogre::Pass& firstPass(Ogre::Entity& caster) {
    return *caster.getSubEntity(0)->getMaterial()->getTechnique(0)->getPass(0);
}

/// After a reload, entities begin anew.
void reloadPanels(ChangedScene& scene, Ogre::Entity&, Random&) {
    Ogre::MeshManager::getSingleton().getByName(PanelMesh, Ogre::RGN_DEFAULT)->reload();
    for (Ogre::Entity* caster : scene.casters) {
        if (caster->getMesh()->getName() != PanelMesh) continue;
        caster->_initialise(true);
        caster->setMaterial(scene.batches.scene().surface(Ogre::ColourValue(0.8f, 0.5f, 0.2f)));
    }
}

/// Not the scene manager's: OGRE leaves that as the surface needed it that was drawn last.
Ogre::MaterialPtr ownCaster() {
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    const char* const name = "batch's own caster";
    const Ogre::MaterialPtr made = materials.getByName(name, "Lixel");
    return made ? made : materials.getByName("Lixel/Caster", "Lixel")->clone(name);
}

void setOwnCaster(ChangedScene&, Ogre::Entity& caster, Random& random) {
    firstPass(caster).getParent()->setShadowCasterMaterial(random.oneIn(5) ? ownCaster()
                                                                           : Ogre::MaterialPtr());
}

void destroyCaster(ChangedScene& scene, Ogre::Entity& caster, Random&) {
    if (scene.casters.size() < 12) return;
    std::erase(scene.casters, &caster);
    caster.detachFromParent();
    scene.batches.manager().destroyEntity(&caster);
}

constexpr std::array Deeds{
    CasterDeed{"show",
               [](ChangedScene&, Ogre::Entity& c, Random& r) { c.setVisible(!r.oneIn(3)); }},
    CasterDeed{"mask",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   c.setVisibilityFlags(r.of<Ogre::uint32>({1, 2, 3}));
               }},
    CasterDeed{"viewport's mask",
               [](ChangedScene& s, Ogre::Entity&, Random& r) {
                   s.batches.scene().target->getViewport(0)->setVisibilityMask(
                       r.of<Ogre::uint32>({1, 3, 3}));
               }},
    CasterDeed{"cast",
               [](ChangedScene&, Ogre::Entity& c, Random& r) { c.setCastShadows(!r.oneIn(3)); }},
    CasterDeed{"show a part", [](ChangedScene&, Ogre::Entity& c,
                                 Random& r) { c.getSubEntity(0)->setVisible(!r.oneIn(3)); }},
    CasterDeed{"culling",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   firstPass(c).setCullingMode(
                       r.of({Ogre::CULL_NONE, Ogre::CULL_CLOCKWISE, Ogre::CULL_ANTICLOCKWISE}));
               }},
    CasterDeed{"holes",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   firstPass(c).setAlphaRejectSettings(
                       r.oneIn(5) ? Ogre::CMPF_GREATER_EQUAL : Ogre::CMPF_ALWAYS_PASS, 128);
               }},
    CasterDeed{"blending",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   firstPass(c).setSceneBlending(r.oneIn(5) ? Ogre::SBT_TRANSPARENT_ALPHA
                                                            : Ogre::SBT_REPLACE);
               }},
    CasterDeed{"own caster", setOwnCaster},
    CasterDeed{"another's material",
               [](ChangedScene& s, Ogre::Entity& c, Random& r) {
                   c.setMaterial(
                       s.casters[r.below(s.casters.size())]->getSubEntity(0)->getMaterial());
               }},
    CasterDeed{"scale",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   const float factor = r.of({-1.0f, -1.0f, 0.8f, 1.25f, 1.1f});
                   c.getParentSceneNode()->scale(factor, r.oneIn(2) ? factor : 1, 1);
               }},
    CasterDeed{"move",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   c.getParentSceneNode()->translate(r.between(-1, 1), 0, r.between(-1, 1));
               }},
    CasterDeed{"turn",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   c.getParentSceneNode()->yaw(Ogre::Degree(r.between(0, 90)));
               }},
    CasterDeed{"queue group",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   c.setRenderQueueGroup(r.of<Ogre::uint8>({50, 50, 60}));
               }},
    CasterDeed{"part's priority",
               [](ChangedScene&, Ogre::Entity& c, Random& r) {
                   c.getSubEntity(0)->setRenderQueueGroupAndPriority(
                       50, r.of<Ogre::ushort>({90, 100, 100}));
               }},
    CasterDeed{"reload the panels' mesh", reloadPanels},
    CasterDeed{"add a panel",
               [](ChangedScene& s, Ogre::Entity&, Random& r) {
                   const float x = r.between(-8, 8);
                   if (s.casters.size() < 40) addPanel(s, Vector3(x, 1.2f, r.between(-8, 8)));
               }},
    CasterDeed{"destroy", destroyCaster},
    CasterDeed{"relate to the camera",
               [](ChangedScene& s, Ogre::Entity&, Random& r) {
                   s.batches.manager().setCameraRelativeRendering(r.oneIn(2));
               }},
    CasterDeed{"turn the sun",
               [](ChangedScene& s, Ogre::Entity&, Random& r) {
                   s.batches.scene().sun->getParentSceneNode()->yaw(Ogre::Degree(r.between(0, 20)),
                                                                    Ogre::Node::TS_WORLD);
               }},
    CasterDeed{"technique",
               [](ChangedScene& s, Ogre::Entity&, Random& r) {
                   s.batches.manager().setShadowTechnique(
                       r.of({Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED,
                             Ogre::SHADOWTYPE_TEXTURE_ADDITIVE,
                             Ogre::SHADOWTYPE_TEXTURE_MODULATIVE_INTEGRATED}));
               }},
    CasterDeed{"nothing", [](ChangedScene&, Ogre::Entity&, Random&) {}},
    CasterDeed{"nothing again", [](ChangedScene&, Ogre::Entity&, Random&) {}},
};

} // namespace

std::span<const CasterDeed> casterDeeds() {
    return Deeds;
}

void addPanel(ChangedScene& scene, const Vector3& position) {
    if (!Ogre::MeshManager::getSingleton().resourceExists(PanelMesh, Ogre::RGN_DEFAULT))
        Ogre::MeshManager::getSingleton().createPlane(
            PanelMesh, Ogre::RGN_DEFAULT, Ogre::Plane(Vector3(1, 0.3f, 0), 0), 2, 3, 2, 2);
    PictureScene& pictures = scene.batches.scene();
    Ogre::Entity* const panel = pictures.manager().createEntity(
        "panel" + std::to_string(scene.made++), PanelMesh, Ogre::RGN_DEFAULT);
    panel->setMaterial(pictures.surface(Ogre::ColourValue(0.8f, 0.5f, 0.2f)));
    pictures.place().createChildSceneNode(position)->attachObject(panel);
    scene.casters.push_back(panel);
}

} // namespace Lixel::Tests
