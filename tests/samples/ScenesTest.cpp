// The samples' scenes and models: sound meshes, sensible views, and triangles as OGRE has them.
// Nothing is drawn: meshes live in system memory.

#include "OgreTest.h"
#include "TestStage.h"

#include "common/MeshBuilder.h"
#include "common/ModelFile.h"
#include "common/OracleView.h"
#include "common/Scenes.h"
#include "common/Setups.h"
#include "common/ShadowOracle.h"
#include "common/Triangles.h"
#include "common/ViewsBySeed.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace Lixel::Samples {
namespace {

using Eigen::Vector3d;
using Ogre::Vector3;

Vector3d normalOf(const TriangleScene& scene, const Triangle& triangle) {
    const Vector3d& a = scene.positions[triangle.vertices[0]];
    return (scene.positions[triangle.vertices[1]] - a)
        .cross(scene.positions[triangle.vertices[2]] - a);
}

// --- collectTriangles ---------------------------------------------------------------------------

using CollectTriangles = OgreTest;

/// A unit square in x and y that faces +z, drawn as asked.
void addSquare(Ogre::ManualObject& object, Ogre::RenderOperation::OperationType type) {
    object.begin("BaseWhite", type);
    const bool strip = type == Ogre::RenderOperation::OT_TRIANGLE_STRIP;
    const std::array corners{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0),
                             Vector3(0, 1, 0)};
    for (const int i : strip ? std::array{0, 1, 3, 2} : std::array{0, 1, 2, 3})
        object.position(corners[static_cast<std::size_t>(i)]);
    if (type == Ogre::RenderOperation::OT_TRIANGLE_LIST) object.quad(0, 1, 2, 3);
    object.end();
}

TEST_F(CollectTriangles, ListsStripsAndFansAreTheSameSquare) {
    for (const auto type :
         {Ogre::RenderOperation::OT_TRIANGLE_LIST, Ogre::RenderOperation::OT_TRIANGLE_STRIP,
          Ogre::RenderOperation::OT_TRIANGLE_FAN}) {
        Ogre::ManualObject* object = scene->createManualObject();
        addSquare(*object, type);
        Ogre::SceneNode& node = child({5, 6, 7});
        node.attachObject(object);
        const TriangleScene triangles = collectTriangles(*scene);
        ASSERT_EQ(triangles.triangles.size(), 2U);
        double area = 0.0;
        for (const Triangle& triangle : triangles.triangles) {
            const Vector3d normal = normalOf(triangles, triangle);
            EXPECT_GT(normal.z(), 0.0);
            area += 0.5 * normal.norm();
        }
        EXPECT_DOUBLE_EQ(area, 1.0);
        EXPECT_EQ(triangles.box().min(), Vector3d(5, 6, 7));
        node.detachObject(object);
    }
}

TEST_F(CollectTriangles, LinesAreNoTriangles) {
    Ogre::ManualObject* object = scene->createManualObject();
    object->begin("BaseWhite", Ogre::RenderOperation::OT_LINE_LIST);
    object->position(0, 0, 0);
    object->position(1, 1, 1);
    object->end();
    child().attachObject(object);
    EXPECT_TRUE(collectTriangles(*scene).triangles.empty());
    EXPECT_TRUE(collectTriangles(*scene).box().isEmpty());
}

TEST_F(CollectTriangles, WideIndicesAndThisFramesTransforms) {
    MeshBuilder mesh;
    mesh.ground(1.0F, 300); // 301 x 301 vertices do not fit 16 bits
    Ogre::Entity* entity = scene->createEntity(mesh.build("wide"));
    Ogre::SceneNode& parent = child();
    parent.createChildSceneNode(Vector3(0, 3, 0))->attachObject(entity);
    collectTriangles(*scene);
    parent.setPosition(10, 0, 0); // moved after the last update: it must not lag
    const TriangleScene triangles = collectTriangles(*scene);
    EXPECT_EQ(triangles.triangles.size(), 180000U);
    EXPECT_NEAR((triangles.box().min() - Vector3d(9, 3, -1)).norm(), 0.0, 1e-6);
    EXPECT_NEAR((triangles.box().max() - Vector3d(11, 3, 1)).norm(), 0.0, 1e-6);
}

