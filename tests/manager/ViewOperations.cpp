// Cameras and viewports.
#include "Operation.h"

#include <OgreCamera.h>
#include <OgreViewport.h>

namespace Lixel::Tests {
namespace {

ViewEntry& anyView(World& world, Random& random) {
    return world.views[random.below(world.views.size())];
}

std::string moveCamera(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    view.node->setPosition(anyPlace(random, 20));
    if (random.oneIn(2))
        view.node->lookAt(anyPlace(random, 5), Ogre::Node::TS_WORLD);
    else
        view.node->setOrientation(anyTurn(random));
    return "move " + view.camera->getName();
}

std::string carryCamera(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    NodeEntry& node = anyNode(world, random);
    view.camera->detachFromParent();
    node.node->attachObject(view.camera);
    return node.name + " carries " + view.camera->getName();
}

std::string changeLens(World& world, Random& random) {
    Ogre::Camera& camera = *anyView(world, random).camera;
    switch (random.below(5)) {
    case 0:
        camera.setFOVy(Ogre::Degree(random.of({10.0f, 45.0f, 100.0f})));
        break;
    case 1:
        camera.setFarClipDistance(random.of({0.0f, 15.0f, 60.0f}));
        break;
    case 2:
        camera.setProjectionType(random.oneIn(2) ? Ogre::PT_ORTHOGRAPHIC : Ogre::PT_PERSPECTIVE);
        break;
    case 3:
        camera.setFrustumOffset(random.of({0.0f, 0.3f}), 0);
        break;
    default:
        camera.setAspectRatio(random.of({0.5f, 1.0f, 2.0f}));
    }
    return "lens of " + camera.getName();
}

std::string reflect(World& world, Random& random) {
    Ogre::Camera& camera = *anyView(world, random).camera;
    if (camera.isReflected()) {
        camera.disableReflection();
        return camera.getName() + " reflects no more";
    }
    camera.enableReflection(Ogre::Plane(Ogre::Vector3::UNIT_Y, random.between(-3, 3)));
    return camera.getName() + " reflects";
}

std::string cullByOther(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    ViewEntry& other = anyView(world, random);
    // In a ring they would ask each other for ever.
    const bool has = view.camera->getCullingFrustum() != nullptr;
    if (has || view.camera == other.camera || other.camera->getCullingFrustum() != nullptr) {
        view.camera->setCullingFrustum(nullptr);
        return view.camera->getName() + " culls by itself";
    }
    for (const ViewEntry& each : world.views)
        if (each.camera->getCullingFrustum() == view.camera) return "";
    view.camera->setCullingFrustum(other.camera);
    return view.camera->getName() + " culls by " + other.camera->getName();
}

std::string lodByOther(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    ViewEntry& other = anyView(world, random);
    view.camera->setLodCamera(view.camera == other.camera ? nullptr : other.camera);
    view.camera->setLodBias(random.of({0.5f, 1.0f, 2.0f}));
    return view.camera->getName() + " has levels by " + other.camera->getName();
}

std::string useDistances(World& world, Random& random) {
    Ogre::Camera& camera = *anyView(world, random).camera;
    camera.setUseRenderingDistance(random.oneIn(2));
    camera.setUseMinPixelSize(random.oneIn(2));
    return "distances of " + camera.getName();
}

std::string maskViewport(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    const auto mask = random.of<Ogre::uint32>({0xFFFFFFFF, 0xFFFFFFFF, 1, 6});
    view.viewport->setVisibilityMask(mask);
    return "mask of the viewport of " + view.camera->getName() + " " + std::to_string(mask);
}

std::string setViewport(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    view.viewport->setSkiesEnabled(random.oneIn(2));
    view.viewport->setShadowsEnabled(!random.oneIn(3));
    return "skies and shadows of the viewport of " + view.camera->getName();
}

std::string swapCameras(World& world, Random& random) {
    ViewEntry& view = anyView(world, random);
    ViewEntry& other = anyView(world, random);
    view.viewport->setCamera(other.camera);
    return "viewport of " + view.camera->getName() + " shows " + other.camera->getName();
}

std::string relateToCamera(World& world, Random& random) {
    if (world.hasStaticInstances) return "";
    world.isRelative = random.oneIn(2);
    world.manager().setCameraRelativeRendering(world.isRelative);
    return "camera-relative rendering or not";
}

} // namespace

void addViewOperations(Operations& all) {
    all.insert(all.end(), {{"move a camera", 10, moveCamera},
                           {"carry a camera", 2, carryCamera},
                           {"change a lens", 6, changeLens},
                           {"reflect a view", 2, reflect},
                           {"cull by another camera", 3, cullByOther},
                           {"take levels by another camera", 2, lodByOther},
                           {"use distances", 3, useDistances},
                           {"mask a viewport", 3, maskViewport},
                           {"set a viewport", 3, setViewport},
                           {"swap cameras", 1, swapCameras},
                           {"render relative to the camera", 2, relateToCamera}});
}

} // namespace Lixel::Tests
