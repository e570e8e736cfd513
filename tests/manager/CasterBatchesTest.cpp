// Casters in batches: which ones are, and that each texel is that of single draws.
#include "Allocations.h"
#include "BatchScene.h"
#include "ManagerOgre.h"

#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapPlan.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgreRenderObjectListener.h>
#include <OgreRenderQueueListener.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreRoot.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <functional>

/// Of no namespace: an application's.
class BatchTestListener : public Ogre::RenderQueueListener,
                          public Ogre::RenderObjectListener,
                          public Ogre::RenderQueue::RenderableListener {
public:
    void notifyRenderSingleObject(Ogre::Renderable* renderable, const Ogre::Pass*,
                                  const Ogre::AutoParamDataSource*, const Ogre::LightList*,
                                  bool) override {
        if (dynamic_cast<Ogre::SubEntity*>(renderable) != nullptr) ++parts;
    }
    bool renderableQueued(Ogre::Renderable*, Ogre::uint8, Ogre::ushort, Ogre::Technique**,
                          Ogre::RenderQueue*) override {
        return true;
    }
    std::size_t parts = 0;
};

namespace Lixel::Tests {
namespace {

/// Cubes and balls.
constexpr std::size_t KindsOfCasters = 2;

Ogre::Entity& oneCube(BatchScene& scene) {
    return *scene.manager().getEntity("thing1");
}

Ogre::Pass& passOf(BatchScene& scene) {
    return *oneCube(scene).getSubEntity(0)->getMaterial()->getTechnique(0)->getPass(0);
}

/// Entities that are not known yet are drawn in OGRE's way.
void drawFirst(BatchScene& scene) {
    scene.drawMap();
    scene.drawMap();
}

TEST(CasterBatches, AreDrawnByOneCallEach) {
    BatchScene batched(true);
    BatchScene single(false);
    for (int frame = 0; frame < 6; ++frame) {
        const std::vector<std::uint8_t> expected = single.drawMap();
        EXPECT_EQ(differingTexels(expected, batched.drawMap()), 0U) << frame;
    }
    EXPECT_EQ(batched.drawCalls(), KindsOfCasters);
    EXPECT_GT(single.drawCalls(), 12U);
}

TEST(CasterBatches, AreOnUnlessSwitchedOff) {
    BatchScene scene(true);
    EXPECT_TRUE(scene.manager().getCasterBatches());
    drawFirst(scene);
    scene.manager().setCasterBatches(false);
    scene.drawMap();
    EXPECT_GT(scene.drawCalls(), 12U);
    scene.manager().setCasterBatches(true);
    scene.drawMap();
    EXPECT_EQ(scene.drawCalls(), KindsOfCasters);
}

TEST(CasterBatches, FewAreDrawnByThemselves) {
    BatchScene scene(true);
    for (const auto& [name, object] : scene.manager().getMovableObjects("Entity"))
        object->setCastShadows(false);
    for (std::size_t count = 1; count <= 5; ++count) {
        scene.scene().add(Shape::Cube, Ogre::Vector3(2 * static_cast<float>(count) - 6, 1, 4),
                          Ogre::Vector3(1, 2, 1), Ogre::ColourValue::White);
        drawFirst(scene);
        EXPECT_EQ(scene.drawCalls(), count < 4 ? count : 1U);
    }
}

/// Something about one cube.
struct Apart {
    const char* name;
    std::function<void(BatchScene&)> make;
};

void PrintTo(const Apart& apart, std::ostream* out) {
    *out << apart.name;
}

/// Since 13, a material is what has a program for casters alone.
void setOwnProgram(BatchScene& scene) {
#if OGRE_VERSION_MAJOR >= 13
    const Ogre::MaterialPtr caster =
        Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster", "Lixel");
    passOf(scene).getParent()->setShadowCasterMaterial(
        caster->clone(scene.manager().getName() + "/Caster"));
#else
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
    passOf(scene).setShadowCasterVertexProgram("Lixel/CasterVP");
#pragma GCC diagnostic pop
#endif
}

const std::vector<Apart>& apartKinds() {
    static const std::vector<Apart> all{
        {"Mirrored",
         [](BatchScene& s) {
             Ogre::SceneNode& node = *oneCube(s).getParentSceneNode();
             node.setScale(node.getScale() * Ogre::Vector3(-1, 1, 1));
         }},
        {"Holes", [](BatchScene& s) { passOf(s).setAlphaRejectSettings(Ogre::CMPF_GREATER, 128); }},
        {"Blended", [](BatchScene& s) { passOf(s).setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA); }},
        {"OwnCasterMaterial",
         [](BatchScene& s) {
             passOf(s).getParent()->setShadowCasterMaterial(
                 Ogre::MaterialManager::getSingleton().getByName("Lixel/Caster", "Lixel"));
         }},
        {"OwnCasterProgram", setOwnProgram},
        {"OtherCulling", [](BatchScene& s) { passOf(s).setCullingMode(Ogre::CULL_NONE); }},
        {"OtherPriority",
         [](BatchScene& s) {
             oneCube(s).getSubEntity(0)->setRenderQueueGroupAndPriority(Ogre::RENDER_QUEUE_MAIN,
                                                                        90);
         }},
        {"OtherGroup", [](BatchScene& s) { oneCube(s).setRenderQueueGroup(Ogre::RENDER_QUEUE_6); }},
        {"SomeIndices", [](BatchScene& s) { setIndexRange(*oneCube(s).getSubEntity(0), 6, 12); }},
        {"Listener",
         [](BatchScene& s) {
             static Ogre::MovableObject::Listener listener;
             oneCube(s).setListener(&listener);
         }},
        {"RenderingDistance", [](BatchScene& s) { oneCube(s).setRenderingDistance(1000); }},
        {"AnotherMesh",
         [](BatchScene& s) {
             const Ogre::MeshPtr mesh = oneCube(s).getMesh()->clone(s.manager().getName());
             Ogre::SceneNode& node = *oneCube(s).getParentSceneNode();
             Ogre::Entity* const entity = s.manager().createEntity(mesh);
             entity->setMaterial(oneCube(s).getSubEntity(0)->getMaterial());
             node.detachObject(&oneCube(s));
             node.attachObject(entity);
         }},
    };
    return all;
}

class CasterApart : public testing::TestWithParam<Apart> {};

INSTANTIATE_TEST_SUITE_P(Of, CasterApart, testing::ValuesIn(apartKinds()),
                         [](const auto& test) { return test.param.name; });

TEST_P(CasterApart, IsDrawnByItself) {
    BatchScene batched(true);
    BatchScene single(false);
    for (BatchScene* scene : {&single, &batched}) {
        drawFirst(*scene);
        GetParam().make(*scene);
        drawFirst(*scene);
    }
    const std::vector<std::uint8_t> expected = single.drawMap();
    EXPECT_EQ(differingTexels(expected, batched.drawMap()), 0U);
    EXPECT_EQ(batched.drawCalls(), KindsOfCasters + 1);
}

/// Lixel's, by other names.
void makeTestPrograms() {
    auto& programs = Ogre::HighLevelGpuProgramManager::getSingleton();
    if (programs.resourceExists("Test/CasterVP", Ogre::RGN_DEFAULT)) return;
    const auto vertex =
        createProgram("Test/CasterVP", Ogre::RGN_DEFAULT, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    vertex->setSourceFile("LixelCaster.vert");
    vertex->getDefaultParameters()->addSharedParameters("Lixel/Caster");
    vertex->getDefaultParameters()->setNamedAutoConstant(
        "worldViewProj", Ogre::GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX);
    createProgram("Test/CasterFP", Ogre::RGN_DEFAULT, "glsl", Ogre::GPT_FRAGMENT_PROGRAM)
        ->setSourceFile("LixelCaster.frag");
}

void wearCaster(BatchScene& scene, const std::string& vertex, const std::string& fragment) {
    const Ogre::MaterialPtr caster = Ogre::MaterialManager::getSingleton()
                                         .getByName("Lixel/Caster", "Lixel")
                                         ->clone("Other caster of " + scene.manager().getName());
    caster->getTechnique(0)->getPass(0)->setVertexProgram(vertex);
    caster->getTechnique(0)->getPass(0)->setFragmentProgram(fragment);
    scene.manager().setShadowTextureCasterMaterial(caster);
}

/// Something for which all casters are drawn by themselves.
const std::vector<Apart>& singleDraws() {
    static BatchTestListener listener;
    static const std::vector<Apart> all{
        {"QueueListener", [](BatchScene& s) { s.manager().addRenderQueueListener(&listener); }},
        {"ObjectListener", [](BatchScene& s) { s.manager().addRenderObjectListener(&listener); }},
        {"RenderableListener",
         [](BatchScene& s) { s.manager().getRenderQueue()->setRenderableListener(&listener); }},
        {"Visitor",
         [](BatchScene& s) {
             static Ogre::SceneManager::SceneMgrQueuedRenderableVisitor visitor;
             s.manager().setQueuedRenderableVisitor(&visitor);
         }},
        {"LateMaterials", [](BatchScene& s) { s.manager().setLateMaterialResolving(true); }},
        {"Wireframe",
         [](BatchScene& s) {
             s.manager()
                 .getShadowTexture(0)
                 ->getBuffer()
                 ->getRenderTarget()
                 ->getViewport(0)
                 ->getCamera()
                 ->setPolygonMode(Ogre::PM_WIREFRAME);
         }},
        {"OtherVertexProgram",
         [](BatchScene& s) {
             wearCaster(s, s.manager().getCasterBatches() ? "Test/CasterVP" : "Lixel/CasterVP",
                        "Lixel/CasterFP");
         }},
        {"OtherFragmentProgram",
         [](BatchScene& s) { wearCaster(s, "Lixel/CasterVP", "Test/CasterFP"); }},
    };
    return all;
}

class SingleDraws : public testing::TestWithParam<Apart> {};

INSTANTIATE_TEST_SUITE_P(With, SingleDraws, testing::ValuesIn(singleDraws()),
                         [](const auto& test) { return test.param.name; });

TEST_P(SingleDraws, AreAsWithoutBatches) {
    BatchScene batched(true);
    BatchScene single(false);
    makeTestPrograms();
    for (BatchScene* scene : {&single, &batched}) {
        drawFirst(*scene);
        GetParam().make(*scene);
        drawFirst(*scene);
    }
    const std::vector<std::uint8_t> expected = single.drawMap();
    EXPECT_EQ(differingTexels(expected, batched.drawMap()), 0U);
    EXPECT_EQ(batched.drawCalls(), single.drawCalls());
    EXPECT_GT(batched.drawCalls(), 12U);
}

TEST(CasterBatches, AnApplicationHearsOfEachCaster) {
    BatchScene scene(true);
    drawFirst(scene);
    BatchTestListener listener;
    scene.manager().addRenderObjectListener(&listener);
    scene.drawMap();
    scene.manager().removeRenderObjectListener(&listener);
    EXPECT_GT(listener.parts, 24U + 12U); // in the picture and in the map
    scene.drawMap();
    EXPECT_EQ(scene.drawCalls(), KindsOfCasters);
}

/// Collects Lixel's warnings.
class BatchLog : public Ogre::LogListener {
public:
    BatchLog() { Ogre::LogManager::getSingleton().getDefaultLog()->addListener(this); }
    ~BatchLog() override { Ogre::LogManager::getSingleton().getDefaultLog()->removeListener(this); }
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                       const Ogre::String&, bool&) override {
        if (message.find("Lixel:") != Ogre::String::npos) lines.push_back(message);
    }
    std::vector<std::string> lines;
};

TEST(CasterBatches, AreNotDrawnWhereTheRenderSystemCannot) {
    const auto capabilities = const_cast<Ogre::RenderSystemCapabilities*>(
        ogreWithManagers().root().getRenderSystem()->getCapabilities());
    capabilities->unsetCapability(Ogre::RSC_VERTEX_BUFFER_INSTANCE_DATA);
    BatchLog log;
    {
        BatchScene scene(true);
        drawFirst(scene);
        scene.drawMap();
        EXPECT_GT(scene.drawCalls(), 12U);
    }
    capabilities->setCapability(Ogre::RSC_VERTEX_BUFFER_INSTANCE_DATA);
    ASSERT_EQ(log.lines.size(), 1U);
    EXPECT_NE(log.lines.front().find("no instanced arrays"), std::string::npos)
        << log.lines.front();
}

TEST(CasterBatches, AreNothingToWarnOf) {
    ogreWithManagers();
    const BatchLog log;
    BatchScene scene(true);
    for (int frame = 0; frame < 10; ++frame)
        scene.drawMap();
    EXPECT_EQ(scene.drawCalls(), KindsOfCasters);
    for (const std::string& line : log.lines)
        ADD_FAILURE() << line;
}

TEST(CasterBatches, FollowTheCasterMaterial) {
    BatchScene batched(true);
    BatchScene single(false);
    Ogre::Pass& caster = *Ogre::MaterialManager::getSingleton()
                              .getByName("Lixel/Caster", "Lixel")
                              ->getTechnique(0)
                              ->getPass(0);
    drawFirst(single);
    drawFirst(batched);
    const std::vector<std::uint8_t> before = batched.drawMap();
    single.drawMap();
    const auto expectSame = [&](const std::string& what) {
        const std::vector<std::uint8_t> expected = single.drawMap();
        const std::vector<std::uint8_t> actual = batched.drawMap();
        EXPECT_EQ(differingTexels(expected, actual), 0U) << what;
        EXPECT_EQ(batched.drawCalls(), KindsOfCasters) << what;
        return actual;
    };
    caster.setColourWriteEnabled(false);
    const std::vector<std::uint8_t> unwritten = expectSame("no colour");
    EXPECT_EQ(differingTexels(unwritten, std::vector<std::uint8_t>(unwritten)), 0U);
    EXPECT_GT(differingTexels(before, unwritten), 100U);
    caster.setColourWriteEnabled(true);
    expectSame("colour");
    for (BatchScene* scene : {&single, &batched})
        scene->manager().setShadowCasterRenderBackFaces(true);
    expectSame("back faces");
}

/// Counts what is allocated while casters are found and queued.
class FindWatch : public SceneManagerListener {
public:
    explicit FindWatch(Ogre::SceneManager& manager) : mManager(manager) {
        addSceneManagerListener(mManager, *this);
    }
    ~FindWatch() override { removeSceneManagerListener(mManager, *this); }
    void preFindVisibleObjects(Ogre::SceneManager*, Ogre::SceneManager::IlluminationRenderStage,
                               Ogre::Viewport*) override {
        mBegin = allocations();
    }
    void postFindVisibleObjects(Ogre::SceneManager*,
                                Ogre::SceneManager::IlluminationRenderStage stage,
                                Ogre::Viewport*) override {
        if (stage == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) made = allocations() - mBegin;
    }
    std::size_t made = 0;

private:
    Ogre::SceneManager& mManager;
    std::size_t mBegin = 0;
};

TEST(CasterBatches, AllocateNothingInTheSteadyState) {
    if (!countsAllocations()) GTEST_SKIP() << "the sanitizer allocates";
    BatchScene scene(true);
    scene.scene().moving.clear();
    FindWatch watch(scene.manager());
    const auto allocate = [&](bool batches) {
        scene.manager().setCasterBatches(batches);
        scene.drawMap();
        const std::size_t first = watch.made;
        drawFirst(scene);
        scene.drawMap();
        EXPECT_LT(watch.made, first) << "nothing is counted";
        return watch.made;
    };
    const std::size_t single = allocate(false);
    EXPECT_LE(allocate(true), single);
    EXPECT_EQ(scene.drawCalls(), KindsOfCasters);
}

TEST(CasterBatches, AreProved) {
    BatchScene scene(true);
    drawFirst(scene);
    setProofMode(true, finishDrawing);
    for (int i = 0; i < 3; ++i)
        scene.drawMap();
    EXPECT_EQ(proofCount().batched, 3U);
    EXPECT_EQ(proofCount().different, 0U);
    setProofMode(false);
}

} // namespace
} // namespace Lixel::Tests
