#include "ManagerOgre.h"

#include "OwnBoxesManager.h"
#include "Probe.h"

#include <OgreMath.h>
#include <OgreRoot.h>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace Lixel::Tests {
namespace {

class NoChance : public Ogre::Math::RandomValueProvider {
public:
    Ogre::Real getRandomUnit() override { return 0.25f; }
};

class ManagerOgre : public HeadlessOgre {
public:
    ManagerOgre() {
        root().loadPlugin(LIXEL_PLUGIN_DIR "/Plugin_Lixel.so");
        root().loadPlugin(OGRE_PLUGIN_DIR "/Plugin_ParticleFX");
        mFactories.push_back(makeOwnBoxesFactory(Fault::None));
        for (const Fault fault : AllFaults)
            mFactories.push_back(makeOwnBoxesFactory(fault));
        for (const auto& factory : mFactories)
            root().addSceneManagerFactory(factory.get());
        root().addMovableObjectFactory(mProbes.get());
        Ogre::Math::SetRandomValueProvider(&mNoChance);
    }
    ~ManagerOgre() {
        Ogre::Math::SetRandomValueProvider(nullptr);
        for (const auto& factory : mFactories)
            root().removeSceneManagerFactory(factory.get());
        root().removeMovableObjectFactory(mProbes.get());
    }

private:
    NoChance mNoChance;
    std::unique_ptr<Ogre::MovableObjectFactory> mProbes = makeProbeFactory();
    std::vector<std::unique_ptr<Ogre::SceneManagerFactory>> mFactories;
};

std::unique_ptr<ManagerOgre> theOgre;

/// Before the program's own end: Lixel's library has objects that end with it, and that it needs
/// when Ogre::Root ends.
class EndOgre : public testing::Environment {
public:
    void TearDown() override { theOgre.reset(); }
};

[[maybe_unused]] const testing::Environment* const theEnd =
    testing::AddGlobalTestEnvironment(new EndOgre);

} // namespace

HeadlessOgre& ogreWithManagers() {
    if (theOgre == nullptr) theOgre = std::make_unique<ManagerOgre>();
    return *theOgre;
}

} // namespace Lixel::Tests