TEST_F(CollectTriangles, MirroredEntitiesKeepTheirFrontOutside) {
    MeshBuilder mesh;
    mesh.box({1, 1, 1}, {2, 3, 4});
    Ogre::SceneNode& node = child();
    node.attachObject(scene->createEntity(mesh.build("box")));
    for (const Vector3 scale :
         {Vector3(1, 1, 1), Vector3(-1, 1, 1), Vector3(2, -1, -3), Vector3(-1, -2, -1)}) {
        node.setScale(scale);
        const TriangleScene triangles = collectTriangles(*scene);
        const Vector3d centre = triangles.box().center();
        for (const Triangle& triangle : triangles.triangles)
            EXPECT_GT(normalOf(triangles, triangle)
                          .dot(triangles.positions[triangle.vertices[0]] - centre),
                      0.0);
    }
}

TEST_F(CollectTriangles, FlagsFollowObjectAndMaterial) {
    MeshBuilder mesh;
    mesh.boxOn(Vector3::ZERO, 1, 1, 1);
    const Ogre::MeshPtr box = mesh.build("box");
    const auto make = [&](const std::string& name) {
        Ogre::Entity* entity = scene->createEntity(box);
        entity->setMaterial(makeSurface(name, Ogre::ColourValue::White));
        child().attachObject(entity);
        return entity;
    };
    const auto flagsOf = [&](Ogre::Entity* entity) {
        for (Ogre::MovableObject* other : {entity})
            other->setVisible(true);
        const Triangle flags = collectTriangles(*scene).triangles.at(0);
        entity->setVisible(false);
        return flags;
    };
    EXPECT_TRUE(flagsOf(make("plain")).casts);

    Ogre::Entity* noCaster = make("no-caster");
    noCaster->setCastShadows(false);
    EXPECT_FALSE(flagsOf(noCaster).casts);

    Ogre::Entity* noReceiver = make("no-receiver");
    noReceiver->getSubEntity(0)->getMaterial()->setReceiveShadows(false);
    const Triangle flags = flagsOf(noReceiver);
    EXPECT_TRUE(flags.casts);
    EXPECT_FALSE(flags.receives);

    Ogre::Entity* glass = make("glass");
    glass->getSubEntity(0)->getMaterial()->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    EXPECT_FALSE(flagsOf(glass).casts);
    glass->getSubEntity(0)->getMaterial()->setTransparencyCastsShadows(true);
    EXPECT_TRUE(flagsOf(glass).casts);

    Ogre::Entity* sheet = make("sheet");
    sheet->getSubEntity(0)->getMaterial()->setCullingMode(Ogre::CULL_NONE);
    EXPECT_TRUE(flagsOf(sheet).drawnFromBack);

    EXPECT_TRUE(collectTriangles(*scene).triangles.empty()) << "all are hidden now";
    glass->setVisible(true);
    glass->setVisibilityFlags(2);
    scene->setVisibilityMask(1);
    EXPECT_TRUE(collectTriangles(*scene).triangles.empty()) << "masked";
}

TEST_F(CollectTriangles, StaticGeometryIsSeenOnce) {
    MeshBuilder mesh;
    mesh.boxOn(Vector3::ZERO, 1, 1, 1);
    Ogre::Entity* entity = scene->createEntity(mesh.build("box"));
    Ogre::StaticGeometry* geometry = scene->createStaticGeometry("static");
    geometry->addEntity(entity, {10, 0, 0});
    geometry->addEntity(entity, {2000, 0, 0}); // in another region
    geometry->setCastShadows(false);
    geometry->build();
    const TriangleScene triangles = collectTriangles(*scene);
    EXPECT_EQ(triangles.triangles.size(), 24U);
    EXPECT_NEAR((triangles.box().min() - Vector3d(9.5, 0, -0.5)).norm(), 0.0, 1e-4);
    EXPECT_NEAR((triangles.box().max() - Vector3d(2000.5, 1, 0.5)).norm(), 0.0, 1e-3);
    EXPECT_FALSE(triangles.triangles[0].casts);
}

TEST_F(CollectTriangles, FarFromTheWorldsOriginPositionsAreExactRelativeToAnother) {
    MeshBuilder mesh;
    mesh.boxOn(Vector3::ZERO, 1.5F, 1.25F, 1.0F / 1024.0F);
    Ogre::SceneNode& node = child({1e6F, -1e6F, 1e6F});
    node.attachObject(scene->createEntity(mesh.build("box")));
    const TriangleScene triangles = collectTriangles(*scene, {1e6, -1e6, 1e6});
    EXPECT_EQ(triangles.box().min(), Vector3d(-0.75, 0.0, -1.0 / 2048.0));
    EXPECT_EQ(triangles.box().max(), Vector3d(0.75, 1.25, 1.0 / 2048.0));
}

