// How meshes are read: a part at a time, so that no frame takes long, and whatever becomes of them
// in the midst of it.
#include "SceneTest.h"

#include "scene/MeshShapes.h"
#include "setup/MeshPreparation.h"

#include <OgreEntity.h>
#include <OgreException.h>
#include <OgreHardwareBufferManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSceneNode.h>
#include <OgreSubMesh.h>

#include <limits>

namespace Lixel::Tests {
namespace {

using Ogre::RenderOperation;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t VertexSize = 8 * sizeof(float);

/// What a hilly strip of land is made of.
struct Land {
    unsigned side = 400; ///< vertices along each side
    float height = 0.3f;
    bool shadowBuffers = true;
    RenderOperation::OperationType type = RenderOperation::OT_TRIANGLE_LIST;
    bool indexed = true;
    std::size_t vertices() const { return std::size_t{side} * side; }
};

Ogre::HardwareVertexBufferSharedPtr makeVertices(const Land& land) {
    std::vector<float> floats;
    const auto last = static_cast<float>(land.side - 1);
    for (unsigned z = 0; z < land.side; ++z)
        for (unsigned x = 0; x < land.side; ++x) {
            const float u = static_cast<float>(x) / last;
            const float v = static_cast<float>(z) / last;
            const float height = land.height * std::sin(7 * u + 5 * v);
            floats.insert(floats.end(), {u - 0.5f, height, 0.2f * v - 0.3f * u, 0, 1, 0, u, v});
        }
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        VertexSize, land.vertices(), Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY,
        land.shadowBuffers);
    buffer->writeData(0, floats.size() * sizeof(float), floats.data());
    return buffer;
}

void addLand(Ogre::Mesh& mesh, const Land& land) {
    Ogre::SubMesh* const part = mesh.createSubMesh();
    part->useSharedVertices = false;
    part->operationType = land.type;
    part->vertexData = OGRE_NEW Ogre::VertexData();
    part->vertexData->vertexCount = static_cast<Ogre::uint32>(land.vertices());
    Ogre::VertexDeclaration& declaration = *part->vertexData->vertexDeclaration;
    declaration.addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    declaration.addElement(0, 12, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    declaration.addElement(0, 24, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    part->vertexData->vertexBufferBinding->setBinding(0, makeVertices(land));
    if (!land.indexed) return;
    std::vector<std::uint32_t> indices;
    for (unsigned z = 0; z + 1 < land.side; ++z)
        for (unsigned x = 0; x + 1 < land.side; ++x) {
            const unsigned i = z * land.side + x;
            indices.insert(indices.end(), {i, i + land.side, i + 1});
            indices.insert(indices.end(), {i + 1, i + land.side, i + land.side + 1});
        }
    indices[7] = static_cast<std::uint32_t>(land.vertices()); // beyond the vertices
    part->indexData->indexCount = static_cast<Ogre::uint32>(indices.size());
    part->indexData->indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(),
        Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY, land.shadowBuffers);
    part->indexData->indexBuffer->writeData(0, indices.size() * sizeof(std::uint32_t),
                                            indices.data());
}

void setBounds(Ogre::Mesh& mesh, float height) {
    mesh._setBounds(Ogre::AxisAlignedBox(-0.5f, -height, -0.3f, 0.5f, height, 0.2f), false);
    mesh._setBoundingSphereRadius(1);
}

/// Makes the mesh whenever it is loaded.
class Loader : public Ogre::ManualResourceLoader {
public:
    explicit Loader(const Land& land) : mLand(land) {}
    void loadResource(Ogre::Resource* resource) override {
        auto& mesh = static_cast<Ogre::Mesh&>(*resource);
        addLand(mesh, mLand);
        setBounds(mesh, mLand.height);
    }

    Land mLand;
};

class MeshReadingTest : public SceneTest {
protected:
    ~MeshReadingTest() override {
        for (const Ogre::MeshPtr& mesh : mAll)
            Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }

    Ogre::MeshPtr makeLand(const Land& land = {}, const std::string& name = "land") {
        mAll.push_back(Ogre::MeshManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT));
        addLand(*mAll.back(), land);
        setBounds(*mAll.back(), land.height);
        mAll.back()->load();
        return mAll.back();
    }

    Ogre::Entity* show(const Ogre::MeshPtr& mesh) {
        Ogre::Entity* const entity = mManager->createEntity(mesh);
        entity->setMaterialName("BaseWhite"); // which has no programs
        Ogre::SceneNode* const node = mRootNode->createChildSceneNode(Ogre::Vector3(0, 0, -20));
        node->attachObject(entity);
        return entity;
    }

    void beginFrame(MeshShapes& meshes) { meshes.beginPicture(++mFrame); }
    void beginFrame() { beginFrame(mMeshes); }

    /// Asks in one frame after another. @return in how many the shape was not there
    template <typename Shape>
    int framesUntil(const Shape*& found, const std::function<const Shape*()>& shape) {
        for (int frames = 0; frames < 10000; ++frames) {
            beginFrame();
            found = shape();
            if (found != nullptr) return frames;
        }
        return 10000;
    }
    int framesUntilHull(const Ogre::Entity& entity, const BodyHull*& hull) {
        return framesUntil<BodyHull>(hull, [&] { return mMeshes.hullOf(entity); });
    }
    int framesUntilCloud(const Ogre::Entity& entity, const SurfaceCloud*& cloud) {
        return framesUntil<SurfaceCloud>(cloud, [&] { return mMeshes.cloudOf(entity); });
    }

    /// A few frames of it, which are not enough.
    void readHalf(const Ogre::Entity& entity) {
        for (int i = 0; i < 4; ++i) {
            beginFrame();
            EXPECT_EQ(mMeshes.hullOf(entity), nullptr);
            beginFrame();
            EXPECT_EQ(mMeshes.cloudOf(entity), nullptr);
        }
        EXPECT_GT(mMeshes.bytesRead(), 0U);
    }

    MeshShapes mMeshes;
    unsigned long mFrame = 0;
    std::vector<Ogre::MeshPtr> mAll;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, MeshReadingTest, testing::Values(DefaultManager),
                         [](const auto& test) { return test.param; });

void expectSame(const BodyHull& a, const BodyHull& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.volume, b.volume);
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t i = 0; i < a.edges.size(); ++i) {
        EXPECT_EQ(a.edges[i].vertices, b.edges[i].vertices);
        EXPECT_EQ(a.edges[i].faces, b.edges[i].faces);
    }
}

