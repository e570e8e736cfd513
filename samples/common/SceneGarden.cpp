#include "common/GardenFigure.h"
#include "common/GardenGround.h"
#include "common/GardenPlants.h"
#include "common/GardenThings.h"
#include "common/SceneList.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Degree;
using Ogre::Vector2;
using Ogre::Vector3;

// Metres. The path comes towards the viewer from the shed, through a gap between two fences.

const std::string GardenName = "Lixel/Samples/garden/";

const std::array PathLine{Vector2(3.6F, -9.6F),  Vector2(2.9F, -7.0F), Vector2(1.2F, -3.6F),
                          Vector2(0.8F, 0.0F),   Vector2(-0.6F, 4.0F), Vector2(-3.2F, 8.0F),
                          Vector2(-4.6F, 13.0F), Vector2(-5.0F, 20.0F)};
constexpr float PathWidth = 1.7F;
const std::array WestFence{Vector2(-27.0F, 1.0F), Vector2(-18.0F, -3.0F), Vector2(-10.0F, -4.3F),
                           Vector2(-4.0F, -4.0F), Vector2(0.2F, -3.7F)};
const std::array EastFence{Vector2(2.25F, -3.6F), Vector2(6.0F, -3.4F), Vector2(12.0F, -4.6F),
                           Vector2(20.0F, -4.0F), Vector2(28.0F, -7.0F)};

const Vector2 ShedPlace(4.3F, -12.2F);
const Vector2 WellPlace(6.6F, 1.4F);
const Vector2 BenchPlace(-4.3F, -2.2F);
const Vector2 LanternPlace(-1.35F, -1.5F);
const Vector2 GardenerPlace(0.45F, 1.3F);
constexpr float GardenerYaw = -14.0F; ///< degrees: along the path

/// A tree of the garden, by where it stands.
struct GardenTree {
    Vector2 place;
    CrownShape crown;
    std::uint32_t seed;
};
const std::array GardenTrees{GardenTree{{-5.4F, -5.2F}, {3.4F, 2.1F, 300, 0.8F}, 1},
                             GardenTree{{9.6F, -1.6F}, {3.3F, 2.0F, 380, 0.8F}, 2},
                             GardenTree{{-11.0F, 3.6F}, {3.0F, 1.9F, 340, 0.8F}, 3},
                             GardenTree{{-0.6F, -9.5F}, {3.9F, 2.2F, 400, 0.9F}, 4},
                             GardenTree{{10.5F, -10.0F}, {4.3F, 2.6F, 460, 0.95F}, 5}};

Ogre::Entity* placeNamed(Ogre::SceneManager& sceneManager, const Ogre::MeshPtr& mesh,
                         const char* material, const Placement& placement = {}) {
    const Ogre::MaterialPtr found = Ogre::MaterialManager::getSingleton().getByName(material);
    if (!found)
        OGRE_EXCEPT(Ogre::Exception::ERR_ITEM_NOT_FOUND,
                    Ogre::String("material '") + material +
                        "' is missing: OGRE's shader system has to run, with media/garden",
                    "gardenScene");
    return place(sceneManager, mesh, found, placement);
}

void placeParts(Ogre::SceneManager& sceneManager, const std::vector<GardenPart>& parts,
                const Vector2& at, float yawDegrees) {
    for (const GardenPart& part : parts)
        placeNamed(sceneManager, part.mesh, part.material, {onGarden(at.x, at.y), yawDegrees, 1.0F})
            ->setCastShadows(part.casts);
}

void placeGroundAndPath(Ogre::SceneManager& sceneManager, std::span<const Vector2> path) {
    placeNamed(sceneManager, gardenGround(GardenName + "ground"), "Garden/Ground")
        ->setCastShadows(false);
    placeNamed(sceneManager, gardenPath(GardenName + "path", path, PathWidth), "Garden/Path")
        ->setCastShadows(false);
}

void placeFences(Ogre::SceneManager& sceneManager) {
    const auto add = [&](const std::string& name, std::span<const Vector2> line) {
        const GardenFence fence(GardenName + name, curveThrough(line, GardenFence::PictureWidth));
        placeNamed(sceneManager, fence.pickets, "Garden/Fence");
        placeNamed(sceneManager, fence.posts, "Garden/Paint");
    };
    add("fence-west", WestFence);
    add("fence-east", EastFence);
}

void placeTrees(Ogre::SceneManager& sceneManager) {
    for (const GardenTree& tree : GardenTrees) {
        TreeBuilders builders;
        Random random(tree.seed);
        builders.add(Vector3::ZERO, tree.crown, random);
        const std::string name = GardenName + "tree" + std::to_string(tree.seed);
        const Placement placement{onGarden(tree.place.x, tree.place.y), 0.0F, 1.0F};
        placeNamed(sceneManager, builders.wood.build(name + "/wood"), "Garden/Bark", placement);
        placeNamed(sceneManager, builders.leaves.build(name + "/leaves"), "Garden/Leaves",
                   placement);
    }
}

