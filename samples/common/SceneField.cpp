#include "common/SceneList.h"
#include "common/ScenePieces.h"

#include <array>

namespace Lixel::Samples {
namespace {

using Ogre::ColourValue;
using Ogre::Vector3;

constexpr float HalfSide = 200.0F; ///< of the ground
constexpr int Rows = 20;           ///< of objects, and as many columns: about 400

const std::array Views{
    SampleView{
        "head-height", {129.0F, 1.8F, 175.0F}, {105.0F, 1.6F, 120.0F}, 1.0F, 500.0F, 50.0F, {}},
    SampleView{
        "from-above", {-130.0F, 70.0F, 165.0F}, {-5.0F, 0.0F, 10.0F}, 1.0F, 500.0F, 45.0F, {}},
    SampleView{"in-the-middle", {18.0F, 2.0F, 65.0F}, {39.0F, 1.0F, 9.0F}, 1.0F, 500.0F, 60.0F, {}},
    SampleView{"in-the-grass", {22.0F, 0.5F, 63.0F}, {33.0F, 0.9F, 50.0F}, 0.2F, 500.0F, 70.0F, {}},
    SampleView{
        "down-from-a-mast", {40.0F, 38.0F, -22.0F}, {28.0F, 0.0F, -58.0F}, 1.0F, 500.0F, 50.0F, {}},
    SampleView{"through-a-telescope",
               {-195.0F, 45.0F, 190.0F},
               {40.0F, 0.0F, -50.0F},
               2.0F,
               600.0F,
               18.0F,
               {}},
};

/// A lying torus raised to stand on its rim.
Ogre::MeshPtr ring(const std::string& name, float radius, float tube) {
    MeshBuilder mesh;
    mesh.transform = Ogre::Affine3(Vector3(0.0F, radius + tube, 0.0F),
                                   Ogre::Quaternion(Ogre::Degree(90.0F), Vector3::UNIT_X));
    mesh.torus(radius, tube);
    return mesh.build(name);
}

Ogre::MeshPtr steps(const std::string& name) {
    MeshBuilder mesh;
    for (int i = 0; i < 4; ++i) {
        const float side = 4.0F - static_cast<float>(i);
        mesh.boxOn({0.0F, 0.7F * static_cast<float>(i), 0.0F}, side, 0.7F, side);
    }
    return mesh.build(name);
}

template <typename Shape>
Ogre::MeshPtr meshOf(const std::string& name, const Shape& shape) {
    MeshBuilder mesh;
    shape(mesh);
    return mesh.build(name);
}

/// One of each kind, standing on y = 0, a few units wide.
std::vector<Ogre::MeshPtr> kinds() {
    const std::string base = "Lixel/Samples/field/";
    return {
        meshOf(base + "block", [](MeshBuilder& m) { m.boxOn(Vector3::ZERO, 3.2F, 3.2F, 3.2F); }),
        meshOf(base + "slab", [](MeshBuilder& m) { m.boxOn(Vector3::ZERO, 5.0F, 4.0F, 0.8F); }),
        meshOf(base + "tower", [](MeshBuilder& m) { m.boxOn(Vector3::ZERO, 2.0F, 11.0F, 2.0F); }),
        meshOf(base + "column", [](MeshBuilder& m) { addColumn(m, 0.8F, 8.0F); }),
        meshOf(base + "post", [](MeshBuilder& m) { m.cylinder(0.22F, 0.0F, 7.0F, 12); }),
        meshOf(base + "ball",
               [](MeshBuilder& m) {
                   m.sphere({0.0F, 1.9F, 0.0F}, 2.0F, 28);
               }),
        meshOf(base + "cone", [](MeshBuilder& m) { m.cone(1.9F, 0.0F, 5.0F); }),
        meshOf(base + "pyramid", [](MeshBuilder& m) { m.cone(2.6F, 0.0F, 3.6F, 4); }),
        meshOf(base + "arch", [](MeshBuilder& m) { m.arch(3.2F, 2.6F, 0.8F, 1.4F); }),
        meshOf(base + "tyre",
               [](MeshBuilder& m) {
                   m.transform.setTrans(Vector3(0.0F, 0.55F, 0.0F));
                   m.torus(1.6F, 0.55F);
               }),
        ring(base + "ring", 2.0F, 0.45F),
        steps(base + "steps"),
    };
}

std::vector<Ogre::MaterialPtr> colours() {
    const std::array palette{ColourValue(0.78F, 0.42F, 0.33F), ColourValue(0.85F, 0.68F, 0.38F),
                             ColourValue(0.45F, 0.58F, 0.66F), ColourValue(0.56F, 0.66F, 0.46F),
                             ColourValue(0.82F, 0.79F, 0.71F), ColourValue(0.58F, 0.48F, 0.60F),
                             ColourValue(0.38F, 0.55F, 0.52F)};
    std::vector<Ogre::MaterialPtr> materials;
    materials.reserve(palette.size());
    for (const ColourValue& colour : palette)
        materials.push_back(
            makeSurface("Lixel/Samples/field/colour" + std::to_string(materials.size()), colour));
    return materials;
}

void buildField(Ogre::SceneManager& sceneManager) {
    placeGround(sceneManager, "Lixel/Samples/field/ground", HalfSide,
                makeSurface("Lixel/Samples/field/ground", ColourValue(0.67F, 0.70F, 0.56F),
                            patternTexture(Pattern::Grain)));
    const std::vector<Ogre::MeshPtr> meshes = kinds();
    const std::vector<Ogre::MaterialPtr> materials = colours();
    Random random(20);
    constexpr float Cell = 2.0F * (HalfSide - 6.0F) / Rows;
    for (int row = 0; row < Rows; ++row) {
        for (int column = 0; column < Rows; ++column) {
            const auto place1 = [&](int i) {
                return Cell * (static_cast<float>(i) + random.between(0.2F, 0.8F)) - HalfSide +
                       6.0F;
            };
            Placement placement;
            placement.position.x = place1(column);
            placement.position.z = place1(row);
            placement.yawDegrees = random.between(0.0F, 360.0F);
            placement.scale = random.between(1.1F, 2.5F);
            const auto mesh =
                static_cast<std::size_t>(random.below(static_cast<int>(meshes.size())));
            const auto colour =
                static_cast<std::size_t>(random.below(static_cast<int>(materials.size())));
            place(sceneManager, meshes[mesh], materials[colour], placement);
        }
    }
}

} // namespace

SampleScene fieldScene() {
    SampleScene scene;
    scene.name = "field";
    scene.title = "Field: some 400 things on a wide plane, seen at head height and from above";
    scene.build = buildField;
    scene.views.assign(Views.begin(), Views.end());
    scene.lights = {sunlight("afternoon", 60.0F, 35.0F),
                    sunlight("low-from-the-side", 95.0F, 14.0F),
                    sunlight("from-behind", 10.0F, 40.0F), sunlight("against", 178.0F, 25.0F),
                    sunlight("noon", 200.0F, 84.0F)};
    scene.shadowDistance = 450.0F;
    return scene;
}

} // namespace Lixel::Samples