void expectSame(const SurfaceCloud& a, const SurfaceCloud& b) {
    ASSERT_EQ(a.surfels.size(), b.surfels.size());
    for (std::size_t i = 0; i < a.surfels.size(); ++i) {
        EXPECT_EQ(a.surfels[i].centre, b.surfels[i].centre);
        EXPECT_EQ(a.surfels[i].normal, b.surfels[i].normal);
        EXPECT_EQ(a.surfels[i].radius, b.surfels[i].radius);
    }
}

/// How high a hull reaches.
double heightOf(const BodyHull& hull) {
    double height = 0.0;
    for (const Vec3& vertex : hull.vertices)
        height = std::max(height, vertex.y());
    return height;
}

} // namespace

/// As surveys see it, one in each frame.
TEST_P(MeshReadingTest, TheBoxHasToDoUntilItIsRead) {
    show(makeLand());
    Transform3 wsFromBody;
    takeSurvey();
    ASSERT_EQ(mSurvey.receivers().size(), 1U);
    EXPECT_EQ(mSurvey.receiverShapes().hullOf(0, wsFromBody), nullptr);
    EXPECT_EQ(mSurvey.receiverShapes().hullOf(0, wsFromBody), nullptr);
    int frames = 0;
    do {
        takeSurvey();
    } while (mSurvey.receiverShapes().hullOf(0, wsFromBody) == nullptr && ++frames < 1000);
    EXPECT_LT(frames, 1000);
}

TEST_P(MeshReadingTest, ReadsABoundedPartEachFrame) {
    for (const bool shadowBuffers : {false, true}) {
        const Land land{.shadowBuffers = shadowBuffers};
        const Ogre::Entity* const entity =
            show(makeLand(land, shadowBuffers ? "with copies" : "without"));
        std::size_t most = 0;
        std::size_t before = mMeshes.bytesRead();
        const std::size_t first = before;
        const BodyHull* hull = nullptr;
        const auto readInFrame = [&] {
            const BodyHull* const found = mMeshes.hullOf(*entity);
            mMeshes.hullOf(*entity); // more often changes nothing
            most = std::max(most, mMeshes.bytesRead() - before);
            before = mMeshes.bytesRead();
            return found;
        };
        EXPECT_GT(framesUntil<BodyHull>(hull, readInFrame), 8);
        EXPECT_EQ(mMeshes.bytesRead() - first, land.vertices() * VertexSize); // once
        EXPECT_LT(most, land.vertices() * VertexSize / 8);
    }
}