/// Trees of the hills, in a few groves of one mesh each, and bushes.
void placeGroves(Ogre::SceneManager& sceneManager) {
    constexpr int Groves = 8, TreesOfGrove = 5;
    Random random(17);
    for (int grove = 0; grove < Groves; ++grove) {
        TreeBuilders builders;
        for (int i = 0; i < TreesOfGrove; ++i) {
            const float turn =
                360.0F * static_cast<float>(grove * TreesOfGrove + i) / (Groves * TreesOfGrove) +
                random.between(-4.0F, 4.0F);
            const float angle = Degree(turn).valueRadians();
            // Farther away where the low sun comes from.
            const bool isBehindFence = turn > 172.0F && turn < 232.0F;
            const float far = random.between(isBehindFence ? 46.0F : 27.0F, 56.0F);
            const float radius = random.between(2.2F, 3.6F);
            builders.add(onGarden(far * std::sin(angle), far * std::cos(angle)),
                         {1.55F * radius, radius, 150, 0.62F * radius}, random);
        }
        const std::string name = GardenName + "grove" + std::to_string(grove);
        placeNamed(sceneManager, builders.wood.build(name + "/wood"), "Garden/Bark");
        placeNamed(sceneManager, builders.leaves.build(name + "/leaves"), "Garden/DarkLeaves");
    }
    TreeBuilders bushes;
    for (const Vector3& bush :
         {Vector3(1.7F, 0.75F, -11.3F), Vector3(7.0F, 0.9F, -11.0F), Vector3(-9.5F, 0.8F, -2.9F),
          Vector3(13.0F, 0.85F, -3.2F), Vector3(-13.6F, 0.8F, -2.6F), Vector3(8.3F, 0.6F, 2.6F)})
        bushes.addBush(onGarden(bush.x, bush.z), bush.y, static_cast<int>(150.0F * bush.y), random);
    placeNamed(sceneManager, bushes.leaves.build(GardenName + "bushes"), "Garden/DarkLeaves");
}

/// Whether something else stands there.
bool isTaken(const Vector2& at, std::span<const Vector2> path) {
    return distanceFrom(path, at) < 0.5F * PathWidth + 0.15F || at.distance(ShedPlace) < 2.7F ||
           at.distance(WellPlace) < 1.1F || at.distance(BenchPlace) < 1.0F;
}

Placement standing(const Vector2& at, Random& random, float least, float most) {
    return {onGarden(at.x, at.y, -0.02F), random.between(0.0F, 360.0F),
            random.between(least, most)};
}

void plantGrass(Ogre::SceneManager& sceneManager, std::span<const Vector2> path) {
    // Each is as many as are drawn together, about a middle and up to so far from it.
    const std::array<std::pair<Vector2, float>, 5> patches{{{{-6.0F, 2.0F}, 6.5F},
                                                            {{5.5F, 4.0F}, 6.5F},
                                                            {{-2.0F, 9.5F}, 6.5F},
                                                            {{-16.0F, -1.0F}, 6.5F},
                                                            {{5.0F, -8.0F}, 8.0F}}};
    const Ogre::MeshPtr grass = tuft(GardenName + "grass", 0.62F, 0.42F, 3);
    std::size_t planted = 0;
    plantInstances(
        sceneManager, grass->getName(), "Garden/Grass",
        static_cast<int>(patches.size() * InstancesTogether),
        [&](Random& random) {
            const auto& [middle, reach] = patches[planted++ / InstancesTogether];
            Vector2 at;
            do {
                const float turn = random.between(0.0F, Ogre::Math::TWO_PI);
                const float out = reach * std::pow(random.between(0.0F, 1.0F), 0.6F);
                at = middle + out * Vector2(std::sin(turn), std::cos(turn));
            } while (isTaken(at, path));
            return standing(at, random, 0.6F, 1.25F);
        },
        31);
}

void plantFlowers(Ogre::SceneManager& sceneManager, std::span<const Vector2> path) {
    // Before the fences, and on both sides of the path.
    const std::array lines{curveThrough(WestFence, 0.5F), curveThrough(EastFence, 0.5F),
                           std::vector<Vector2>(path.begin(), path.end())};
    const std::array low{Vector2(-0.6F, 0.25F), Vector2(-0.6F, 0.25F), Vector2(-1.8F, -1.8F)};
    const std::array high{Vector2(0.6F, 1.1F), Vector2(0.6F, 1.1F), Vector2(1.8F, 1.8F)};
    const Ogre::MeshPtr flowers = tuft(GardenName + "flowers", 0.5F, 0.52F, 2);
    constexpr std::size_t Each = 64;
    std::size_t planted = 0;
    plantInstances(
        sceneManager, flowers->getName(), "Garden/Flowers", static_cast<int>(lines.size() * Each),
        [&](Random& random) {
            const std::size_t i = planted++ / Each;
            Vector2 at;
            do {
                const int point = random.below(static_cast<int>(lines[i].size()));
                at = lines[i][static_cast<std::size_t>(point)] +
                     Vector2(random.between(low[i].x, high[i].x),
                             random.between(low[i].y, high[i].y));
            } while (isTaken(at, path) || at.length() > 23.0F);
            return standing(at, random, 0.75F, 1.15F);
        },
        37);
}