// --- oracleView and oracleLight -----------------------------------------------------------------

using OracleViewTest = OgreTest;

TEST_F(OracleViewTest, CameraAndLightAreWhereOgreHasThem) {
    const Vector3 offset(1e6F, 0.0F, -1e6F);
    SampleView view{"", offset + Vector3(3, 4, 5), offset, 1.0F, 50.0F, 40.0F, {}};
    applyView(view, *camera);
    const OracleView seen = oracleView(*camera, 320, 200, 12.0, {1e6, 0.0, -1e6});
    const Vector3d target = (seen.vsFromWs * Eigen::Vector4d(0, 0, 0, 1)).hnormalized();
    EXPECT_NEAR((target - Vector3d(0, 0, -std::sqrt(50.0))).norm(), 0.0, 1e-5);
    EXPECT_EQ(seen.shadowDistance, 12.0);
    // The far plane's middle is at clip depth w.
    const Eigen::Vector4d far = seen.clipFromVs * Eigen::Vector4d(0, 0, -50, 1);
    EXPECT_NEAR(far.z() / far.w(), 1.0, 1e-4);

    SampleLight lamp;
    lamp.kind = SampleLight::Kind::Spot;
    lamp.position = offset + Vector3(0, 8, 0);
    lamp.direction = Vector3(1, -2, 0.5F).normalisedCopy();
    lamp.innerDegrees = 30.0F;
    lamp.outerDegrees = 45.0F;
    lamp.range = 70.0F;
    applyLight(lamp, *light);
    const OracleLight spot = oracleLight(*light, {1e6, 0.0, -1e6});
    EXPECT_EQ(spot.kind, OracleLight::Kind::Spot);
    EXPECT_NEAR((spot.position - Vector3d(0, 8, 0)).norm(), 0.0, 1e-6);
    EXPECT_NEAR(spot.direction.dot(Vector3d(1, -2, 0.5).normalized()), 1.0, 1e-6);
    EXPECT_NEAR(spot.outerAngle, 0.785398, 1e-5);
    EXPECT_EQ(spot.range, 70.0);
}

TEST_F(OracleViewTest, APointLightIsWhereItsNodeWasMoved) {
    SampleLight lamp;
    lamp.kind = SampleLight::Kind::Point;
    lamp.range = 10.0F;
    for (const float x : {1.0F, 2.0F}) {
        lamp.position = Vector3(x, 8, 0);
        applyLight(lamp, *light);
        EXPECT_EQ(oracleLight(*light).position, Vector3d(static_cast<double>(x), 8, 0));
    }
}

// --- the scenes ---------------------------------------------------------------------------------

class EveryScene : public OgreTest, public ::testing::WithParamInterface<std::string> {
protected:
    const SampleScene& sample() const { return *findSampleScene(GetParam()); }
};

using Position = std::array<float, 3>;

struct MeshFault {
    std::size_t openEdges = 0;
    std::size_t badNormals = 0;
};

/// Edges without an opposite, by position; normals that are no unit vectors or point inwards.
MeshFault faultsOf(const Ogre::Mesh& mesh) {
    const Ogre::SubMesh& part = *mesh.getSubMeshes().at(0);
    const auto buffer = part.vertexData->vertexBufferBinding->getBuffer(0);
    std::vector<float> floats(buffer->getSizeInBytes() / sizeof(float));
    buffer->readData(0, buffer->getSizeInBytes(), floats.data());
    const std::size_t stride = buffer->getVertexSize() / sizeof(float);
    const auto vectorAt = [&](std::uint32_t vertex, std::size_t offset) {
        const float* p = floats.data() + vertex * stride + offset;
        return Vector3(p[0], p[1], p[2]);
    };
    const auto key = [](const Vector3& p) { return Position{p.x + 0.0F, p.y + 0.0F, p.z + 0.0F}; };

    std::vector<std::uint32_t> indices(part.indexData->indexCount);
    const bool wide = part.indexData->indexBuffer->getType() == Ogre::HardwareIndexBuffer::IT_32BIT;
    std::vector<std::uint16_t> narrow(wide ? 0 : indices.size());
    part.indexData->indexBuffer->readData(0, part.indexData->indexBuffer->getSizeInBytes(),
                                          wide ? static_cast<void*>(indices.data())
                                               : static_cast<void*>(narrow.data()));
    if (!wide) indices.assign(narrow.begin(), narrow.end());

    MeshFault fault;
    std::map<std::pair<Position, Position>, int> edges;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<Vector3, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = vectorAt(indices[i + k], 0);
        const Vector3 face = (p[1] - p[0]).crossProduct(p[2] - p[0]).normalisedCopy();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3 normal = vectorAt(indices[i + k], 3);
            if (!(std::abs(normal.length() - 1.0F) < 1e-3F) || !(normal.dotProduct(face) > 0.2F))
                ++fault.badNormals;
            ++edges[{key(p[k]), key(p[(k + 1) % 3])}];
            --edges[{key(p[(k + 1) % 3]), key(p[k])}];
        }
    }
    for (const auto& [edge, balance] : edges)
        fault.openEdges += balance != 0 ? 1 : 0;
    return fault;
}

