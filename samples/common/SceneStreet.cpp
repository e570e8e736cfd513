#include "common/SceneList.h"
#include "common/ScenePieces.h"

#include <algorithm>
#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

const std::string StreetPath = "Lixel/Samples/street/";

// Metres; the street runs along z.
constexpr float HalfStreet = 5.0F;        ///< from the middle to the kerb
constexpr float Sidewalk = 3.0F;          ///< width
constexpr float Kerb = 0.14F;             ///< height
constexpr float HalfStreetLength = 84.0F; ///< of the street
constexpr float Storey = 3.1F;
// On the left the houses make room for a park, over which the low sun comes in.
constexpr float ParkBack = -34.0F;
constexpr float ParkFront = 46.0F;

/// The parts of a house, each of one material; the front faces +z at z = 0, the house lies behind.
struct HouseMeshes {
    float width;
    Ogre::MeshPtr walls;
    Ogre::MeshPtr roof;
    Ogre::MeshPtr trim;
    Ogre::MeshPtr glass;
};

struct HouseShape {
    float width;
    float depth;
    int storeys;
    int windows; ///< per storey
    bool balconies;
    bool gableToStreet;
};

void addWindow(MeshBuilder& trim, MeshBuilder& glass, float x, float sill) {
    constexpr float Width = 1.05F;
    constexpr float Tall = 1.55F;
    glass.boxOn({x, sill, 0.0F}, Width, Tall, 0.06F);
    for (const float side : {-1.0F, 1.0F})
        trim.boxOn({x + side * 0.5F * (Width + 0.12F), sill, 0.0F}, 0.12F, Tall, 0.2F);
    trim.boxOn({x, sill + Tall, 0.0F}, Width + 0.3F, 0.16F, 0.28F);
    trim.boxOn({x, sill - 0.1F, 0.08F}, Width + 0.36F, 0.1F, 0.4F);
    trim.boxOn({x, sill + 0.6F * Tall, 0.02F}, Width, 0.05F, 0.08F);
}

void addBalcony(MeshBuilder& trim, float x, float floor) {
    constexpr float Width = 2.6F;
    constexpr float Deep = 1.2F;
    trim.box({x - 0.5F * Width, floor - 0.18F, 0.0F}, {x + 0.5F * Width, floor, Deep});
    const auto bar = [&](float bx, float bz) { trim.boxOn({bx, floor, bz}, 0.04F, 0.95F, 0.04F); };
    for (int i = 0; i <= 16; ++i)
        bar(x - 0.5F * Width + 0.05F + static_cast<float>(i) * (Width - 0.1F) / 16.0F,
            Deep - 0.05F);
    for (int i = 0; i < 6; ++i) {
        const float z = 0.15F + static_cast<float>(i) * 0.17F;
        bar(x - 0.5F * Width + 0.05F, z);
        bar(x + 0.5F * Width - 0.05F, z);
    }
    const float low = floor + 0.95F;
    trim.box({x - 0.5F * Width, low, Deep - 0.09F}, {x + 0.5F * Width, low + 0.06F, Deep});
    for (const float side : {-1.0F, 1.0F})
        trim.boxOn({x + side * (0.5F * Width - 0.04F), low, 0.5F * (Deep - 0.09F)}, 0.08F, 0.06F,
                   Deep - 0.09F);
}

void addDoor(MeshBuilder& trim, MeshBuilder& glass, float x) {
    glass.boxOn({x, 0.3F, 0.0F}, 1.1F, 2.2F, 0.05F);
    trim.boxOn({x, 0.0F, 0.4F}, 1.8F, 0.15F, 0.8F);
    trim.boxOn({x, 0.15F, 0.25F}, 1.5F, 0.15F, 0.5F);
    for (const float side : {-1.0F, 1.0F})
        trim.boxOn({x + side * 0.63F, 0.3F, 0.0F}, 0.16F, 2.2F, 0.24F);
    trim.boxOn({x, 2.5F, 0.3F}, 1.7F, 0.14F, 0.9F);
}

