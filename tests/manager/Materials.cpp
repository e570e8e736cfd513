#include "Materials.h"

#include "HeadlessOgre.h"

#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>

namespace Lixel::Tests {
namespace {

Ogre::MaterialPtr makeMaterial(const std::string& name, bool receives) {
    return flatMaterial(receives)->clone(name);
}

void makeTransparent(Ogre::Pass& pass) {
    pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    pass.setDepthWriteEnabled(false);
}

/// A copy of the first pass.
Ogre::Pass* addPass(Ogre::Technique& technique) {
    Ogre::Pass* pass = technique.createPass();
    *pass = *technique.getPass(0);
    return pass;
}

std::vector<std::string> makeMaterials() {
    makeMaterial("lit", true);
    makeMaterial("unshadowed", false);
    makeTransparent(*makeMaterial("transparent", true)->getTechnique(0)->getPass(0));

    const Ogre::MaterialPtr unsorted = makeMaterial("unsorted", true);
    makeTransparent(*unsorted->getTechnique(0)->getPass(0));
    unsorted->setTransparencyCastsShadows(true);
    unsorted->getTechnique(0)->getPass(0)->setTransparentSortingEnabled(false);

    const Ogre::MaterialPtr passes = makeMaterial("passes", true);
    makeTransparent(*addPass(*passes->getTechnique(0)));

    const Ogre::MaterialPtr levels = makeMaterial("levels", true);
    Ogre::Technique* coarse = levels->createTechnique();
    *coarse = *levels->getTechnique(0);
    coarse->setLodIndex(1);
    addPass(*coarse);
    levels->setLodLevels({12});

    std::vector<std::string> names{"lit",      "unshadowed", "transparent",
                                   "unsorted", "passes",     "levels"};
    for (const std::string& name : names)
        Ogre::MaterialManager::getSingleton().getByName(name, Ogre::RGN_DEFAULT)->load();
    return names;
}

} // namespace

const std::vector<std::string>& materials() {
    static const std::vector<std::string> names = makeMaterials();
    return names;
}

} // namespace Lixel::Tests