TEST_P(MeshReadingTest, TakesFewerFramesWithMoreTime) {
    const Ogre::Entity* const entity = show(makeLand());
    const BodyHull* hull = nullptr;
    const int usual = framesUntilHull(*entity, hull);
    mMeshes = {};
    mMeshes.setFrameTime(MeshShapes::DefaultFrameTime / 4.0);
    const int little = framesUntilHull(*entity, hull);
    EXPECT_GT(little, 3 * usual);
    mMeshes = {};
    mMeshes.setFrameTime(Infinity);
    EXPECT_EQ(framesUntilHull(*entity, hull), 0);
    mMeshes = {};
    mMeshes.setFrameTime(0.0);
    EXPECT_EQ(framesUntilHull(*entity, hull), 10000);
    EXPECT_EQ(mMeshes.bytesRead(), 0U);
}

/// Applications that update their windows by themselves count no frames.
TEST_P(MeshReadingTest, GoesOnWithoutFramesToo) {
    const Ogre::Entity* const entity = show(makeLand());
    beginFrame();
    mMeshes.hullOf(*entity);
    const std::size_t inFrame = mMeshes.bytesRead();
    mMeshes.beginPicture(mFrame); // of another viewport in the same frame
    mMeshes.hullOf(*entity);
    EXPECT_EQ(mMeshes.bytesRead(), inFrame);
    int pictures = 0;
    for (; mMeshes.hullOf(*entity) == nullptr && pictures < 10000; ++pictures)
        mMeshes.beginPicture(mFrame);
    EXPECT_LT(pictures, 10000);
}

TEST_P(MeshReadingTest, InPartsGivesWhatReadingAtOnceGives) {
    int count = 0;
    for (const Land& land : {Land{}, Land{.shadowBuffers = false},
                             Land{.type = RenderOperation::OT_TRIANGLE_STRIP, .indexed = false},
                             Land{.type = RenderOperation::OT_TRIANGLE_STRIP},
                             Land{.type = RenderOperation::OT_TRIANGLE_FAN, .indexed = false},
                             Land{.indexed = false}}) {
        SCOPED_TRACE(count);
        const Ogre::MeshPtr mesh = makeLand(land, "land" + std::to_string(count++));
        addLand(*mesh, {.side = 20, .height = 0.1f}); // another part
        const Ogre::Entity* const entity = show(mesh);
        MeshShapes atOnce;
        atOnce.setFrameTime(Infinity);
        beginFrame(atOnce);
        const BodyHull* const wholeHull = atOnce.hullOf(*entity);
        const SurfaceCloud* const wholeCloud = atOnce.cloudOf(*entity);
        ASSERT_NE(wholeHull, nullptr);
        ASSERT_NE(wholeCloud, nullptr);
        const BodyHull* hull = nullptr;
        const SurfaceCloud* cloud = nullptr;
        EXPECT_GT(framesUntilHull(*entity, hull), 4);
        EXPECT_GT(framesUntilCloud(*entity, cloud), 4);
        ASSERT_NE(hull, nullptr);
        ASSERT_NE(cloud, nullptr);
        EXPECT_EQ(cloud->surfels.size(), MeshShapes::Discs);
        expectSame(*hull, *wholeHull);
        expectSame(*cloud, *wholeCloud);
    }
}

TEST_P(MeshReadingTest, SmallMeshesAreThereAtOnceBesideALargeOne) {
    const Ogre::Entity* const large = show(makeLand());
    beginFrame();
    EXPECT_EQ(mMeshes.hullOf(*large), nullptr);
    EXPECT_EQ(mMeshes.cloudOf(*large), nullptr);
    for (int i = 0; i < 3; ++i) {
        const Ogre::Entity* const small = show(makeLand({.side = 8}, "small" + std::to_string(i)));
        EXPECT_NE(mMeshes.hullOf(*small), nullptr);
        EXPECT_NE(mMeshes.cloudOf(*small), nullptr);
    }
}

TEST_P(MeshReadingTest, PreparedItIsThereAtOnce) {
    const Ogre::MeshPtr mesh = makeLand();
    const Ogre::Entity* const entity = show(mesh);
    prepareMesh(mesh);
    MeshShapes& shared = MeshShapes::shared();
    const std::size_t before = shared.bytesRead();
    const BodyHull* const hull = shared.hullOf(*entity);
    const SurfaceCloud* const cloud = shared.cloudOf(*entity);
    ASSERT_NE(hull, nullptr);
    ASSERT_NE(cloud, nullptr);
    EXPECT_EQ(shared.bytesRead(), before);
    // For surveys too.
    Transform3 wsFromBody;
    takeSurvey();
    EXPECT_EQ(mSurvey.receiverShapes().hullOf(0, wsFromBody), hull);
    const BodyHull* found = nullptr;
    framesUntilHull(*entity, found);
    ASSERT_NE(found, nullptr);
    expectSame(*found, *hull);
}

