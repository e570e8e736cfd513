#include "HardCases.h"

namespace Lixel::Tests {
namespace {

void field(HardScene& scene) {
    scene.addField();
}

void turn(HardScene& scene, float degrees) {
    scene.viewer().getParentSceneNode()->yaw(Ogre::Degree(degrees), Ogre::Node::TS_WORLD);
}

/// A perspective whose axis is beside the picture's middle, by those multiples of its half size.
void offAxis(HardScene& scene, float right, float up) {
    Ogre::Matrix4 projection = scene.viewer().getProjectionMatrix();
    projection[0][2] = right;
    projection[1][2] = up;
    scene.viewer().setCustomProjectionMatrix(true, projection);
}

/// Two viewers take turns, from opposite sides.
void takeTurns(HardScene& scene, int frame) {
    Ogre::SceneManager& manager = scene.manager();
    if (!manager.hasCamera("Second")) {
        Ogre::Camera* const second = manager.createCamera("Second");
        second->setAspectRatio(scene.viewer().getAspectRatio());
        manager.getRootSceneNode()->createChildSceneNode()->attachObject(second);
        Ogre::Camera* const first = scene.stage.viewport().getCamera();
        scene.stage.viewport().setCamera(second);
        scene.setPlanes(0.1F, 1000);
        scene.look({-5, 5, -40}, {0, 0, -10});
        scene.stage.viewport().setCamera(first);
    }
    scene.stage.viewport().setCamera(manager.getCamera(frame % 2 == 0 ? "Viewer" : "Second"));
}

} // namespace

std::vector<HardCase> viewCases() {
    std::vector<HardCase> cases;
    const auto add = [&](const char* name, const std::function<void(HardScene&)>& build) {
        cases.push_back({.name = name, .build = build});
        return &cases.back();
    };
    add("plain", field);
    add("cold start", field)->settle = 0;
    add("camera turned 180 degrees in one frame", field)->change = [](HardScene& s) {
        turn(s, 180);
    };
    add("camera turned 90 degrees in one frame", field)->change = [](HardScene& s) { turn(s, 90); };
    add("camera moved 50 units in one frame", field)->change = [](HardScene& s) {
        s.look({-50, 8, -20}, {-20, 0, -20});
    };
    add("two cameras take turns", field)->eachFrame = takeTurns;
    add("near 1e-4, far 1e6", [](HardScene& s) {
        s.setPlanes(1e-4F, 1e6F);
        s.addField();
    });
    add("infinite far plane", [](HardScene& s) {
        s.setPlanes(0.1F, 0);
        s.addField();
    });
    add("infinite far plane, near 1e-4", [](HardScene& s) {
        s.setPlanes(1e-4F, 0);
        s.addField();
    });
    add("receivers beyond the far plane", [](HardScene& s) {
        s.setPlanes(0.1F, 25);
        s.addField();
    });
    add("off-axis custom projection", [](HardScene& s) {
        offAxis(s, 0.8F, -0.5F);
        s.addField();
    });
    add("axis outside of the picture", [](HardScene& s) {
        offAxis(s, 2.0F, 0.0F);
        s.addField();
    });
    add("oblique near plane", [](HardScene& s) {
        s.viewer().enableCustomNearClipPlane(Ogre::Plane(Ogre::Vector3(0, 0.3F, -1), 8.0F));
        s.addField();
    });
    add("orthographic viewer", [](HardScene& s) {
        s.viewer().setProjectionType(Ogre::PT_ORTHOGRAPHIC);
        s.viewer().setOrthoWindow(40, 30);
        s.addField();
    });
    add("reflected camera", [](HardScene& s) {
        s.viewer().enableReflection(Ogre::Plane(Ogre::Vector3::UNIT_X, 20.0F));
        s.addField();
    });
    add("camera looks straight down", [](HardScene& s) {
        s.look({0, 30, 0}, {0, 0, 0});
        s.addField();
    });
    add("camera looks straight up at a ceiling", [](HardScene& s) {
        s.addBox({0, 20, 0}, {40, 1, 40}, false);
        s.addBox({2, 10, 1}, {2, 2, 2});
        s.look({0, 1, 0}, {0, 20, 0});
        s.sun({-0.5F, 1, 0.2F});
    });
    add("camera rolled by 90 degrees", [](HardScene& s) {
        s.viewer().getParentSceneNode()->roll(Ogre::Degree(90));
        s.addField();
    });
    add("level camera near the ground", [](HardScene& s) {
        s.look({0, 0.3F, 16}, {0, 0.3F, 0});
        s.addField();
    });
    add("telescope of half a degree", [](HardScene& s) {
        s.viewer().setFOVy(Ogre::Degree(0.5F));
        s.look({0, 40, 400}, {-1, 0.5F, 3});
        s.setReach(500);
        s.addField();
    });
    add("field of view of 170 degrees", [](HardScene& s) {
        s.viewer().setFOVy(Ogre::Degree(170));
        s.addField();
    });
    add("shadow distance 0", [](HardScene& s) {
        s.setReach(0);
        s.addField();
    });
    add("shadow distance 1e-3", [](HardScene& s) {
        s.setReach(1e-3F);
        s.addField();
    })->nothingShadowed = true;
    add("shadow distance just beyond the nearest shadow", [](HardScene& s) {
        s.setReach(15);
        s.addField();
    });
    add("shadow distance 1e6", [](HardScene& s) {
        s.setReach(1e6F);
        s.addField();
    });
    return cases;
}

} // namespace Lixel::Tests
