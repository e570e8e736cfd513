// Whatever an application does between two frames: a map that is kept shows what it would show if
// it were drawn anew.

#include "TestStage.h"

#include "common/Surface.h"
#include "stress/Random.h"
#include "stress/Shrink.h"

#include <Lixel/manager/LixelSceneManager.h>
#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <cstdlib>
#include <numeric>
#include <utility>

namespace Lixel::Tests {
namespace {

/// Boxes, one of two kinds of lamp beside the sun, and a second viewer, all to be changed.
class ChangingScene {
public:
    /// @param announces whether changes that no node tells are announced, with Lixel's scene manager
    ChangingScene(const std::string& managerType, bool announces) : mStage(managerType, "Uniform") {
        Ogre::SceneManager& scene = manager();
        if (announces) {
            mAnnounced = static_cast<LixelSceneManager*>(&scene);
            mAnnounced->setChangesAnnounced(true);
        }
        mStage.stage.setShadowMapSize(256);
        scene.setShadowTextureCount(2);
        mLamp = scene.createLight("lamp");
        mLamp->setType(Ogre::Light::LT_SPOTLIGHT);
        mLamp->setSpotlightRange(Ogre::Degree(40), Ogre::Degree(70));
        mLamp->setAttenuation(60, 1, 0, 0);
        Ogre::SceneNode* const node = scene.getRootSceneNode()->createChildSceneNode();
        node->attachObject(mLamp);
        node->setPosition(6, 12, 4);
        node->setDirection(-0.4F, -1, -0.3F, Ogre::Node::TS_WORLD);
        mSecond = scene.createCamera("second");
        mSecond->setNearClipDistance(0.1F);
        mSecond->setFarClipDistance(200);
        Ogre::SceneNode* const viewer = scene.getRootSceneNode()->createChildSceneNode();
        viewer->attachObject(mSecond);
        viewer->setPosition(10, 6, 3);
        viewer->lookAt(Ogre::Vector3::ZERO, Ogre::Node::TS_WORLD);
        Random random(5);
        mBoxes.push_back(mStage.box);
        for (int i = 0; i < 5; ++i)
            addBox(random);
        mMover = mStage.addCube(Ogre::Vector3(1, 4, 0), Ogre::Vector3(0.7F));
        makeMaterials();
    }

    /// What moves by itself, whatever else is done, moves.
    void move() {
        if (!mMoves) return;
        mMovedRight = !mMovedRight;
        mMover->translate(mMovedRight ? 0.3F : -0.3F, 0, 0);
    }
    /// A map that stands still whatever moves.
    void useStableMap() {
        mStage.stage.setShadowSetup(UniformShadowCameraSetup::create({.stable = true}));
    }

    /// One change. @return what was done
    std::string change(Random& random) {
        switch (random.below(21)) {
        case 0:
        case 1:
            any(random).translate(place(random) / 8);
            return "move";
        case 2:
            any(random).yaw(Ogre::Degree(random.between(-30, 30)));
            return "turn";
        case 3:
            any(random).setScale(Ogre::Vector3(random.between(0.005F, 0.03F)) *
                                 Ogre::Vector3(1, 1, random.of({1.0F, 1.0F, -1.0F})));
            return "scale or mirror";
        case 4:
            entity(random).setVisible(random.oneIn(2));
            return announced("visible");
        case 5:
            entity(random).setCastShadows(random.oneIn(2));
            return announced("casts");
        case 6:
            entity(random).setVisibilityFlags(random.of({1U, 2U, 0U}));
            return announced("visibility flags");
        case 7:
            entity(random).getSubEntity(0)->setVisible(random.oneIn(2));
            return announced("part visible");
        case 8:
            entity(random).setRenderQueueGroup(random.of<Ogre::uint8>({50, 60}));
            return announced("queue group");
        case 9:
            entity(random).setMaterialName("Stale/" + std::to_string(random.below(3)));
            return announced("material");
        case 10:
            return announced(changeMaterial(random));
        case 11:
            return changeTree(random);
        case 12:
            return changeBoxes(random);
        case 13:
            return announced(renewSomething(random));
        case 14:
            return changeLight(random);
        case 15:
            mStage.stage.camera().getParentSceneNode()->translate(random.between(-1, 1), 0, 0);
            return "move the viewer";
        case 16:
            return changeViewers(random);
        case 17:
            return changeManager(random);
        case 18:
            return changeSetup(random);
        case 19:
            mMoves = random.oneIn(2);
            return mMoves ? "something moves" : "nothing moves by itself";
        default:
            return "nothing";
        }
    }