TEST_P(MeshReadingTest, PreparedHalfWayItIsThereAtOnce) {
    const Ogre::MeshPtr mesh = makeLand();
    const Ogre::Entity* const entity = show(mesh);
    readHalf(*entity);
    mMeshes.prepare(mesh);
    EXPECT_NE(mMeshes.hullOf(*entity), nullptr);
    EXPECT_NE(mMeshes.cloudOf(*entity), nullptr);
}

TEST_P(MeshReadingTest, PreparingLoadsTheMesh) {
    Loader loader({.side = 8});
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual("later", Ogre::RGN_DEFAULT, &loader);
    mAll.push_back(mesh);
    prepareMesh(mesh);
    EXPECT_TRUE(mesh->isLoaded());
}

TEST_P(MeshReadingTest, RefusesWhatIsNoMeshAndNoTime) {
    EXPECT_THROW(prepareMesh({}), Ogre::InvalidParametersException);
    EXPECT_THROW(setMeshReadingTime(-1), Ogre::InvalidParametersException);
    EXPECT_THROW(setMeshReadingTime(std::numeric_limits<Ogre::Real>::quiet_NaN()),
                 Ogre::InvalidParametersException);
    const Ogre::Real before = getMeshReadingTime();
    setMeshReadingTime(0);
    EXPECT_EQ(getMeshReadingTime(), 0);
    setMeshReadingTime(before);
}

TEST_P(MeshReadingTest, UnloadedHalfWayItHasNoShape) {
    Loader loader({});
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual("unloaded", Ogre::RGN_DEFAULT, &loader);
    mAll.push_back(mesh);
    const Ogre::Entity* const entity = show(mesh);
    readHalf(*entity);
    mesh->unload();
    beginFrame();
    EXPECT_EQ(mMeshes.hullOf(*entity), nullptr);
    EXPECT_EQ(mMeshes.cloudOf(*entity), nullptr);
    mMeshes.prepare(mesh);
}

TEST_P(MeshReadingTest, ReloadedHalfWayItIsReadAnew) {
    Loader loader({});
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual("reloaded", Ogre::RGN_DEFAULT, &loader);
    mAll.push_back(mesh);
    const Ogre::Entity* const entity = show(mesh);
    readHalf(*entity);
    loader.mLand = {.side = 300, .height = 0.1f};
    mesh->reload();
    const BodyHull* hull = nullptr;
    framesUntilHull(*entity, hull);
    ASSERT_NE(hull, nullptr);
    EXPECT_NEAR(heightOf(*hull), 0.1, 1e-3);
}

TEST_P(MeshReadingTest, DestroyedHalfWayItIsForgotten) {
    for (const float height : {0.1f, 0.2f, 0.3f}) {
        const Ogre::MeshPtr mesh = makeLand({.height = height});
        Ogre::Entity* const entity = show(mesh);
        if (height < 0.25f) {
            readHalf(*entity);
        } else {
            const BodyHull* hull = nullptr;
            framesUntilHull(*entity, hull);
            ASSERT_NE(hull, nullptr);
            EXPECT_NEAR(heightOf(*hull), 0.3, 1e-3);
        }
        // The next one has its name, and likely its address.
        mManager->destroyEntity(entity);
        mAll.clear();
        Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }
}

/// OGRE tells nobody of buffers that are replaced.
TEST_P(MeshReadingTest, WithOtherBuffersHalfWayItIsReadAnew) {
    const Ogre::MeshPtr mesh = makeLand();
    const Ogre::Entity* const entity = show(mesh);
    readHalf(*entity);
    Ogre::VertexData& data = *mesh->getSubMesh(0)->vertexData;
    const Land other{.side = 350, .height = 0.2f};
    data.vertexBufferBinding->setBinding(0, makeVertices(other));
    data.vertexCount = static_cast<Ogre::uint32>(other.vertices());
    const BodyHull* hull = nullptr;
    framesUntilHull(*entity, hull);
    EXPECT_EQ(hull, nullptr); // it fills its bounds no more
    setBounds(*mesh, other.height);
    framesUntilHull(*entity, hull);
    ASSERT_NE(hull, nullptr);
    EXPECT_NEAR(heightOf(*hull), 0.2, 1e-3);
}