/// A plane has no inside: it may cast although it is open.
bool isFlat(const Ogre::Mesh& mesh) {
    const Vector3 size = mesh.getBounds().getSize();
    return std::min({size.x, size.y, size.z}) == 0.0F;
}

template <typename Use>
void forEachEntity(Ogre::SceneManager& scene, const Use& use) {
    for (const auto& [name, object] : scene.getMovableObjects("Entity"))
        use(*static_cast<Ogre::Entity*>(object));
}

TEST_P(EveryScene, CastersAreClosedAndNormalsPointOut) {
    sample().build(*scene);
    std::set<Ogre::String> seen;
    forEachEntity(*scene, [&](Ogre::Entity& entity) {
        if (!seen.insert(entity.getMesh()->getName()).second) return;
        const MeshFault fault = faultsOf(*entity.getMesh());
        EXPECT_EQ(fault.badNormals, 0U) << entity.getMesh()->getName();
        if (entity.getCastShadows() && !isFlat(*entity.getMesh())) {
            EXPECT_EQ(fault.openEdges, 0U) << entity.getMesh()->getName();
        }
    });
    // The forest is one mesh.
    EXPECT_GT(seen.size(), GetParam() == "forest" ? 0U : 3U);
}

/// Whether some way out of there leads through the back of a caster first.
bool isWithinBody(const ShadowOracle& oracle, const Vector3& place) {
    const Vector3d origin = Vector3d(place.x, place.y, place.z) - oracle.scene().wsOrigin;
    std::vector<CasterRay> rays;
    for (const Vector3d& along :
         {Vector3d(1, 0.1, 0.2), Vector3d(-1, 0.2, 0.1), Vector3d(0.1, 1, 0.1),
          Vector3d(0.2, -1, -0.1), Vector3d(-0.1, 0.1, 1), Vector3d(0.1, 0.2, -1)})
        rays.push_back({origin, along.normalized(), 1e5});
    std::vector<double> fronts(rays.size());
    std::vector<double> backs(rays.size());
    oracle.firstCasters(rays, CasterFaces::Fronts, fronts);
    oracle.firstCasters(rays, CasterFaces::Backs, backs);
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (backs[i] < fronts[i]) return true;
    return false;
}

TEST_P(EveryScene, NeitherEyesNorLampsAreWithinBodies) {
    // What is within one has no shadow in a map of casters' back faces, and one in truth.
    sample().build(*scene);
    const ShadowOracle oracle(collectTriangles(*scene));
    for (const SampleView& view : sample().views)
        EXPECT_FALSE(isWithinBody(oracle, view.position)) << view.name;
    for (const SampleLight& lamp : sample().lights) {
        if (lamp.kind == SampleLight::Kind::Directional) continue;
        EXPECT_FALSE(isWithinBody(oracle, lamp.position)) << lamp.name;
    }
}

TEST_P(EveryScene, EntitiesAreScaledEqually) {
    // Normals of Lixel/Surface are turned by the world matrix itself.
    sample().build(*scene);
    forEachEntity(*scene, [&](Ogre::Entity& entity) {
        const Vector3 scale = entity.getParentSceneNode()->_getDerivedScale();
        EXPECT_EQ(scale.x, scale.y);
        EXPECT_EQ(scale.x, scale.z);
    });
}

TEST_P(EveryScene, IsTheSameEveryTimeAndCanBeBuiltAgain) {
    sample().build(*scene);
    const TriangleScene first = collectTriangles(*scene);
    scene->clearScene();
    sample().build(*scene);
    const TriangleScene second = collectTriangles(*scene);
    ASSERT_EQ(first.positions.size(), second.positions.size());
    EXPECT_TRUE(
        std::equal(first.positions.begin(), first.positions.end(), second.positions.begin()));
}