    std::vector<std::uint8_t> picture() {
        mStage.stage.drawFrame();
        return mStage.stage.picture();
    }
    Samples::Stage& stage() { return mStage.stage; }

private:
    std::string announced(std::string deed) {
        if (mAnnounced != nullptr) mAnnounced->announceChange();
        return deed;
    }
    Ogre::SceneManager& manager() { return mStage.stage.sceneManager(); }
    Ogre::SceneNode& any(Random& random) { return *mBoxes[random.below(mBoxes.size())]; }
    Ogre::Entity& entity(Random& random) {
        return *static_cast<Ogre::Entity*>(any(random).getAttachedObject(0));
    }
    static Ogre::Vector3 place(Random& random) {
        const float x = random.between(-8, 8);
        return {x, random.between(1, 3), random.between(-8, 8)};
    }
    void addBox(Random& random) {
        mBoxes.push_back(mStage.addCube(place(random), Ogre::Vector3(random.between(0.5F, 2))));
    }

    /// Materials that some boxes wear: whole, and with holes by a texture's alpha.
    static void makeMaterials() {
        for (int i = 0; i < 3; ++i)
            Samples::makeSurface("Stale/" + std::to_string(i), Ogre::ColourValue(0.8F, 0.7F, 0.6F));
    }
    static Ogre::Pass& passOf(Random& random) {
        return *Ogre::MaterialManager::getSingleton()
                    .getByName("Stale/" + std::to_string(random.below(3)))
                    ->getTechnique(0)
                    ->getPass(0);
    }
    std::string changeMaterial(Random& random) {
        switch (random.below(3)) {
        case 0:
            passOf(random).setCullingMode(
                random.of({Ogre::CULL_NONE, Ogre::CULL_CLOCKWISE, Ogre::CULL_ANTICLOCKWISE}));
            return "culling";
        case 1:
            passOf(random).setAlphaRejectSettings(
                random.oneIn(4) ? Ogre::CMPF_GREATER_EQUAL : Ogre::CMPF_ALWAYS_PASS, 128);
            return "holes";
        default:
            passOf(random).getParent()->getParent()->setReceiveShadows(random.oneIn(2));
            return "receives";
        }
    }

    std::string changeTree(Random& random) {
        Ogre::SceneNode& node = any(random);
        if (random.oneIn(2)) {
            Ogre::MovableObject* const lent = node.getAttachedObject(0);
            node.detachObject(lent);
            mStage.stage.drawFrame();
            node.attachObject(lent);
            return "detach for a frame";
        }
        Ogre::SceneNode* const parent =
            random.oneIn(2) ? mStage.ground : manager().getRootSceneNode();
        if (&node == mStage.box || node.getParentSceneNode() == parent) return "nothing";
        node.getParentSceneNode()->removeChild(&node);
        if (random.oneIn(3)) mStage.stage.drawFrame(); // out of the scene graph
        parent->addChild(&node);
        return "another parent";
    }

    std::string changeBoxes(Random& random) {
        if (random.oneIn(2) || mBoxes.size() < 3) {
            if (mBoxes.size() > 12) return "nothing";
            addBox(random);
            return "add";
        }
        Ogre::SceneNode* const gone = mBoxes.back();
        mBoxes.pop_back();
        manager().destroyEntity(static_cast<Ogre::Entity*>(gone->getAttachedObject(0)));
        manager().destroySceneNode(gone);
        return "destroy";
    }

    std::string renewSomething(Random& random) {
        switch (random.below(3)) {
        case 0:
            static_cast<Ogre::Entity*>(mStage.box->getAttachedObject(0))->getMesh()->reload();
            // OGRE makes its entities' parts anew, and they wear what the mesh says.
            for (const auto& [name, object] : manager().getMovableObjects("Entity")) {
                auto& entity = static_cast<Ogre::Entity&>(*object);
                entity._initialise(true);
                entity.setMaterialName("Stale/0");
            }
            return "reload the mesh";
        case 1:
            Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster")->reload();
            return "reload the caster material";
        default:
            manager().setShadowTexturePixelFormat(
                random.of({Ogre::PF_FLOAT32_R, Ogre::PF_FLOAT32_RGBA}));
            return "format of shadow textures";
        }
    }

