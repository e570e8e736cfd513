// Maps in layers (what stands still, and what moves over it): when they are, and that each texel is
// that of maps drawn at once, whatever happens to casters.
#include "CasterDeeds.h"
#include "ManagerOgre.h"
#include "Meshes.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapBudget.h>
#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowCameraSetups.h>
#include <Lixel/setup/ShadowMapObserver.h>

#include <OgreAnimationState.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreLog.h>
#include <OgreLogManager.h>
#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreRenderQueueListener.h>
#include <OgreSimpleRenderable.h>
#include <OgreSubEntity.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

/// Of no namespace: an application's.
class LayersTestListener : public Ogre::RenderQueueListener {};

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;
using SetupPtr = std::shared_ptr<FittedShadowCameraSetup>;
using Texels = std::vector<std::uint8_t>;

/// Counts what is done with a scene's maps.
class LayerDecisions : private ShadowMapObserver {
public:
    explicit LayerDecisions(const Ogre::SceneManager& manager) : mManager(manager) {
        addShadowMapObserver(*this);
    }
    ~LayerDecisions() override { removeShadowMapObserver(*this); }
    LayerDecisions(const LayerDecisions&) = delete;
    LayerDecisions& operator=(const LayerDecisions&) = delete;

    /// Of the last map.
    MapDecision last;
    std::map<MapPlan, std::size_t> counts;

private:
    void shadowMapFitted(const ShadowMap& map) override {
        if (&map.sceneManager != &mManager) return;
        last = map.decision;
        ++counts[map.decision.plan];
    }

    const Ogre::SceneManager& mManager;
};

/// Reads all maps of a scene.
Texels readMaps(Ogre::SceneManager& manager) {
    finishDrawing();
    Texels all;
    for (const ShadowTarget& target : shadowTargetsOf(manager)) {
        const Ogre::Texture& map = *target.texture;
        Texels texels(
            Ogre::PixelUtil::getMemorySize(map.getWidth(), map.getHeight(), 1, map.getFormat()));
        target.texture->getBuffer()->blitToMemory(
            Ogre::PixelBox(map.getWidth(), map.getHeight(), 1, map.getFormat(), texels.data()));
        all.insert(all.end(), texels.begin(), texels.end());
    }
    return all;
}

/// How many layers there are.
std::size_t countLayers() {
    std::size_t count = 0;
    for (const auto& [handle, texture] : Ogre::TextureManager::getSingleton().getResourceIterator())
        count += texture->getName().starts_with("Lixel/StillLayer") ? 1U : 0U;
    return count;
}

/// A scene with casters of all kinds. Some of them move in each frame.
class MovingScene {
public:
    explicit MovingScene(const SetupPtr& setup) : batches(true, true), changed{batches, {}} {
        batches.scene().moving.clear();
        setSetup(setup);
        // Not the ground, and not what hangs below another.
        for (int i = 1; i < 25; ++i)
            changed.casters.push_back(manager().getEntity("thing" + std::to_string(i)));
        for (int i = 0; i < 8; ++i)
            addPanel(changed, Vector3(static_cast<float>(i) * 1.5f - 6, 1.5f, -4));
        for (int i = 0; i < 4; ++i)
            movers.push_back(changed.casters[static_cast<std::size_t>(5 * i + 2)]);
    }

    void setSetup(const SetupPtr& setup) { batches.scene().sun->setCustomShadowCameraSetup(setup); }
    LixelSceneManager& manager() { return batches.manager(); }

    /// Casters that may look different each time.
    void addRestless() {
        meshes(manager());
        jointed = manager().createEntity("jointed", JointedMesh);
        jointed->setMaterial(batches.scene().surface(Ogre::ColourValue::White));
        jointed->getAnimationState("bend")->setEnabled(true);
        Ogre::SceneNode* const node =
            batches.scene().place().createChildSceneNode(Vector3(2, 2, 2));
        node->setScale(Vector3(1.5f / jointed->getBoundingRadius()));
        node->attachObject(jointed);
        Ogre::ManualObject* const flag = manager().createManualObject("flag");
        flag->begin(batches.scene().surface(Ogre::ColourValue::White)->getName(),
                    Ogre::RenderOperation::OT_TRIANGLE_LIST, "Lixel");
        for (const Vector3& corner : {Vector3(0, 1, 0), Vector3(2, 1, 1), Vector3(1, 3, 0)}) {
            flag->position(corner);
            flag->normal(0, 0, 1);
            flag->textureCoord(0, 0);
        }
        flag->end();
        batches.scene().place().createChildSceneNode(Vector3(-3, 0, 3))->attachObject(flag);
    }