TEST_P(MeshReadingTest, WithFewerPartsHalfWayItIsReadAnew) {
    const Ogre::MeshPtr mesh = makeLand();
    addLand(*mesh, {.height = 0.1f});
    const Ogre::Entity* const entity = show(mesh);
    readHalf(*entity);
    mesh->destroySubMesh(0);
    setBounds(*mesh, 0.1f);
    const BodyHull* hull = nullptr;
    framesUntilHull(*entity, hull);
    ASSERT_NE(hull, nullptr);
    EXPECT_NEAR(heightOf(*hull), 0.1, 1e-3);
}

TEST_P(MeshReadingTest, WithOtherBoundsItIsReadAnew) {
    const Ogre::MeshPtr mesh = makeLand({.side = 8});
    const Ogre::Entity* const entity = show(mesh);
    beginFrame();
    EXPECT_NE(mMeshes.hullOf(*entity), nullptr);
    mesh->getSubMesh(0)->vertexData->vertexBufferBinding->setBinding(
        0, makeVertices({.side = 8, .height = 0.6f}));
    setBounds(*mesh, 0.6f);
    const BodyHull* const hull = mMeshes.hullOf(*entity);
    ASSERT_NE(hull, nullptr);
    EXPECT_GT(heightOf(*hull), 0.5);
}

/// Applications that change a mesh each frame must not have it read each frame.
TEST_P(MeshReadingTest, WithEverOtherBoundsItIsNotReadForEver) {
    const Ogre::MeshPtr mesh = makeLand({.side = 8});
    const Ogre::Entity* const entity = show(mesh);
    for (int i = 0; i < 100; ++i) {
        setBounds(*mesh, 0.3f + 1e-5f * static_cast<float>(i));
        beginFrame();
        mMeshes.hullOf(*entity);
        mMeshes.cloudOf(*entity);
    }
    EXPECT_EQ(mMeshes.hullOf(*entity), nullptr);
    EXPECT_NE(mMeshes.cloudOf(*entity), nullptr);
    const std::size_t before = mMeshes.bytesRead();
    EXPECT_LT(before, 20 * 2 * 64 * VertexSize);
    mMeshes.prepare(mesh);
    EXPECT_NE(mMeshes.hullOf(*entity), nullptr);
}

TEST_P(MeshReadingTest, WaitsForABufferThatIsLocked) {
    const Ogre::MeshPtr mesh = makeLand({.side = 8});
    const Ogre::Entity* const entity = show(mesh);
    const Ogre::HardwareVertexBufferSharedPtr buffer =
        mesh->getSubMesh(0)->vertexData->vertexBufferBinding->getBuffer(0);
    buffer->lock(Ogre::HardwareBuffer::HBL_NORMAL);
    beginFrame();
    EXPECT_EQ(mMeshes.hullOf(*entity), nullptr);
    mMeshes.prepare(mesh);
    EXPECT_EQ(mMeshes.bytesRead(), 0U);
    buffer->unlock();
    EXPECT_NE(mMeshes.hullOf(*entity), nullptr);
}

/// More vertices than the buffer holds, and no buffer at all.
TEST_P(MeshReadingTest, OfTooShortBuffersGivesNoShape) {
    const Ogre::MeshPtr mesh = makeLand({.side = 8});
    mesh->getSubMesh(0)->vertexData->vertexCount = 65;
    const Ogre::MeshPtr indices = makeLand({.side = 8}, "indices");
    indices->getSubMesh(0)->indexData->indexStart = 1;
    const Ogre::MeshPtr none = makeLand({.side = 8}, "none");
    const Ogre::Entity* const entity = show(mesh);
    const Ogre::Entity* const ofIndices = show(indices);
    const Ogre::Entity* const ofNone = show(none);
    none->getSubMesh(0)->vertexData->vertexBufferBinding->unsetAllBindings();
    beginFrame();
    EXPECT_EQ(mMeshes.hullOf(*entity), nullptr);
    EXPECT_EQ(mMeshes.cloudOf(*entity), nullptr);
    EXPECT_NE(mMeshes.hullOf(*ofIndices), nullptr);
    EXPECT_EQ(mMeshes.cloudOf(*ofIndices), nullptr);
    EXPECT_EQ(mMeshes.hullOf(*ofNone), nullptr);
    EXPECT_EQ(mMeshes.cloudOf(*ofNone), nullptr);
}

} // namespace Lixel::Tests