/// A gable roof over x in +-half, with a closed gable; the ridge runs along z.
void addRoof(MeshBuilder& walls, MeshBuilder& roof, float half, float eaves, float back,
             float front) {
    const float rise = 0.85F * half;
    const std::array gable{Ogre::Vector2(-half, eaves), Ogre::Vector2(half, eaves),
                           Ogre::Vector2(0.0F, eaves + rise)};
    walls.prism(gable, back, front);
    constexpr float Over = 0.45F;  // beyond walls, along the slope and along the ridge
    constexpr float Thick = 0.22F; // measured upwards
    const float slope = rise / half;
    for (const float side : {-1.0F, 1.0F}) {
        const float edge = half + Over;
        const float low = eaves - slope * Over;
        std::array slab{Ogre::Vector2(0.0F, eaves + rise), Ogre::Vector2(side * edge, low),
                        Ogre::Vector2(side * edge, low + Thick),
                        Ogre::Vector2(0.0F, eaves + rise + Thick)};
        if (side < 0.0F) std::reverse(slab.begin(), slab.end());
        roof.prism(slab, back - Over, front + Over);
    }
}

HouseMeshes makeHouse(const std::string& name, const HouseShape& shape) {
    MeshBuilder walls;
    MeshBuilder roof;
    MeshBuilder trim;
    MeshBuilder glass;
    const float half = 0.5F * shape.width;
    const float eaves = Storey * static_cast<float>(shape.storeys) + 0.5F;
    walls.box({-half, 0.0F, -shape.depth}, {half, eaves, 0.0F});
    trim.box({-half - 0.06F, 0.0F, -shape.depth - 0.06F}, {half + 0.06F, 0.45F, 0.06F});
    trim.box({-half - 0.1F, eaves - 0.25F, -0.05F}, {half + 0.1F, eaves, 0.12F});

    if (shape.gableToStreet) {
        addRoof(walls, roof, half, eaves, -shape.depth, 0.0F);
    } else {
        const Ogre::Affine3 turn(Vector3(0.0F, 0.0F, -0.5F * shape.depth),
                                 Ogre::Quaternion(Ogre::Degree(90.0F), Vector3::UNIT_Y));
        walls.transform = roof.transform = turn;
        addRoof(walls, roof, 0.5F * shape.depth, eaves, -half, half);
        walls.transform = roof.transform = Ogre::Affine3::IDENTITY;
    }
    const float ridge = eaves + 0.85F * (shape.gableToStreet ? half : 0.5F * shape.depth);
    walls.boxOn({0.5F * half, eaves, -0.6F * shape.depth}, 0.8F, ridge - eaves + 0.9F, 0.6F);
    trim.boxOn({0.5F * half, ridge + 0.9F, -0.6F * shape.depth}, 1.0F, 0.15F, 0.8F);

    const float pitch = shape.width / static_cast<float>(shape.windows);
    const int door = shape.windows / 2;
    for (int storey = 0; storey < shape.storeys; ++storey) {
        for (int i = 0; i < shape.windows; ++i) {
            const float x = (static_cast<float>(i) + 0.5F) * pitch - half;
            if (storey == 0 && i == door)
                addDoor(trim, glass, x);
            else
                addWindow(trim, glass, x, Storey * static_cast<float>(storey) + 1.2F);
            if (shape.balconies && storey > 0 && i % 2 == storey % 2)
                addBalcony(trim, x, Storey * static_cast<float>(storey) + 0.75F);
        }
    }
    return {shape.width, walls.build(name + "/walls"), roof.build(name + "/roof"),
            trim.build(name + "/trim"), glass.build(name + "/glass")};
}

std::vector<HouseMeshes> makeHouses() {
    return {makeHouse(StreetPath + "cottage", {9.0F, 8.0F, 2, 3, false, true}),
            makeHouse(StreetPath + "townhouse", {11.0F, 10.0F, 3, 4, true, false}),
            makeHouse(StreetPath + "corner", {8.0F, 9.0F, 3, 3, false, false}),
            makeHouse(StreetPath + "inn", {13.0F, 10.0F, 2, 5, true, false}),
            makeHouse(StreetPath + "narrow", {6.5F, 9.0F, 3, 2, true, true})};
}