    /// The next frame, in which movers move.
    void move() {
        ++mFrame;
        std::erase_if(movers, [this](Ogre::Entity* mover) {
            return std::ranges::find(changed.casters, mover) == changed.casters.end();
        });
        const float step = mFrame % 8 < 4 ? 0.2f : -0.2f;
        for (Ogre::Entity* mover : movers)
            if (mover->isAttached()) mover->getParentSceneNode()->translate(step, 0, step / 2);
        if (jointed != nullptr) jointed->getAnimationState("bend")->addTime(0.03f);
    }
    Texels draw() {
        batches.drawMap();
        return readMaps(manager());
    }
    Texels drawMoved() {
        move();
        return draw();
    }

    BatchScene batches;
    ChangedScene changed;
    std::vector<Ogre::Entity*> movers;
    Ogre::Entity* jointed = nullptr;

private:
    unsigned mFrame = 0;
};

/// Proves each map while it lives.
class LayerProof : private Ogre::LogListener {
public:
    LayerProof() {
        Ogre::LogManager::getSingleton().getDefaultLog()->addListener(this);
        setProofMode(true, finishDrawing);
    }
    ~LayerProof() override {
        setProofMode(false);
        Ogre::LogManager::getSingleton().getDefaultLog()->removeListener(this);
    }
    LayerProof(const LayerProof&) = delete;
    LayerProof& operator=(const LayerProof&) = delete;

    /// What it has found.
    std::string found;

private:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                       const Ogre::String&, bool&) override {
        if (message.find("proof mode") != Ogre::String::npos) found += message + "\n";
    }
};

/// A map whose matrices stand still.
SetupPtr stableSetup() {
    return UniformShadowCameraSetup::create({.stable = true});
}

// What is done when.

class LayersTest : public testing::Test {
protected:
    LayersTest() : setup(stableSetup()), scene(setup), decisions(scene.manager()) {}

    /// Draws until the map is drawn in layers.
    void settle() {
        for (int frame = 0; frame < 20; ++frame)
            scene.drawMoved();
        ASSERT_EQ(decisions.last.plan, MapPlan::DrawMoving) << toString(decisions.last.reason);
    }

    SetupPtr setup;
    MovingScene scene;
    LayerDecisions decisions;
};

TEST_F(LayersTest, HaveWhatMovesDrawnOverWhatStandsStill) {
    settle();
    EXPECT_EQ(decisions.last.reason, PlanReason::CastersChanged);
    EXPECT_LE(scene.batches.drawCalls(), scene.movers.size());
    EXPECT_EQ(countLayers(), 1U);
    const Texels layered = scene.drawMoved();
    setup->setMovingApart(false);
    redrawShadowMaps();
    EXPECT_EQ(differingTexels(layered, scene.draw()), 0U);
    EXPECT_EQ(countLayers(), 0U);
    EXPECT_EQ(decisions.last.plan, MapPlan::Draw);
    const Texels other = scene.drawMoved();
    EXPECT_GT(differingTexels(layered, other), 20U);
}

TEST_F(LayersTest, ComeWithRestlessCasters) {
    scene.addRestless();
    scene.movers.clear();
    settle();
    EXPECT_EQ(decisions.last.reason, PlanReason::RestlessCaster);
    const LayerProof proof;
    for (int frame = 0; frame < 4; ++frame)
        scene.drawMoved();
    EXPECT_EQ(proofCount().layered, 4U);
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
}

