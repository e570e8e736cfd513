// What happens to cameras, viewports and windows.

#include "ViewDeeds.h"

namespace Lixel::Tests {
namespace {

constexpr std::size_t MostCameras = 3;
constexpr std::size_t MostScreens = 3;

std::string create(Application& application, World& world, Random& random) {
    if (world.cameras.size() == MostCameras) return {};
    Ogre::Camera& camera = application.addCamera(world);
    camera.getParentSceneNode()->setPosition(anyPlace(random, 10, 1, 10));
    return camera.getName();
}

std::string destroy(Application& application, World& world, Random& random) {
    Ogre::Camera** const camera = anyOf(world.cameras, random);
    if (camera == nullptr || world.cameras.size() < 2) return {};
    std::string name = (*camera)->getName();
    application.removeCamera(world, *camera);
    return name;
}

std::string move(Application&, World& world, Random& random) {
    Ogre::Camera** const found = anyOf(world.cameras, random);
    if (found == nullptr) return {};
    Ogre::Camera& camera = **found;
    if (camera.getParentNode() == nullptr)
        world.manager->getRootSceneNode()->createChildSceneNode()->attachObject(&camera);
    const Ogre::Vector3 eye = anyPlace(random, 13, 1, 12);
    const Ogre::Vector3 aim =
        random.oneIn(8) ? Ogre::Vector3(0, -1, 0) : anyPlace(random, 3, 0, 2) - eye;
    camera.getParentSceneNode()->setPosition(eye);
    camera.getParentSceneNode()->setDirection(aim, Ogre::Node::TS_WORLD);
    return camera.getName() + " to " + text(eye) + " towards " + text(aim);
}

std::string project(Application&, World& world, Random& random) {
    Ogre::Camera** const found = anyOf(world.cameras, random);
    if (found == nullptr) return {};
    Ogre::Camera& camera = **found;
    camera.setCustomProjectionMatrix(false);
    camera.setProjectionType(Ogre::PT_PERSPECTIVE);
    camera.setFOVy(Ogre::Degree(45));
    camera.setNearClipDistance(0.1F);
    camera.setFarClipDistance(200);
    camera.setFrustumOffset(0, 0);
    switch (random.below(8)) {
    case 0:
        camera.setFOVy(Ogre::Degree(random.of({2.0F, 90.0F, 140.0F})));
        return camera.getName() + " field of view";
    case 1:
        camera.setFarClipDistance(0);
        return camera.getName() + " without end";
    case 2:
        camera.setNearClipDistance(random.of({1e-4F, 5.0F, 20.0F}));
        return camera.getName() + " near plane";
    case 3:
        camera.setProjectionType(Ogre::PT_ORTHOGRAPHIC);
        camera.setOrthoWindow(random.of({3.0F, 20.0F}), random.of({3.0F, 20.0F}));
        return camera.getName() + " orthographic";
    case 4: {
        Ogre::Matrix4 matrix = camera.getProjectionMatrix();
        matrix[0][1] += random.between(-0.2F, 0.2F);
        matrix[1][2] += random.between(-0.3F, 0.3F);
        camera.setCustomProjectionMatrix(true, matrix);
        return camera.getName() + " custom projection";
    }
    case 5:
        camera.setFrustumOffset(random.between(-0.5F, 0.5F), random.between(-0.5F, 0.5F));
        return camera.getName() + " off axis";
    case 6:
        if (camera.isReflected())
            camera.disableReflection();
        else
            camera.enableReflection(Ogre::Plane(Ogre::Vector3::UNIT_Y, random.of({0.0F, 2.0F})));
        return camera.getName() + " reflected or not";
    default:
        return camera.getName() + " plain";
    }
}

std::string carry(Application&, World& world, Random& random) {
    Ogre::Camera** const camera = anyOf(world.cameras, random);
    Ogre::Entity* const body = anyBody(world, random);
    if (camera == nullptr || body == nullptr || body->getParentNode() == nullptr) return {};
    (*camera)->detachFromParent();
    body->getParentSceneNode()->attachObject(*camera);
    return (*camera)->getName() + " by " + body->getName();
}

std::string show(Application& application, World&, Random& random) {
    Screen& screen = application.screens[random.below(application.screens.size())];
    std::vector<Ogre::Camera*> cameras;
    std::string names;
    for (std::size_t i = 1 + random.below(3); i > 0; --i) {
        World& world = *application.worlds[random.below(application.worlds.size())];
        if (Ogre::Camera** const camera = anyOf(world.cameras, random)) {
            cameras.push_back(*camera);
            names += " " + (*camera)->getName();
        }
    }
    application.show(screen, cameras);
    return screen.target->getName() + " shows" + names;
}

std::string setViewport(Application& application, World&, Random& random) {
    Screen& screen = application.screens[random.below(application.screens.size())];
    const unsigned short count = screen.target->getNumViewports();
    if (count == 0) return {};
    Ogre::Viewport& viewport =
        *screen.target->getViewport(static_cast<unsigned short>(random.below(count)));
    if (random.oneIn(2)) {
        viewport.setShadowsEnabled(!random.oneIn(4));
        return "shadows or not";
    }
    viewport.setVisibilityMask(random.of({1U, 3U, 0xFFFFFFFFU, 0xFFFFFFFFU, 0xFFFFFFFFU}));
    return "visibility mask";
}

std::string changeTextures(Application& application, World&, Random& random) {
    if (application.screens.size() > 1 && random.oneIn(2)) {
        application.removeTexture(1 + random.below(application.screens.size() - 1));
        return "one less";
    }
    if (application.screens.size() == MostScreens) return {};
    application.addTexture();
    World& world = *application.worlds[random.below(application.worlds.size())];
    if (Ogre::Camera** const camera = anyOf(world.cameras, random))
        application.show(application.screens.back(), {*camera});
    return "one more";
}

std::string resize(Application& application, World&, Random& random) {
    const unsigned width = random.of({97U, 160U, 192U, 256U});
    const unsigned height = random.of({64U, 96U, 111U});
#if OGRE_VERSION_MAJOR >= 13
    // Without a display the window may be EGL's, and cannot grow.
    Ogre::RenderWindow& window = application.stage().window();
    if (width > window.getWidth() || height > window.getHeight()) return {};
#endif
    application.stage().window().resize(width, height);
    return std::to_string(width) + " x " + std::to_string(height);
}

} // namespace

const std::vector<Deed>& viewDeeds() {
    static const std::vector<Deed> deeds{
        {"create camera", 3, create}, {"destroy camera", 2, destroy},
        {"move camera", 14, move},    {"projection", 5, project},
        {"carry camera", 1, carry},   {"viewports", 4, show},
        {"viewport", 2, setViewport}, {"render textures", 2, changeTextures},
        {"resize window", 1, resize},
    };
    return deeds;
}

} // namespace Lixel::Tests