void placeGardener(Ogre::SceneManager& sceneManager) {
    const Vector3 feet = onGarden(GardenerPlace.x, GardenerPlace.y, 0.03F);
    Ogre::Entity& gardener = *sceneManager.createEntity(gardenerMesh(GardenName + "gardener"));
    Ogre::SceneNode& node = *sceneManager.getRootSceneNode()->createChildSceneNode(
        feet, Ogre::Quaternion(Degree(GardenerYaw), Vector3::UNIT_Y));
    node.attachObject(&gardener);
    poseWalking(gardener);
    placeNamed(sceneManager, wateringCan(GardenName + "can"), "Garden/Can",
               {feet + node.getOrientation() * leftHandOf(gardener), GardenerYaw, 1.0F});
}

void buildGarden(Ogre::SceneManager& sceneManager) {
    const std::vector<Vector2> path = curveThrough(PathLine, 0.4F);
    placeGroundAndPath(sceneManager, path);
    placeFences(sceneManager);
    placeTrees(sceneManager);
    placeGroves(sceneManager);
    plantGrass(sceneManager, path);
    plantFlowers(sceneManager, path);
    placeGardener(sceneManager);
    placeParts(sceneManager, gardenShed(GardenName + "shed"), ShedPlace, 4.0F);
    placeParts(sceneManager, gardenWell(GardenName + "well"), WellPlace, -28.0F);
    placeParts(sceneManager, gardenBench(GardenName + "bench"), BenchPlace, 14.0F);
    placeParts(sceneManager, gardenLantern(GardenName + "lantern"), LanternPlace, 20.0F);
}

SampleLight gardenSun(const std::string& name, float azimuthDegrees, float elevationDegrees) {
    SampleLight sun = sunlight(name, azimuthDegrees, elevationDegrees);
    sun.shadowPreset = "Garden/Sun";
    return sun;
}

SampleLight lantern() {
    SampleLight light;
    light.name = "lantern";
    light.kind = SampleLight::Kind::Point;
    light.position = onGarden(LanternPlace.x, LanternPlace.y, LanternHeight);
    light.range = 18.0F;
    light.colour = ColourValue(1.35F, 1.0F, 0.58F);
    light.shadowPreset = "Lixel/Point";
    return light;
}

} // namespace

SampleScene gardenScene() {
    const SampleSky evening{ColourValue(0.37F, 0.38F, 0.46F), ColourValue(0.93F, 0.82F, 0.70F)};
    const SampleSky night{ColourValue(0.10F, 0.13F, 0.22F), ColourValue(0.05F, 0.07F, 0.14F)};
    SampleScene scene;
    scene.name = "garden";
    scene.title = "Garden: leaves, a fence, a gardener of bones, and instances of grass";
    scene.build = buildGarden;
    scene.views = {
        {"path", {-3.7F, 2.0F, 7.6F}, {1.0F, 1.0F, -1.6F}, 0.2F, 200.0F, 50.0F, {}},
        {"fence",
         {-14.6F, 1.2F, 2.9F},
         {-17.6F, 0.6F, -3.6F},
         0.1F,
         200.0F,
         55.0F,
         gardenSun("low", 184.0F, 15.0F),
         evening},
        {"bench",
         {-0.6F, 1.8F, 2.6F},
         {-5.2F, 1.0F, -3.2F},
         0.1F,
         200.0F,
         55.0F,
         gardenSun("high", 204.0F, 56.0F)},
        {"lantern",
         {-4.4F, 1.7F, 3.6F},
         {0.6F, 0.95F, -1.0F},
         0.1F,
         200.0F,
         55.0F,
         lantern(),
         night},
    };
    scene.lights = {gardenSun("afternoon", 258.0F, 33.0F), gardenSun("low", 184.0F, 15.0F),
                    gardenSun("high", 204.0F, 56.0F), gardenSun("from-behind", 30.0F, 28.0F),
                    lantern()};
    scene.shadowDistance = 70.0F;
    scene.sky = {ColourValue(0.38F, 0.43F, 0.50F), ColourValue(0.66F, 0.79F, 0.90F)};
    scene.shaderSystem = true;
    return scene;
}

} // namespace Lixel::Samples