TEST_F(LayersTest, AreNotMadeForWhatMovesOnce) {
    for (int frame = 0; frame < 20; ++frame)
        scene.draw();
    EXPECT_EQ(decisions.last.plan, MapPlan::Reuse);
    scene.drawMoved();
    EXPECT_EQ(decisions.last.plan, MapPlan::Draw);
    scene.draw();
    EXPECT_EQ(decisions.last.plan, MapPlan::Reuse);
    EXPECT_EQ(countLayers(), 0U);
}

TEST_F(LayersTest, AreNotMadeWhereAllMove) {
    scene.movers = scene.changed.casters;
    // All but the ground and what hangs below another.
    for (const char* name : {"thing0", "thing25"})
        scene.manager().getEntity(name)->setCastShadows(false);
    for (int frame = 0; frame < 30; ++frame)
        scene.drawMoved();
    EXPECT_EQ(decisions.last.plan, MapPlan::Draw);
    EXPECT_EQ(countLayers(), 0U);
}

TEST_F(LayersTest, AreDroppedWhenTheyAreOfNoUse) {
    settle();
    for (int frame = 0; frame < 100; ++frame)
        scene.draw();
    EXPECT_EQ(decisions.last.plan, MapPlan::Reuse);
    EXPECT_EQ(countLayers(), 1U);
    scene.drawMoved();
    EXPECT_EQ(decisions.last.plan, MapPlan::DrawMoving);
    for (int frame = 0; frame < 130; ++frame)
        scene.draw();
    EXPECT_EQ(countLayers(), 0U);
    settle();
}

TEST_F(LayersTest, AreDroppedWithTheirSetup) {
    settle();
    scene.setSetup(stableSetup());
    setup.reset();
    EXPECT_EQ(countLayers(), 0U);
}

TEST_F(LayersTest, TakeInWhatHasStopped) {
    settle();
    while (scene.movers.size() > 1)
        scene.movers.pop_back();
    for (int frame = 0; frame < 60; ++frame)
        scene.drawMoved();
    EXPECT_EQ(decisions.last.plan, MapPlan::DrawMoving);
    EXPECT_EQ(scene.batches.drawCalls(), 1U);
}

TEST_F(LayersTest, LeaveOutWhatBeginsToMoveAtOnce) {
    settle();
    for (int frame = 0; frame < 10; ++frame)
        scene.drawMoved();
    decisions.counts.clear();
    scene.movers.push_back(scene.changed.casters.front());
    scene.drawMoved(); // both layers
    scene.drawMoved();
    EXPECT_EQ(decisions.counts[MapPlan::Draw], 1U);
    EXPECT_EQ(decisions.counts[MapPlan::DrawMoving], 1U);
}

TEST_F(LayersTest, WaitWhereSomethingAlwaysBeginsToMove) {
    decisions.counts.clear();
    for (std::size_t frame = 0; frame < 200; ++frame) {
        scene.movers = {scene.changed.casters[frame % scene.changed.casters.size()]};
        scene.drawMoved();
    }
    EXPECT_LE(decisions.counts[MapPlan::DrawMoving], 8U);
}

TEST_F(LayersTest, WorkWithBudget) {
    settle();
    MapBudget budget;
    budget.maps = 1;
    setMapBudget(budget);
    const LayerProof proof;
    for (int frame = 0; frame < 6; ++frame)
        scene.drawMoved();
    EXPECT_EQ(decisions.last.plan, MapPlan::DrawMoving);
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
    EXPECT_GE(proofCount().layered, 5U);
    setMapBudget({});
}

/// Moves a map's camera after it was set up.
class CameraShift : public SceneManagerListener {
public:
    void shadowTextureCasterPreViewProj(Ogre::Light*, Ogre::Camera* camera, std::size_t) override {
        Ogre::Matrix4 projection = camera->getProjectionMatrix();
        projection[0][3] += 0.1f;
        camera->setCustomProjectionMatrix(true, projection);
    }
};