    std::string changeLight(Random& random) {
        Ogre::Light& light = random.oneIn(2) ? mStage.stage.light() : *mLamp;
        switch (random.below(4)) {
        case 0:
            light.getParentSceneNode()->yaw(Ogre::Degree(random.between(-5, 5)),
                                            Ogre::Node::TS_WORLD);
            return "turn a light";
        case 1:
            light.setCastShadows(random.oneIn(2));
            return "light casts";
        case 2:
            light.setVisible(random.oneIn(2));
            return "light visible";
        default:
            mLamp->getParentSceneNode()->translate(random.between(-1, 1), 0, random.between(-1, 1));
            return "move the lamp";
        }
    }

    std::string changeViewers(Random& random) {
        Ogre::RenderWindow& window = mStage.stage.window();
        if (window.hasViewportWithZOrder(1)) {
            // Viewers share textures, and keep little.
            window.removeViewport(1);
            return "one viewer";
        }
        if (random.oneIn(2)) {
            mSecond->getParentSceneNode()->translate(random.between(-1, 1), 0, 0);
            return "move the second viewer";
        }
        window.addViewport(mSecond, 1, 0.6F, 0.6F, 0.4F, 0.4F);
        return "two viewers";
    }

    std::string changeManager(Random& random) {
        Ogre::SceneManager& scene = manager();
        switch (random.below(7)) {
        case 0:
            scene.setShadowTextureSize(random.of<unsigned short>({128, 256}));
            return "size of shadow textures";
        case 1:
            scene.setShadowCasterRenderBackFaces(random.oneIn(2));
            return "back faces";
        case 2:
            scene.setVisibilityMask(random.of({0xFFFFFFFFU, 1U}));
            return "visibility mask";
        case 3:
            scene.setCameraRelativeRendering(random.oneIn(2));
            return "camera-relative";
        case 4:
            scene.setShadowFarDistance(random.of({100.0F, 30.0F}));
            return "shadow distance";
        case 5:
            scene.setShadowTextureCount(random.of<std::size_t>({1, 2}));
            return "number of shadow textures";
        default:
            mStage.stage.viewport().setVisibilityMask(random.of({0xFFFFFFFFU, 1U}));
            return "mask of the view";
        }
    }

    std::string changeSetup(Random& random) {
        if (random.oneIn(2)) {
            const auto setup = random.of<std::string>({"Uniform", "XPSM", "LiSPSM", "Optimal"});
            mStage.stage.setShadowSetup(Samples::findShadowSetup(setup)->create());
            return "setup " + setup;
        }
        if (random.oneIn(2)) {
            useStableMap();
            return "a stable map";
        }
        const auto lasting = XPSMShadowCameraSetup::create();
        lasting->setLastingMaps(0.2F);
        mStage.stage.setShadowSetup(lasting);
        return "maps that last";
    }

