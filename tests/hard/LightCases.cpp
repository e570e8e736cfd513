#include "HardCases.h"

#include <Lixel/scene/OgreVersions.h>

#include <cmath>
#include <limits>
#include <memory>

namespace Lixel::Tests {
namespace {

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();

/// A sun along the view or against it, turned aside by that angle in radians.
void sunAlongView(HardScene& scene, float sign, float aside) {
    const Ogre::Camera& viewer = scene.viewer();
    scene.sun(sign * viewer.getDerivedDirection() + aside * viewer.getDerivedRight());
}

/// The field, and for suns against the view a slope that they still light.
void addSlope(HardScene& scene) {
    scene.addField();
    Ogre::SceneNode* const slope = scene.addBox({0, 8, -40}, {80, 1, 80}, false);
    slope->pitch(Ogre::Degree(25));
}

std::function<void(HardScene&)> alongView(float sign, float aside) {
    return [=](HardScene& scene) {
        if (sign < 0) scene.look({0, 2, 16}, {0, 3, 0});
        addSlope(scene);
        sunAlongView(scene, sign, aside);
    };
}

std::function<void(HardScene&)> fieldUnderSpot(const Ogre::Vector3& position,
                                               const Ogre::Vector3& target, float outerDegrees) {
    return [=](HardScene& scene) {
        scene.addField();
        scene.spot(position, target, outerDegrees);
    };
}

/** Puts up with a light direction that is no direction, and has a good one again.

    The plugin hides such a light from OGRE, which spares OGRE's own setups too.
*/
HardCase badDirection(const std::string& name, const Ogre::Vector3& direction) {
    HardCase bad;
    bad.name = name;
    bad.build = [](HardScene& scene) { scene.addField(); };
    const auto good = std::make_shared<Ogre::Vector3>();
    bad.change = [=](HardScene& scene) {
        *good = scene.ownDirection();
        scene.setOwnDirection(direction);
    };
    bad.repair = [=](HardScene& scene) { scene.setOwnDirection(*good); };
    return bad;
}

} // namespace

std::vector<HardCase> lightCases() {
    std::vector<HardCase> cases;
    const auto add = [&](const char* name, const std::function<void(HardScene&)>& build) {
        cases.push_back({.name = name, .build = build});
        return &cases.back();
    };
    add("light along the camera's up", [](HardScene& s) {
        s.addField();
        s.sun(-s.viewer().getDerivedUp());
    });
    add("light exactly along the camera's up", [](HardScene& s) {
        s.viewer().getParentSceneNode()->resetOrientation();
        s.addField();
        s.sunExactly({0, -1, 0});
    });
    add("light exactly along the view", [](HardScene& s) {
        s.viewer().getParentSceneNode()->resetOrientation();
        s.addField();
        s.addBox({0, 0, -40}, {80, 40, 1}, false);
        s.addBox({2, 8, 0}, {1, 1, 1});
        s.sunExactly({0, 0, -1});
    });
    add("light exactly against the view", [](HardScene& s) {
        s.viewer().getParentSceneNode()->resetOrientation();
        // A slope that both see, from opposite sides.
        s.addBox({0, -5.5F, -40}, {60, 1, 60}, false)->pitch(Ogre::Degree(-10));
        s.addBox({0, -4, -60}, {3, 1, 2});
        s.sunExactly({0, 0, 1});
    });
    add("light straight down, camera level", [](HardScene& s) {
        s.look({0, 3, 16}, {0, 3, 0});
        s.addField();
        s.sun({0, -1, 0});
    });
    add("light straight down", [](HardScene& s) {
        s.addField();
        s.sun({0, -1, 0});
    });
    add("light and camera straight down", [](HardScene& s) {
        s.look({3, 30, 1}, {3, 0, 1});
        s.addField();
        s.sun({0, -1, 0});
    });
    add("light along the camera's right", [](HardScene& s) {
        s.addField();
        s.viewer().getParentSceneNode()->roll(Ogre::Degree(30));
        s.sun(-s.viewer().getDerivedRight());
    });
    add("light along the view", alongView(1, 0));
    add("light along the view, off by 1e-6", alongView(1, 1e-6F));
    add("light along the view, off by 1e-3", alongView(1, 1e-3F));
    add("light against the view", alongView(-1, 0));
    add("light against the view, off by 1e-6", alongView(-1, 1e-6F));
    add("light against the view, off by 1e-3", alongView(-1, 1e-3F));
    add("caster 2000 units behind, sun at 10 degrees", [](HardScene& s) {
        s.addGround();
        const float slope = std::tan(Ogre::Degree(10).valueRadians());
        s.addBox({0, 2016 * slope, 2016}, {6, 12, 6});
        s.sun({0, -slope, -1});
    });
    add("sun at the horizon over a huge terrain", [](HardScene& s) {
        s.addField();
        s.addGround(5000, 4);
        s.setPlanes(0.1F, 10000);
        s.setReach(5000);
        s.sunAt(60, 4);
    });
    add("sun at 1 degree", [](HardScene& s) {
        s.addField();
        s.sunAt(100, 1);
    });
    add("flat receiver, light in its plane", [](HardScene& s) {
        s.addBox({0, 0, 0}, {100, 0, 100}, false);
        s.addBox({0, 1, 0}, {2, 2, 2});
        s.sunExactly({-1, 0, 0});
    })->nothingShadowed = true;
    add("flat receiver alone, light in its plane", [](HardScene& s) {
        s.addBox({0, 0, 0}, {100, 0, 100});
        s.sunExactly({-1, 0, 0});
    })->nothingShadowed = true;
    if (LightsHaveDirections) { // a node's aborts in OGRE itself
        cases.push_back(badDirection("light direction NaN", Ogre::Vector3(NaN, NaN, NaN)));
        cases.push_back(badDirection("light direction infinite", Ogre::Vector3(Infinity, 0, 0)));
    }
    add("spot 60 degrees", fieldUnderSpot({12, 14, 2}, {0, 0, 0}, 60));
    add("spot 100 degrees", fieldUnderSpot({12, 14, 2}, {0, 0, 0}, 100));
    add("spot 150 degrees", fieldUnderSpot({12, 14, 2}, {0, 0, 0}, 150));
    add("spot 170 degrees", fieldUnderSpot({2, 14, 2}, {0, 0, 0}, 170));
    add("spot 179 degrees", fieldUnderSpot({2, 14, 2}, {0, 0, 0}, 179));
    add("spot inside the view", fieldUnderSpot({1, 5, 0}, {-6, 0, -6}, 80));
    add("spot behind the viewer", fieldUnderSpot({0, 12, 30}, {0, 0, 0}, 60));
    add("spot at the viewer", fieldUnderSpot({0, 8, 16}, {0, 0, 0}, 70))->nothingShadowed = true;
    add("spot beside the viewer", fieldUnderSpot({0.2F, 8, 16}, {0, 0, 0}, 70));
    add("spot against the viewer", fieldUnderSpot({0, 6, -20}, {0, 6, 16}, 100));
    add("spot straight down", fieldUnderSpot({2, 15, 0}, {2, 0, 0}, 90));
    add("spot of half a degree, 1000 away", fieldUnderSpot({600, 800, 0}, {0, 0, 0}, 0.5F));
    add("light inside a caster's box", [](HardScene& s) {
        s.addField();
        s.addBox({8, 12, 0}, {2, 2, 2});
        s.spot({8, 12, 0}, {0, 0, 0}, 90);
    });
    add("light at a caster's side", [](HardScene& s) {
        s.addField();
        s.addBox({8, 12, 0}, {2, 2, 2});
        s.spot({6.9F, 12, 0}, {-5, 0, 0}, 90);
    });
    const auto lamp = [](const Ogre::Vector3& position) {
        return [position](HardScene& s) {
            s.addField();
            s.spot(position, {0, 0, 0}, 90);
            s.light->setType(Ogre::Light::LT_POINT);
        };
    };
    add("point light", lamp({6, 10, 0}));
    add("point light, six maps", lamp({6, 10, 0}))->maps = 6;
    add("point light among the boxes", lamp({4, 2, -1}))->maps = 6;
    add("point light at the viewer", lamp({0.2F, 8, 16}))->maps = 6;
    add("point light on the ground", lamp({4, 0.01F, -1}))->maps = 6;
    add("point light in a corner between faces", lamp({3, 3, 3}))->maps = 6;
    HardCase* const inside = add("point light in a room", [](HardScene& s) {
        s.addField();
        for (const float side : {-1.0F, 1.0F}) {
            s.addBox({side * 30, 10, 0}, {1, 20, 60});
            s.addBox({0, 10, side * 30}, {60, 20, 1});
        }
        s.addBox({0, 20, 0}, {60, 1, 60});
        s.spot({2, 8, 1}, {0, 0, 0}, 90);
        s.light->setType(Ogre::Light::LT_POINT);
    });
    inside->maps = 6;
    add("spot of 220 degrees", fieldUnderSpot({3, 3, 3}, {0, 0, 0}, 220))->maps = 6;
    return cases;
}

} // namespace Lixel::Tests