TEST_F(LayersTest, AreDrawnFromWhereTheCameraIs) {
    settle();
    CameraShift shift;
    addSceneManagerListener(scene.manager(), shift);
    const LayerProof proof;
    for (int frame = 0; frame < 4; ++frame)
        scene.drawMoved();
    removeSceneManagerListener(scene.manager(), shift);
    for (int frame = 0; frame < 4; ++frame)
        scene.drawMoved();
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
    EXPECT_EQ(proofCount().layered, 8U);
}

/// An application's own object that may throw when it is to be drawn.
class Tripwire : public Ogre::SimpleRenderable {
public:
    Tripwire() : SimpleRenderable("tripwire") {
        setBoundingBox(Ogre::AxisAlignedBox(Vector3(-1), Vector3(1)));
    }
    void _updateRenderQueue(Ogre::RenderQueue*) override {
        if (trips) OGRE_EXCEPT(Ogre::Exception::ERR_INTERNAL_ERROR, "tripped", "Tripwire");
    }
    Ogre::Real getBoundingRadius() const override { return 2; }
    Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }

    bool trips = false;
};

TEST_F(LayersTest, LeaveNothingBehindWhereSomethingThrows) {
    Tripwire tripwire;
    Ogre::SceneNode* const node =
        scene.batches.scene().place().createChildSceneNode(Vector3(0, 2, 0));
    node->attachObject(&tripwire);
    settle();
    const Ogre::Viewport& viewport =
        *scene.manager().getShadowTexture(0)->getBuffer()->getRenderTarget()->getViewport(0);
    for (const bool fills : {false, true}) {
        if (fills) redrawShadowMaps();
        tripwire.trips = true;
        for (int frame = 0; frame < 3; ++frame) {
            EXPECT_THROW(scene.drawMoved(), Ogre::Exception);
            EXPECT_TRUE(viewport.getClearEveryFrame());
            // Objects of other scenes would ask this one, even when it is destroyed.
            EXPECT_EQ(Ogre::Root::getSingleton()._getCurrentSceneManager(), nullptr);
        }
        tripwire.trips = false;
        const LayerProof proof;
        for (int frame = 0; frame < 10; ++frame)
            scene.drawMoved();
        EXPECT_EQ(proofCount().different, 0U) << proof.found;
        EXPECT_GT(proofCount().layered, 3U);
    }
    node->detachAllObjects();
}

// What makes a map be drawn at once.

/// Something done to a scene whose map is drawn in layers.
struct LayerDeed {
    const char* name;
    std::function<void(MovingScene&)> perform;
};

void PrintTo(const LayerDeed& deed, std::ostream* out) {
    *out << deed.name;
}

Ogre::Viewport& mapViewport(MovingScene& scene) {
    return *scene.manager().getShadowTexture(0)->getBuffer()->getRenderTarget()->getViewport(0);
}

const std::vector<LayerDeed>& hindrances() {
    static LayersTestListener listener;
    static const std::vector<LayerDeed> all{
        {"Option",
         [](MovingScene& s) {
             const SetupPtr setup = stableSetup();
             setup->setMovingApart(false);
             s.setSetup(setup);
         }},
        {"DepthTexture",
         [](MovingScene& s) { s.manager().setShadowTextureSettings(256, 1, Ogre::PF_DEPTH16); }},
        {"Listener", [](MovingScene& s) { s.manager().addRenderQueueListener(&listener); }},
        {"QueuesInAWayOfItsOwn",
         [](MovingScene& s) {
             static Ogre::SceneManager::SceneMgrQueuedRenderableVisitor visitor;
             s.manager().setQueuedRenderableVisitor(&visitor);
         }},
        {"NotCleared", [](MovingScene& s) { mapViewport(s).setClearEveryFrame(false); }},
        {"PartOfTheTexture",
         [](MovingScene& s) { mapViewport(s).setDimensions(0, 0, 0.5f, 0.5f); }},
        {"BlendedCaster",
         [](MovingScene& s) {
             // What is added depends on what was there.
             Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
             Ogre::MaterialPtr caster = materials.getByName("adding caster", "Lixel");
             if (!caster)
                 caster = materials.getByName("Lixel/Caster", "Lixel")->clone("adding caster");
             caster->getTechnique(0)->getPass(0)->setSceneBlending(Ogre::SBT_ADD);
             s.manager().setCasterBatches(false); // which are drawn in another order
             s.movers.front()
                 ->getSubEntity(0)
                 ->getMaterial()
                 ->getTechnique(0)
                 ->setShadowCasterMaterial(caster);
         }},
    };
    return all;
}