Ogre::MeshPtr makeLampPost() {
    MeshBuilder mesh;
    mesh.lathe(std::vector<ProfilePoint>{{0.0F, 0.0F},
                                         {0.18F, 0.0F},
                                         {0.18F, 0.25F},
                                         {0.09F, 0.5F},
                                         {0.07F, 0.9F},
                                         {0.05F, 3.7F},
                                         {0.11F, 3.78F},
                                         {0.11F, 3.84F},
                                         {0.0F, 3.84F}},
               14);
    mesh.boxOn({0.0F, 3.6F, 0.0F}, 0.9F, 0.05F, 0.05F);
    mesh.lathe(std::vector<ProfilePoint>{{0.0F, 3.84F},
                                         {0.13F, 3.84F},
                                         {0.22F, 4.35F},
                                         {0.26F, 4.37F},
                                         {0.05F, 4.6F},
                                         {0.0F, 4.75F}},
               14);
    return mesh.build(StreetPath + "lamp-post");
}

Ogre::MeshPtr makeBench() {
    MeshBuilder mesh;
    for (int i = 0; i < 4; ++i)
        mesh.boxOn({0.0F, 0.44F, 0.13F * static_cast<float>(i) - 0.2F}, 1.7F, 0.04F, 0.1F);
    for (int i = 0; i < 3; ++i)
        mesh.boxOn({0.0F, 0.6F + 0.14F * static_cast<float>(i), -0.28F}, 1.7F, 0.09F, 0.04F);
    for (const float x : {-0.7F, 0.7F}) {
        mesh.boxOn({x, 0.0F, 0.15F}, 0.07F, 0.44F, 0.07F);
        mesh.boxOn({x, 0.0F, -0.28F}, 0.07F, 0.97F, 0.05F);
        mesh.boxOn({x, 0.4F, -0.06F}, 0.06F, 0.04F, 0.5F);
    }
    return mesh.build(StreetPath + "bench");
}

/// A low wall along the street, and trees and benches behind it.
void buildPark(Ogre::SceneManager& sceneManager) {
    const auto stone = makeSurface(StreetPath + "stone", ColourValue(0.78F, 0.74F, 0.66F));
    const auto bark = makeSurface(StreetPath + "park-bark", ColourValue(0.44F, 0.36F, 0.29F));
    const auto leaves = makeSurface(StreetPath + "park-leaves", ColourValue(0.56F, 0.60F, 0.33F));
    const auto needles = makeSurface(StreetPath + "park-needles", ColourValue(0.36F, 0.50F, 0.40F));
    const auto lawn = makeSurface(StreetPath + "lawn", ColourValue(0.58F, 0.66F, 0.42F),
                                  patternTexture(Pattern::Grain));
    const float x = -(HalfStreet + Sidewalk);
    MeshBuilder grass;
    grass.box({x - 40.0F, 0.0F, ParkBack}, {x, 0.12F, ParkFront});
    place(sceneManager, grass.build(StreetPath + "lawn"), lawn);

    MeshBuilder wall;
    for (int i = 0; i < static_cast<int>((ParkFront - ParkBack) / 5.0F); ++i) {
        const float z = ParkBack + 1.0F + 5.0F * static_cast<float>(i);
        wall.boxOn({x - 0.3F, 0.0F, z + 2.5F}, 0.3F, 0.8F, 4.6F);
        wall.boxOn({x - 0.3F, 0.8F, z + 2.5F}, 0.42F, 0.1F, 4.6F);
        wall.boxOn({x - 0.3F, 0.0F, z}, 0.5F, 1.2F, 0.5F);
    }
    place(sceneManager, wall.build(StreetPath + "park-wall"), stone);

    const TwoMeshes broad = broadleaf(StreetPath + "park-broadleaf", 8.0F, 21);
    const TwoMeshes conifer = spruce(StreetPath + "park-spruce", 9.5F);
    Random random(17);
    for (int i = 0; i < 14; ++i) {
        const Placement placement{
            {x - random.between(4.0F, 26.0F), 0.1F, ParkBack + 4.0F + 5.2F * static_cast<float>(i)},
            random.between(0.0F, 360.0F),
            random.between(0.75F, 1.15F)};
        const bool isConifer = i % 4 == 2;
        place(sceneManager, isConifer ? conifer : broad, bark, isConifer ? needles : leaves,
              placement);
    }
}