/// What a picture shows, in percent of its pixels.
struct Shares {
    std::ptrdiff_t lit = 0;
    std::ptrdiff_t shadowed = 0;
    std::ptrdiff_t background = 0;
};

Shares sharesOf(const ShadowTruth& truth) {
    const auto share = [&](PixelClass wanted) {
        const auto pixels = std::count(truth.pixels.begin(), truth.pixels.end(), wanted);
        return 100 * pixels / std::ssize(truth.pixels);
    };
    return {share(PixelClass::Lit), share(PixelClass::Shadowed), share(PixelClass::Background)};
}

TEST_P(EveryScene, EveryViewShowsLightAndShadow) {
    sample().build(*scene);
    const ShadowOracle oracle(collectTriangles(*scene));
    ASSERT_GE(sample().views.size(), 2U);
    const bool directional = sample().lights.front().kind == SampleLight::Kind::Directional;
    ASSERT_GE(sample().lights.size(), directional ? 4U : 1U);
    camera->setAspectRatio(1.5F);
    const auto look = [&](const SampleView& view, std::size_t index) {
        applyView(view, *camera);
        applyLight(lightOf(sample(), view, index), *light);
        const double distance = static_cast<double>(sample().shadowDistance);
        return sharesOf(
            oracle.classify(oracleView(*camera, 120, 80, distance), oracleLight(*light)));
    };
    for (const SampleView& view : sample().views) {
        SCOPED_TRACE(view.name);
        if (!sample().bySeed) {
            const Shares shares = look(view, 0);
            EXPECT_GE(shares.lit, 15);
            // A lamp at the viewer's temple hides little from the viewer.
            EXPECT_GE(shares.shadowed, directional ? 4 : 1);
            EXPECT_LE(shares.background, 55);
            continue;
        }
        // Whatever a seed has put where, under one of the lights there is something to see.
        Shares most;
        for (std::size_t i = 0; i < sample().lights.size(); ++i) {
            const Shares shares = look(view, i);
            if (std::min(shares.lit, shares.shadowed) >= std::min(most.lit, most.shadowed))
                most = shares;
        }
        EXPECT_GE(most.lit, 5);
        EXPECT_GE(most.shadowed, 1);
        EXPECT_LE(most.background, 65);
    }
}