class WithoutLayers : public testing::TestWithParam<LayerDeed> {};

INSTANTIATE_TEST_SUITE_P(For, WithoutLayers, testing::ValuesIn(hindrances()),
                         [](const auto& test) { return test.param.name; });

TEST_P(WithoutLayers, MapsAreDrawnAtOnce) {
    MovingScene scene(stableSetup());
    for (int frame = 0; frame < 20; ++frame)
        scene.drawMoved();
    GetParam().perform(scene);
    const LayerProof proof;
    for (int frame = 0; frame < 30; ++frame)
        scene.drawMoved();
    EXPECT_EQ(proofCount().layered, 0U);
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
    mapViewport(scene).setClearEveryFrame(true);
    mapViewport(scene).setDimensions(0, 0, 1, 1);
}

// What makes a layer be drawn anew.

Ogre::Entity& stillCaster(MovingScene& scene) {
    return *scene.changed.casters.at(4);
}
Ogre::Pass& stillPass(MovingScene& scene) {
    return *stillCaster(scene).getSubEntity(0)->getMaterial()->getTechnique(0)->getPass(0);
}

const std::vector<LayerDeed>& stillChanges() {
    static const std::vector<LayerDeed> all{
        {"Moves", [](MovingScene& s) { stillCaster(s).getParentSceneNode()->translate(1, 0, 0); }},
        {"Turns",
         [](MovingScene& s) { stillCaster(s).getParentSceneNode()->yaw(Ogre::Degree(30)); }},
        {"Grows", [](MovingScene& s) { stillCaster(s).getParentSceneNode()->scale(2, 2, 2); }},
        {"IsMirrored",
         [](MovingScene& s) { stillCaster(s).getParentSceneNode()->scale(-1, 1, 1); }},
        {"IsHidden", [](MovingScene& s) { stillCaster(s).setVisible(false); }},
        {"CastsNoMore", [](MovingScene& s) { stillCaster(s).setCastShadows(false); }},
        {"IsMasked", [](MovingScene& s) { stillCaster(s).setVisibilityFlags(0); }},
        {"PartIsHidden", [](MovingScene& s) { stillCaster(s).getSubEntity(0)->setVisible(false); }},
        {"FewerIndices",
         [](MovingScene& s) {
             setIndexRange(*stillCaster(s).getSubEntity(0), 6, 12);
             // OGRE has all that share the mesh drawn so, from when it drew this one first.
             s.draw();
         }},
        {"OtherCulling", [](MovingScene& s) { stillPass(s).setCullingMode(Ogre::CULL_NONE); }},
        {"Holes",
         [](MovingScene& s) {
             stillPass(s).setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
         }},
        {"OtherMaterial",
         [](MovingScene& s) {
             const Ogre::MaterialPtr other = s.batches.scene().surface(Ogre::ColourValue::Red);
             other->getTechnique(0)->getPass(0)->setCullingMode(Ogre::CULL_NONE);
             stillCaster(s).setMaterial(other);
         }},
        {"Leaves", [](MovingScene& s) { stillCaster(s).detachFromParent(); }},
        {"Goes",
         [](MovingScene& s) {
             Ogre::Entity* const gone = &stillCaster(s);
             std::erase(s.changed.casters, gone);
             gone->detachFromParent();
             s.manager().destroyEntity(gone);
         }},
        {"AnotherParent",
         [](MovingScene& s) {
             Ogre::SceneNode* const node = stillCaster(s).getParentSceneNode();
             node->getParentSceneNode()->removeChild(node);
             s.manager().getEntity("thing20")->getParentSceneNode()->addChild(node);
         }},
        {"OutOfTheGraph",
         [](MovingScene& s) {
             Ogre::SceneNode* const node = stillCaster(s).getParentSceneNode();
             node->getParentSceneNode()->removeChild(node);
         }},
        {"NotProcessed",
         [](MovingScene& s) {
             s.manager().addSpecialCaseRenderQueue(60);
             stillCaster(s).setRenderQueueGroup(60);
             s.manager().setSpecialCaseRenderQueueMode(Ogre::SceneManager::SCRQM_EXCLUDE);
         }},
        {"PartIsNotProcessed",
         [](MovingScene& s) {
             s.manager().addSpecialCaseRenderQueue(60);
             s.manager().setSpecialCaseRenderQueueMode(Ogre::SceneManager::SCRQM_EXCLUDE);
             for (int frame = 0; frame < 20; ++frame)
                 s.drawMoved();
             stillCaster(s).getSubEntity(0)->setRenderQueueGroup(60);
         }},
        {"BackFaces", [](MovingScene& s) { s.manager().setShadowCasterRenderBackFaces(false); }},
        {"MaskOfTheView",
         [](MovingScene& s) {
             stillCaster(s).setVisibilityFlags(2);
             for (int frame = 0; frame < 20; ++frame)
                 s.drawMoved();
             s.batches.scene().target->getViewport(0)->setVisibilityMask(~2U);
         }},
        {"MaskOfTheScene",
         [](MovingScene& s) {
             stillCaster(s).setVisibilityFlags(2);
             for (int frame = 0; frame < 20; ++frame)
                 s.drawMoved();
             s.manager().setVisibilityMask(~2U);
         }},
        {"SunTurns",
         [](MovingScene& s) {
             s.batches.scene().sun->getParentSceneNode()->yaw(Ogre::Degree(15),
                                                              Ogre::Node::TS_WORLD);
         }},
        {"ViewerMoves", [](MovingScene& s) { s.batches.scene().viewer->translate(5, 0, 0); }},
        {"SmallerMap",
         [](MovingScene& s) { s.manager().setShadowTextureSettings(128, 1, Ogre::PF_FLOAT32_R); }},
        {"OtherFormat",
         [](MovingScene& s) {
             s.manager().setShadowTextureSettings(256, 1, Ogre::PF_FLOAT32_RGBA);
         }},
        {"CameraRelative", [](MovingScene& s) { s.manager().setCameraRelativeRendering(true); }},
        {"CasterMaterialIsReloaded",
         [](MovingScene&) {
             Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster", "Lixel")->reload();
         }},
    };
    return all;
}