/// Both rows of houses, side by side, in turns of shape and colour.
void buildHouses(Ogre::SceneManager& sceneManager) {
    const std::array tones{ColourValue(0.80F, 0.66F, 0.48F), ColourValue(0.74F, 0.52F, 0.43F),
                           ColourValue(0.82F, 0.78F, 0.68F), ColourValue(0.58F, 0.64F, 0.63F),
                           ColourValue(0.70F, 0.68F, 0.52F)};
    std::vector<Ogre::MaterialPtr> plaster;
    plaster.reserve(tones.size());
    for (const ColourValue& tone : tones)
        plaster.push_back(makeSurface(StreetPath + "plaster" + std::to_string(plaster.size()), tone,
                                      patternTexture(Pattern::Grain)));
    const auto tiles = makeSurface(StreetPath + "tiles", ColourValue(0.58F, 0.35F, 0.29F));
    const auto slate = makeSurface(StreetPath + "slate", ColourValue(0.40F, 0.43F, 0.47F));
    const auto trim = makeSurface(StreetPath + "trim", ColourValue(0.86F, 0.83F, 0.76F));
    const auto glass = makeSurface(StreetPath + "glass", ColourValue(0.24F, 0.31F, 0.37F));
    const std::vector<HouseMeshes> houses = makeHouses();
    Random random(31);
    for (const float side : {-1.0F, 1.0F}) {
        float z = -HalfStreetLength;
        for (int i = 0; z < HalfStreetLength - 6.0F; ++i) {
            const HouseMeshes& house =
                houses[static_cast<std::size_t>(2 * i + (side > 0.0F ? 1 : 0)) % houses.size()];
            const bool inPark = z + house.width > ParkBack && z < ParkFront;
            if (side < 0.0F && inPark) {
                z = ParkFront + 1.0F;
                continue;
            }
            z += 0.5F * house.width;
            // The front faces the street: +z turned to -side x.
            const Placement placement{
                {side * (HalfStreet + Sidewalk), 0.0F, z}, -90.0F * side, 1.0F};
            const auto tone =
                static_cast<std::size_t>(random.below(static_cast<int>(plaster.size())));
            place(sceneManager, house.walls, plaster[tone], placement);
            place(sceneManager, house.roof, random.below(3) == 0 ? slate : tiles, placement);
            place(sceneManager, house.trim, trim, placement);
            place(sceneManager, house.glass, glass, placement);
            // An alley now and then lets the low sun through.
            z += 0.5F * house.width + (i % 3 == 1 ? 5.0F : 1.2F);
        }
    }
}