std::vector<std::string> namesOfScenes() {
    std::vector<std::string> names;
    for (const SampleScene& scene : measuredScenes())
        names.push_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, ::testing::ValuesIn(namesOfScenes()),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(SampleViews, BySeedAreInTheirRangesAboveTheGround) {
    const auto hill = [](float x, float z) { return 0.1F * x + 0.2F * z + 3.0F; };
    const ViewRange range{.name = "somewhere",
                          .eyes = {-5, 1, -5, 5, 2, 5},
                          .targets = {-6, 0, -6, 6, 1, 6},
                          .leastDistance = 4.0F};
    std::vector<SampleView> views;
    Random random(3);
    addViews(views, range, 200, random, hill);
    ASSERT_EQ(views.size(), 200U);
    EXPECT_EQ(views.back().name, "somewhere-200");
    for (const SampleView& view : views) {
        EXPECT_GE(view.position.distance(view.target), 4.0F);
        const float above = view.position.y - hill(view.position.x, view.position.z);
        EXPECT_GE(above, 0.999F);
        EXPECT_LE(above, 2.001F);
        EXPECT_LE(std::max(std::abs(view.target.x), std::abs(view.target.z)), 6.0F);
    }
    Random again(3);
    std::vector<SampleView> same;
    addViews(same, range, 200, again, hill);
    EXPECT_EQ(same.back().position, views.back().position);
}

using OgresSplits = OgreTest;

TEST_F(OgresSplits, ReachTheFarPlaneWithoutAShadowDistance) {
    camera->setNearClipDistance(1.0F);
    camera->setFarClipDistance(1000.0F);
    const NamedSetup& setup = *findEmulatedSetup("Ogre-PSSM-3");
    EXPECT_EQ(setup.splitDepths(*camera, 200.0).back(), 200.0);
    EXPECT_EQ(setup.splitDepths(*camera, 0.0).back(), 1000.0);
}

TEST(SampleScenes, AreFoundByName) {
    EXPECT_EQ(measuredScenes().size(), 14U);
    EXPECT_EQ(std::ranges::count(measuredScenes(), true, &SampleScene::bySeed), 10);
    EXPECT_EQ(findSampleScene("no such scene"), nullptr);
}

TEST(SampleScenes, TheMinersLampIsAtTheViewersTemple) {
    for (const SampleView& view : findSampleScene("miners-lamp")->views) {
        ASSERT_TRUE(view.light);
        EXPECT_LT(view.light->position.distance(view.position), 0.35F);
        EXPECT_GT(view.light->direction.dotProduct((view.target - view.position).normalisedCopy()),
                  0.999F);
    }
}

TEST(SampleLights, TurnWithTheirView) {
    SampleScene sample;
    sample.lights = {sunlight("fixed", 0.0F, 30.0F), sunlight("against", 180.0F, 30.0F)};
    sample.lights[1].turnsWithView = true;
    const auto look = [](const Vector3& along) {
        const Vector3 eye(5, 6, 7);
        return SampleView{"", eye, eye + along, 1.0F, 50.0F, 40.0F, {}};
    };
    for (const Vector3& along : {Vector3(0, 0, -1), Vector3(1, 0.3F, 0), Vector3(-2, -1, 3)}) {
        const SampleView view = look(along);
        EXPECT_EQ(lightOf(sample, view, 0).direction, sample.lights[0].direction);
        const Vector3 direction = lightOf(sample, view, 1).direction;
        EXPECT_NEAR(direction.y, -0.5F, 1e-6F);
        // It travels towards the viewer.
        const Vector3 ahead = Vector3(along.x, 0, along.z).normalisedCopy();
        EXPECT_NEAR(direction.dotProduct(ahead), -std::sqrt(0.75F), 1e-6F);
    }
    EXPECT_EQ(lightOf(sample, look({0, 0, -1}), 1).direction, sample.lights[1].direction);
    // There is no telling where a view straight down heads for.
    EXPECT_NEAR(lightOf(sample, look({0, -1, 0}), 1).direction.length(), 1.0F, 1e-6F);
    EXPECT_THROW(lightOf(sample, look({1, 0, 0}), 2), std::out_of_range);
}

TEST(SampleLights, AreFoundByNameAndAViewsOwnStandsForTheFirst) {
    SampleScene sample;
    sample.lights = {sunlight("first", 0.0F, 30.0F), sunlight("second", 90.0F, 30.0F)};
    SampleView view;
    EXPECT_EQ(findLight(sample, view, "second")->direction, sample.lights[1].direction);
    EXPECT_EQ(findLight(sample, view, "third"), std::nullopt);
    view.light = sunlight("own", 45.0F, 10.0F);
    EXPECT_EQ(defaultLight(sample, view).name, "own");
    EXPECT_EQ(findLight(sample, view, "own")->direction, view.light->direction);
    EXPECT_EQ(findLight(sample, view, "first"), std::nullopt);
    EXPECT_EQ(lightOf(sample, view, 1).name, "second");
}

using MakeSurface = OgreTest;

TEST_F(MakeSurface, ColoursEveryPassAndReplacesItsName) {
    const auto red = makeSurface("surface", Ogre::ColourValue::Red);
    for (const Ogre::Pass* pass : red->getTechnique(0)->getPasses()) {
        EXPECT_EQ(pass->getAmbient(), Ogre::ColourValue::Red);
        EXPECT_EQ(pass->getDiffuse(), Ogre::ColourValue::Red);
    }
    const auto blue = makeSurface("surface", Ogre::ColourValue::Blue);
    EXPECT_EQ(red->getTechnique(0)->getPass(0)->getDiffuse(), Ogre::ColourValue::Red);
    EXPECT_EQ(Ogre::MaterialManager::getSingleton().getByName("surface"), blue);
}

TEST_F(MakeSurface, SaysThatATextureHasNoUnit) {
    const auto original = Ogre::MaterialManager::getSingleton().getByName(SurfaceTemplate);
    for (Ogre::Pass* pass : original->getTechnique(0)->getPasses())
        pass->removeAllTextureUnitStates();
    EXPECT_THROW(makeSurface("surface", Ogre::ColourValue::Red, "picture.png"),
                 Ogre::InvalidStateException);
}

TEST_F(MakeSurface, SaysWhatIsMissing) {
    Ogre::MaterialManager::getSingleton().remove(
        SurfaceTemplate, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
    try {
        makeSurface("surface", Ogre::ColourValue::Red);
        FAIL();
    } catch (const Ogre::ItemIdentityException& error) {
        EXPECT_NE(error.getDescription().find(SurfaceTemplate), std::string::npos);
    }
}

// --- models -------------------------------------------------------------------------------------

class ModelFileTest : public OgreTest {
protected:
    ModelFileTest() { std::filesystem::create_directories(mDirectory); }
    ~ModelFileTest() override { std::filesystem::remove_all(mDirectory); }

    std::string write(const std::string& name, const std::string& text) const {
        const auto path = mDirectory / name;
        std::ofstream(path) << text;
        return path.string();
    }

    /// What the exception says; empty when there is none.
    static std::string refusal(const std::string& path) {
        try {
            const ModelFile file(path);
        } catch (const Ogre::Exception& error) {
            return error.getDescription();
        }
        return {};
    }

private:
    std::filesystem::path mDirectory =
        std::filesystem::path(::testing::TempDir()) /
        ("lixel-models-" +
         std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

/// A unit cube standing on y = 0, without normals.
const std::string Cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

TEST_F(ModelFileTest, ACubeGetsNormalsAndAGround) {
    const ImportedModel model =
        importModel(*scene, *scene->getRootSceneNode(), write("cube.obj", Cube));
    EXPECT_EQ(model.triangles, 12U);
    EXPECT_TRUE(model.groundAdded);
    EXPECT_EQ(model.box.getMinimum(), Vector3(0, 0, 0));
    EXPECT_EQ(model.box.getMaximum(), Vector3(1, 1, 1));
    forEachEntity(*scene, [](Ogre::Entity& entity) {
        EXPECT_EQ(faultsOf(*entity.getMesh()).badNormals, 0U);
    });
    const TriangleScene triangles = collectTriangles(*scene);
    EXPECT_EQ(std::count_if(triangles.triangles.begin(), triangles.triangles.end(),
                            [](const Triangle& t) { return t.casts; }),
              12);
    EXPECT_EQ(triangles.box().min().y(), 0.0) << "the ground is at the lowest point";
    EXPECT_LT(triangles.box().min().x(), -4.0);
}

TEST_F(ModelFileTest, AModelOnItsOwnGroundGetsNone) {
    const std::string floor = "v -9 0 -9\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nf -4 -3 -2 -1\n";
    EXPECT_TRUE(ModelFile(write("room.obj", Cube + floor)).hasGround());
    const std::string ceiling = "v -9 0 -9\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nf -1 -2 -3 -4\n";
    EXPECT_FALSE(ModelFile(write("lid.obj", Cube + ceiling)).hasGround());
}

/// One triangle (0,0,0) (1,0,0) (0,1,0) below nodes with the given properties.
std::string gltf(const std::string& parent, const std::string& child,
                 const std::string& material = "{}") {
    // Nine floats, little endian.
    const std::string data = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1])" +
           parent + R"(},{"mesh":0)" + child +
           R"(}],"meshes":[{"primitives":[{"attributes":)"
           R"({"POSITION":0},"material":0}]}],"materials":[)" +
           material +
           R"(],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" + data +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
}

/// The casting triangles' corners, in order.
std::vector<Vector3d> corners(Ogre::SceneManager& scene) {
    const TriangleScene triangles = collectTriangles(scene);
    std::vector<Vector3d> result;
    for (const Triangle& triangle : triangles.triangles)
        if (triangle.casts)
            for (const auto vertex : triangle.vertices)
                result.push_back(triangles.positions[vertex]);
    return result;
}

TEST_F(ModelFileTest, NodesKeepTheirHierarchy) {
    const std::string path = write("nodes.gltf", gltf(R"(,"translation":[10,0,0],"scale":[2,2,2])",
                                                      R"(,"translation":[0,1,0])"));
    const ImportedModel model = importModel(*scene, *scene->getRootSceneNode(), path);
    const auto points = corners(*scene);
    ASSERT_EQ(points.size(), 3U);
    EXPECT_NEAR((points[0] - Vector3d(10, 2, 0)).norm(), 0.0, 1e-6);
    EXPECT_NEAR((points[1] - Vector3d(12, 2, 0)).norm(), 0.0, 1e-6);
    EXPECT_NEAR((points[2] - Vector3d(10, 4, 0)).norm(), 0.0, 1e-6);
    EXPECT_GT(model.node->numChildren(), 0U);
}

TEST_F(ModelFileTest, ShearAndMirrorsAreBaked) {
    // Unequal scale above a turn of 45 degrees about z: a shear, which no node can hold.
    const std::string path = write(
        "shear.gltf", gltf(R"(,"scale":[3,1,-1])", R"(,"rotation":[0,0,0.38268343,0.92387953])"));
    importModel(*scene, *scene->getRootSceneNode(), path);
    const auto points = corners(*scene);
    ASSERT_EQ(points.size(), 3U);
    const double h = std::sqrt(0.5);
    // Mirroring swaps the second and third corner, so that the front stays the front.
    const Vector3d x(3 * h, h, 0);
    const Vector3d y(-3 * h, h, 0);
    EXPECT_NEAR((points[0] - Vector3d(0, 0, 0)).norm(), 0.0, 1e-6);
    EXPECT_NEAR((points[1] - y).norm(), 0.0, 1e-6);
    EXPECT_NEAR((points[2] - x).norm(), 0.0, 1e-6);
    forEachEntity(*scene, [](Ogre::Entity& entity) {
        EXPECT_EQ(faultsOf(*entity.getMesh()).badNormals, 0U);
    });
}

TEST_F(ModelFileTest, TwoSidedMaterialsGetBackSides) {
    const std::string path = write("sheet.gltf", gltf("", "", R"({"doubleSided":true})"));
    importModel(*scene, *scene->getRootSceneNode(), path);
    EXPECT_EQ(corners(*scene).size(), 6U);
}

TEST_F(ModelFileTest, ATextureThatCannotBeReadIsSaidOnceWhoeverSharesIt) {
    write("cube.mtl", "newmtl a\nmap_Kd missing.png\nnewmtl b\nmap_Kd missing.png\n");
    const std::string path =
        write("cube.obj", "mtllib cube.mtl\nusemtl a\n" + Cube + "usemtl b\nf 2 3 7 6\n");
    const ImportedModel model = importModel(*scene, *scene->getRootSceneNode(), path);
    ASSERT_EQ(model.notes.size(), 1U);
    EXPECT_NE(model.notes.front().find("'missing.png' cannot be read"), std::string::npos);

    const Tests::LogCollector log;
    modelScene(path).build(*scene);
    EXPECT_EQ(log.count("cube.obj': texture 'missing.png' cannot be read"), 1U) << log.all();
}

TEST_F(ModelFileTest, WhatIsWrongIsSaid) {
    EXPECT_NE(refusal("no/such/file.obj").find("there is no file 'no/such/file.obj'"),
              std::string::npos);
    EXPECT_NE(refusal(write("broken.glb", "glTF but not really")).find("cannot be read"),
              std::string::npos);
    EXPECT_NE(refusal(write("empty.obj", "")).find("empty.obj"), std::string::npos);
    EXPECT_NE(refusal(write("unknown.format", "what is this?")).find("cannot be read"),
              std::string::npos);
    EXPECT_NE(refusal(write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")).find("holds no triangles"),
              std::string::npos);
    EXPECT_NE(refusal(write("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")), "");
}

TEST_F(ModelFileTest, NaNAndInfinityNeverReachOgre) {
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n";
    for (const std::string bad : {"nan", "inf", "-inf", "1e30"}) {
        SCOPED_TRACE(bad);
        std::string text = header;
        text += "0 0 0\n1 0 0\n0 ";
        text += bad;
        text += " 0\n3 0 1 2\n";
        EXPECT_NE(refusal(write(bad + ".ply", text)), "");
    }
    const std::string far = write("far.gltf", gltf(R"(,"translation":[1e30,0,0])", ""));
    EXPECT_NE(refusal(far).find("no finite place"), std::string::npos);
}

TEST_F(ModelFileTest, AModelIsASceneWithViewsAndLights) {
    const SampleScene model = modelScene(write("cube.obj", Cube));
    ASSERT_GE(model.views.size(), 2U);
    ASSERT_GE(model.lights.size(), 4U);
    model.build(*scene);
    const ShadowOracle oracle(collectTriangles(*scene));
    std::size_t withShadow = 0;
    for (const SampleView& view : model.views) {
        SCOPED_TRACE(view.name);
        applyView(view, *camera);
        applyLight(defaultLight(model, view), *light);
        const ShadowTruth truth =
            oracle.classify(oracleView(*camera, 60, 40, static_cast<double>(model.shadowDistance)),
                            oracleLight(*light));
        const auto count = [&](PixelClass wanted) {
            return std::count(truth.pixels.begin(), truth.pixels.end(), wanted);
        };
        EXPECT_GT(count(PixelClass::Lit) + count(PixelClass::Shadowed), 400);
        withShadow += count(PixelClass::Shadowed) > 20 ? 1U : 0U;
    }
    // Made from the box alone: from inside, or with the sun ahead, a cube shows no shadow.
    EXPECT_GE(2 * withShadow, model.views.size());
}

} // namespace
} // namespace Lixel::Samples