class StillCaster : public testing::TestWithParam<LayerDeed> {};

INSTANTIATE_TEST_SUITE_P(That, StillCaster, testing::ValuesIn(stillChanges()),
                         [](const auto& test) { return test.param.name; });

TEST_P(StillCaster, IsNotShownAsItWas) {
    const SetupPtr setup = stableSetup();
    MovingScene scene(setup);
    const LayerDecisions decisions(scene.manager());
    for (int frame = 0; frame < 20; ++frame)
        scene.drawMoved();
    GetParam().perform(scene);
    const LayerProof proof;
    for (int frame = 0; frame < 20; ++frame)
        scene.drawMoved();
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
    EXPECT_GT(proofCount().layered, 5U);
    // What moves may change what the map is focused on, and so what culls its casters.
    if (decisions.last.reason != PlanReason::MapChanged) {
        EXPECT_EQ(decisions.last.plan, MapPlan::DrawMoving) << toString(decisions.last.reason);
    }
    scene.batches.scene().target->getViewport(0)->setVisibilityMask(~0U);
}

TEST_F(LayersTest, ShowBuffersThatWereWrittenToWhenToldOf) {
    settle();
    // Nobody sees it: the mesh's own buffer. (A clone's, so that the prefabs stay.)
    Ogre::Entity& caster = stillCaster(scene);
    const Ogre::MeshPtr mesh = caster.getMesh()->clone("written to");
    Ogre::Entity* const entity = scene.manager().createEntity(mesh);
    entity->setMaterial(caster.getSubEntity(0)->getMaterial());
    caster.getParentSceneNode()->attachObject(entity);
    for (int frame = 0; frame < 60; ++frame)
        scene.drawMoved();
    ASSERT_EQ(decisions.last.plan, MapPlan::DrawMoving);
    const Ogre::SubMesh& part = *mesh->getSubMesh(0);
    const auto& buffer = (part.useSharedVertices ? mesh->sharedVertexData : part.vertexData)
                             ->vertexBufferBinding->getBuffer(0);
    std::vector<float> values(buffer->getSizeInBytes() / sizeof(float));
    buffer->readData(0, buffer->getSizeInBytes(), values.data());
    const std::size_t stride = buffer->getVertexSize() / sizeof(float);
    for (std::size_t i = 0; i < values.size(); i += stride)
        values[i] *= 1.5f;
    buffer->writeData(0, buffer->getSizeInBytes(), values.data());
    const Texels stale = scene.draw();
    redrawShadowMaps();
    const Texels fresh = scene.draw();
    EXPECT_GT(differingTexels(stale, fresh), 5U);
    const LayerProof proof;
    for (int frame = 0; frame < 20; ++frame)
        scene.drawMoved();
    EXPECT_EQ(proofCount().different, 0U) << proof.found;
    EXPECT_GT(proofCount().layered, 3U);
}