    BoxOnGround mStage;
    LixelSceneManager* mAnnounced = nullptr;
    std::vector<Ogre::SceneNode*> mBoxes;
    Ogre::SceneNode* mMover;
    bool mMoves = true;
    bool mMovedRight = false;
    Ogre::Light* mLamp;
    Ogre::Camera* mSecond;
};

/// A walk through changes. What a step does follows from the seed and its number: steps can be left
/// out.
struct Changes {
    std::string managerType;
    bool announces = false;
    std::uint64_t seed = 1;
    /// Whether kept maps are compared, instead of pictures.
    bool proves = false;
    std::vector<std::size_t> steps;
};

struct ChangesEnd {
    /// Empty where no stale map was seen.
    std::string found;
    std::vector<std::string> deeds;
    std::size_t kept = 0;
    std::size_t layered = 0;  ///< maps drawn over a copy of what stands still
    std::size_t repeated = 0; ///< without a look at the scene
    std::size_t compared = 0; ///< pictures
};

/// Counts kept maps, and remembers where maps were fitted.
class KeptMaps : public ShadowMapObserver {
public:
    KeptMaps() { addShadowMapObserver(*this); }
    ~KeptMaps() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        count += map.decision.plan == MapPlan::Reuse ? 1U : 0U;
        layered += map.decision.plan == MapPlan::DrawMoving ? 1U : 0U;
        repeated += map.fitMicroseconds == 0.0 ? 1U : 0U;
        fits.push_back(map.fit.clipFromWorld);
    }
    std::size_t count = 0;
    std::size_t layered = 0;
    std::size_t repeated = 0;
    std::vector<Mat4> fits;
};

void walk(const Changes& changes, ChangesEnd& end) {
    ChangingScene scene(changes.managerType, changes.announces);
    KeptMaps kept;
    if (changes.seed % 2 == 1) scene.useStableMap();
    if (changes.proves) setProofMode(true, [&scene] { scene.stage().finish(); });
    for (const std::size_t step : changes.steps) {
        Random random(changes.seed * 0x2545F4914F6CDD1DULL + step);
        end.deeds.push_back(std::to_string(step) + ": " + scene.change(random));
        scene.picture();
        // Several frames without a change, so that there is something to keep; and as many as it
        // takes until what stands still is known to.
        for (std::size_t still = random.oneIn(5) ? 16 : random.below(6); still > 0; --still) {
            scene.move();
            scene.picture();
        }
        if (changes.proves && proofCount().different > 0) end.found = "a map is stale";
        if (!changes.proves && random.oneIn(2)) {
            kept.fits.clear();
            const std::vector<std::uint8_t> last = scene.picture();
            const std::vector<Mat4> fits = std::exchange(kept.fits, {});
            redrawShadowMaps();
            const std::vector<std::uint8_t> fresh = scene.picture();
            // A search goes on for some frames, and gives other maps.
            if (fits != kept.fits) continue;
            ++end.compared;
            if (last != fresh) end.found = "a picture shows a stale map";
        }
        if (!end.found.empty()) break;
    }
    end.kept = kept.count;
    end.layered = kept.layered;
    end.repeated = kept.repeated;
}

ChangesEnd go(const Changes& changes) {
    ChangesEnd end;
    try {
        walk(changes, end);
    } catch (const Ogre::Exception& exception) {
        end.found = exception.getDescription();
    }
    setProofMode(false);
    return end;
}

/// A walk that ends in a stale map, for people: the deeds of a short one.
std::string story(const Changes& walked) {
    const Changes changes = leaveOutSteps(walked, [](const Changes& one) {
        const ChangesEnd end = go(one);
        return end.found.empty() ? std::nullopt : std::optional(one.steps[end.deeds.size() - 1]);
    });
    const ChangesEnd end = go(changes);
    std::string told = "seed " + std::to_string(changes.seed) + ":\n";
    for (const std::string& deed : end.deeds)
        told += "  " + deed + "\n";
    return told + end.found;
}

/// For a long search by hand, the environment's LIXEL_WALKS asks for more walks.
std::uint64_t walksOfATest() {
    const char* walks = std::getenv("LIXEL_WALKS");
    return walks != nullptr ? std::strtoull(walks, nullptr, 10) : 1;
}

/// Whose maps.
struct MapsOf {
    std::string name;
    std::string managerType;
    bool announces = false;
};

void PrintTo(const MapsOf& whose, std::ostream* out) {
    *out << whose.name;
}

class StaleMapsTest : public testing::TestWithParam<MapsOf> {
protected:
    void expectNone(bool proves) {
        constexpr std::size_t Steps = 50;
        // Of a walk in which many maps are kept.
        constexpr std::uint64_t FirstSeed = 3;
        std::size_t kept = 0;
        std::size_t layered = 0;
        std::size_t compared = 0;
        std::size_t repeated = 0;
        for (std::uint64_t seed = FirstSeed; seed < FirstSeed + walksOfATest(); ++seed) {
            Changes changes{GetParam().managerType, GetParam().announces, seed, proves,
                            std::vector<std::size_t>(Steps)};
            std::iota(changes.steps.begin(), changes.steps.end(), std::size_t{0});
            const ChangesEnd end = go(changes);
            ASSERT_EQ(end.found, "") << story(changes);
            kept += end.kept;
            layered += end.layered;
            compared += end.compared;
            repeated += end.repeated;
        }
        // In proof mode nothing is taken for granted.
        if (GetParam().announces && !proves)
            EXPECT_GT(repeated, 10 * walksOfATest());
        else
            EXPECT_EQ(repeated, 0U);
        if (!proves) {
            EXPECT_GT(compared, 10 * walksOfATest());
        }
        EXPECT_GT(kept, 25 * walksOfATest());
        if (GetParam().managerType == "LixelSceneManager") {
            EXPECT_GT(layered, 5 * walksOfATest());
        } else {
            EXPECT_EQ(layered, 0U);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(SceneManager, StaleMapsTest,
                         testing::Values(MapsOf{"DefaultSceneManager", "DefaultSceneManager"},
                                         MapsOf{"LixelSceneManager", "LixelSceneManager"},
                                         MapsOf{"Announced", "LixelSceneManager", true}),
                         [](const auto& test) { return test.param.name; });

TEST_P(StaleMapsTest, AreNeverKept) {
    expectNone(true);
}

TEST_P(StaleMapsTest, AreNeverShown) {
    expectNone(false);
}

} // namespace
} // namespace Lixel::Tests