void buildStreet(Ogre::SceneManager& sceneManager) {
    placeGround(sceneManager, StreetPath + "ground", 130.0F,
                makeSurface(StreetPath + "road", ColourValue(0.62F, 0.61F, 0.60F),
                            patternTexture(Pattern::Grain)));
    const auto paving = makeSurface(StreetPath + "paving", ColourValue(0.74F, 0.71F, 0.66F),
                                    patternTexture(Pattern::Paving));
    MeshBuilder sidewalks;
    for (const float side : {-1.0F, 1.0F})
        sidewalks.boxOn({side * (HalfStreet + 0.5F * Sidewalk), 0.0F, 0.0F}, Sidewalk, Kerb,
                        2.0F * HalfStreetLength);
    place(sceneManager, sidewalks.build(StreetPath + "sidewalks"), paving);

    const auto iron = makeSurface(StreetPath + "iron", ColourValue(0.30F, 0.36F, 0.34F));
    const auto wood = makeSurface(StreetPath + "wood", ColourValue(0.58F, 0.42F, 0.28F));
    const auto bark = makeSurface(StreetPath + "bark", ColourValue(0.42F, 0.35F, 0.29F));
    const auto leaves = makeSurface(StreetPath + "leaves", ColourValue(0.47F, 0.58F, 0.34F));
    const Ogre::MeshPtr lampPost = makeLampPost();
    const Ogre::MeshPtr bench = makeBench();
    const TwoMeshes tree = broadleaf(StreetPath + "tree", 6.5F, 9);
    MeshBuilder bollard;
    bollard.cylinder(0.09F, 0.0F, 0.75F, 12);
    bollard.sphere({0.0F, 0.8F, 0.0F}, 0.12F, 12);
    const Ogre::MeshPtr bollardMesh = bollard.build(StreetPath + "bollard");
    Random random(8);
    for (const float side : {-1.0F, 1.0F}) {
        const float x = side * (HalfStreet + 0.45F);
        for (int i = -6; i <= 6; ++i) {
            const float z = 12.0F * static_cast<float>(i) + (side > 0.0F ? 6.0F : 0.0F);
            place(sceneManager, lampPost, iron, {{x, Kerb, z}, 90.0F, 1.0F});
            const bool byPark = side < 0.0F && z > ParkBack && z < ParkFront;
            if (!byPark)
                place(sceneManager, tree, bark, leaves,
                      {{x, Kerb, z + 4.0F},
                       random.between(0.0F, 360.0F),
                       random.between(0.7F, 1.0F)});
            if (i % 2 == 0)
                place(sceneManager, bench, wood,
                      {{x + side * 0.4F, Kerb, z - 3.0F}, 90.0F * side, 1.0F});
            for (int k = 0; k < 3; ++k)
                place(sceneManager, bollardMesh, iron,
                      {{side * (HalfStreet + 0.25F), Kerb, z + 6.5F + 1.3F * static_cast<float>(k)},
                       0.0F,
                       1.0F});
        }
    }
}

void buildScene(Ogre::SceneManager& sceneManager) {
    buildStreet(sceneManager);
    buildPark(sceneManager);
    buildHouses(sceneManager);
}

} // namespace

SampleScene streetScene() {
    SampleScene scene;
    scene.name = "street";
    scene.title = "Street: houses, lamp posts and trees when the sun is low";
    scene.build = buildScene;
    scene.views = {
        {"down-the-street", {-2.6F, 1.7F, 44.0F}, {3.0F, 2.6F, 0.0F}, 0.2F, 250.0F, 58.0F, {}},
        {"from-above", {-19.0F, 15.0F, 47.0F}, {4.0F, 0.5F, 2.0F}, 0.5F, 250.0F, 50.0F, {}},
        {"along-a-facade", {6.6F, 1.8F, 30.0F}, {7.8F, 4.0F, 4.0F}, 0.2F, 250.0F, 65.0F, {}},
        {"in-the-park", {-26.0F, 1.6F, 36.0F}, {-14.0F, 1.4F, 0.0F}, 0.2F, 250.0F, 60.0F, {}},
        {"from-a-roof", {13.0F, 19.0F, -40.0F}, {-6.0F, 0.0F, 6.0F}, 0.5F, 250.0F, 60.0F, {}},
        {"at-a-bench", {4.2F, 1.3F, 21.0F}, {7.0F, 0.5F, 15.5F}, 0.1F, 250.0F, 60.0F, {}},
    };
    scene.lights = {sunlight("evening", 256.0F, 12.0F), sunlight("against", 187.0F, 12.0F),
                    sunlight("from-behind", 320.0F, 14.0F), sunlight("across", 95.0F, 30.0F),
                    sunlight("noon", 140.0F, 62.0F)};
    scene.shadowDistance = 180.0F;
    return scene;
}

} // namespace Lixel::Samples