// Random changes.

struct LayersConfiguration {
    const char* name;
    Ogre::Light::LightTypes light;
    Ogre::uint16 maps;
    SetupPtr (*makeSetup)();
    bool relative;
};

void PrintTo(const LayersConfiguration& configuration, std::ostream* out) {
    *out << configuration.name;
}

template <typename Setup>
SetupPtr boxesOnly() {
    // With hulls, the ground is no caster, and the map follows each caster.
    const auto setup = Setup::create();
    setup->setMeshHulls(false);
    return setup;
}

template <typename Setup>
SetupPtr lasting() {
    const auto setup = Setup::create();
    setup->setLastingMaps(0.5f);
    return setup;
}

SetupPtr stableCascades() {
    return CascadesShadowCameraSetup::create(UniformShadowCameraSetup::create({.stable = true}),
                                             {.uniformity = 0.5, .followReceivers = false});
}

const std::vector<LayersConfiguration>& configurations() {
    using Light = Ogre::Light;
    static const std::vector<LayersConfiguration> all{
        {"SunStable", Light::LT_DIRECTIONAL, 1, stableSetup, false},
        {"SunXPSM", Light::LT_DIRECTIONAL, 1, boxesOnly<XPSMShadowCameraSetup>, false},
        {"SunXPSMLasting", Light::LT_DIRECTIONAL, 1, lasting<XPSMShadowCameraSetup>, false},
        {"SunOptimal", Light::LT_DIRECTIONAL, 1, boxesOnly<OptimalShadowCameraSetup>, true},
        {"SunUniformLasting", Light::LT_DIRECTIONAL, 1, lasting<UniformShadowCameraSetup>, true},
        {"SunCascades", Light::LT_DIRECTIONAL, 3, stableCascades, false},
        {"SunCascadesRelative", Light::LT_DIRECTIONAL, 3, stableCascades, true},
        {"SpotOptimal", Light::LT_SPOTLIGHT, 1, boxesOnly<OptimalShadowCameraSetup>, false},
        {"SpotUniform", Light::LT_SPOTLIGHT, 1, boxesOnly<UniformShadowCameraSetup>, true},
        {"PointXPSM", Light::LT_POINT, 6, boxesOnly<XPSMShadowCameraSetup>, false},
    };
    return all;
}

