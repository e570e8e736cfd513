#include "BenchScene.h"

#include <OgreManualObject.h>
#include <OgreMath.h>
#include <OgreMesh.h>

namespace Lixel::Tests {
namespace {

constexpr unsigned FewestSides = 4;
constexpr unsigned Meshes = 10;

void makePrism(Ogre::SceneManager& manager, const std::string& name, unsigned sides) {
    Ogre::ManualObject* prism = manager.createManualObject();
    prism->begin(flatMaterial(true)->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (unsigned side = 0; side < sides; ++side)
        for (const float height : {0.0f, 1.0f}) {
            const float angle =
                Ogre::Math::TWO_PI * static_cast<float>(side) / static_cast<float>(sides);
            prism->position(0.5f * std::cos(angle), height, 0.5f * std::sin(angle));
        }
    for (unsigned side = 0; side < sides; ++side) {
        const unsigned low = 2 * side;
        const unsigned next = 2 * ((side + 1) % sides);
        prism->quad(low, low + 1, next + 1, next);
        if (side >= 2) {
            prism->triangle(0, low - 2, low);
            prism->triangle(1, low + 1, low - 1);
        }
    }
    prism->end();
    prism->convertToMesh(name, Ogre::RGN_DEFAULT);
    manager.destroyManualObject(prism);
}

} // namespace

const std::vector<std::string>& benchMeshes(Ogre::SceneManager& manager) {
    static const std::vector<std::string> names = [&] {
        std::vector<std::string> made;
        for (unsigned i = 0; i < Meshes; ++i) {
            made.push_back("prism" + std::to_string(i));
            makePrism(manager, made.back(), FewestSides + i);
        }
        return made;
    }();
    return names;
}

} // namespace Lixel::Tests