void light(MovingScene& scene, const LayersConfiguration& configuration) {
    Ogre::Light& light = *scene.batches.scene().sun;
    light.setType(configuration.light);
    scene.manager().setCameraRelativeRendering(configuration.relative);
    if (configuration.light != Ogre::Light::LT_DIRECTIONAL) {
        light.setAttenuation(80, 1, 0, 0);
        light.getParentSceneNode()->setPosition(6, 12, -3);
        if (configuration.light == Ogre::Light::LT_SPOTLIGHT)
            light.setSpotlightRange(Ogre::Degree(60), Ogre::Degree(90));
        else
            light.getParentSceneNode()->setPosition(1, 4, 1);
    }
    scene.manager().setShadowTextureCountPerLightType(configuration.light, configuration.maps);
    scene.manager().setShadowTextureSettings(128, configuration.maps, Ogre::PF_FLOAT32_R);
}

struct LayersWalk {
    std::vector<Texels> maps;
    std::vector<std::string> deeds;
    std::map<MapPlan, std::size_t> counts;
};

/// @param apart whether maps may be drawn in layers
LayersWalk walkLayers(const LayersConfiguration& configuration, std::uint64_t seed, bool apart) {
    constexpr int Frames = 220;
    const SetupPtr setup = configuration.makeSetup();
    setup->setMovingApart(apart);
    MovingScene scene(setup);
    light(scene, configuration);
    scene.addRestless();
    Random random(seed);
    // A restless caster is always there, or only sometimes.
    const auto changeRestless = [&] {
        const bool visible = random.oneIn(2);
        scene.jointed->setVisible(visible);
        scene.manager().getManualObject("flag")->setVisible(visible);
    };
    LayerDecisions decisions(scene.manager());
    LayersWalk all;
    for (int frame = 0; frame < Frames; ++frame) {
        std::string done;
        // Now and then one thing, and otherwise time for layers to be made and used.
        if (frame > 12 && random.oneIn(7)) {
            const CasterDeed& deed = casterDeeds()[random.below(casterDeeds().size())];
            Ogre::Entity& caster =
                *scene.changed.casters[random.below(scene.changed.casters.size())];
            // What changes all maps is tried elsewhere, and leaves no layers here.
            if (std::string_view(deed.name) != "technique" &&
                (std::string_view(deed.name) != "turn the sun" || random.oneIn(3))) {
                done = std::string(deed.name) + " of " + caster.getName() + "; ";
                deed.perform(scene.changed, caster, random);
            }
        }
        if (random.oneIn(20)) changeRestless();
        if (random.oneIn(20) && !scene.movers.empty()) {
            scene.movers.erase(scene.movers.begin());
            done += "stop; ";
        }
        if (random.oneIn(20)) {
            scene.movers.push_back(
                scene.changed.casters[random.below(scene.changed.casters.size())]);
            done += "start; ";
        }
        all.maps.push_back(scene.drawMoved());
        all.deeds.push_back(done);
    }
    all.counts = decisions.counts;
    return all;
}

class LayersUnderChanges
    : public testing::TestWithParam<std::tuple<LayersConfiguration, std::uint64_t>> {};

INSTANTIATE_TEST_SUITE_P(With, LayersUnderChanges,
                         testing::Combine(testing::ValuesIn(configurations()),
                                          testing::Range<std::uint64_t>(1, 2)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name +
                                    std::to_string(std::get<1>(test.param));
                         });

TEST_P(LayersUnderChanges, LeaveEachTexelAsWithout) {
    const auto& [configuration, seed] = GetParam();
    const LayersWalk whole = walkLayers(configuration, seed, false);
    LayersWalk layered = walkLayers(configuration, seed, true);
    ASSERT_EQ(whole.maps.size(), layered.maps.size());
    std::size_t changed = 0;
    std::string done;
    for (std::size_t i = 0; i < whole.maps.size(); ++i) {
        if (!layered.deeds[i].empty()) done += "\n" + std::to_string(i) + ": " + layered.deeds[i];
        ASSERT_EQ(differingTexels(whole.maps[i], layered.maps[i]), 0U) << "frame " << i << done;
        changed += i > 0 && whole.maps[i] != whole.maps[i - 1] ? 1U : 0U;
    }
    EXPECT_GT(changed, 50U);
    // Not in frames in which what moves changes what the map is focused on.
    EXPECT_GT(layered.counts[MapPlan::DrawMoving], 5U);
}

} // namespace
} // namespace Lixel::Tests
