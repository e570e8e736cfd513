#include "HardCases.h"

#include "common/Surface.h"

#include <fmt/core.h>

#include <array>

namespace Lixel::Tests {
namespace {

using Build = std::function<void(HardScene&)>;

Build fieldAt(const Ogre::Vector3& origin, bool cameraRelative) {
    return [=](HardScene& scene) {
        scene.origin = origin;
        scene.manager().setCameraRelativeRendering(cameraRelative);
        scene.look({0, 8, 16}, {0, 0, 0});
        scene.addField();
    };
}

Build scaledField(float unit) {
    return [=](HardScene& scene) {
        scene.unit = unit;
        scene.setPlanes(0.1F, 1000);
        scene.setReach(100);
        scene.look({0, 8, 16}, {0, 0, 0});
        scene.addField();
    };
}

void boxOnGround(HardScene& scene) {
    scene.addGround();
    scene.addBox({0, 1, 0}, {2, 2, 2});
}

/// A triangle over the field that claims to be everywhere.
void addBoundless(HardScene& scene) {
    Ogre::ManualObject* const object = scene.manager().createManualObject("Boundless");
    object->begin("HardReceiver", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (const Ogre::Vector3& corner : std::array<Ogre::Vector3, 3>{
             Ogre::Vector3{-1, 5, -1}, Ogre::Vector3{-1, 5, 1}, Ogre::Vector3{1, 5, 1}}) {
        object->position(corner);
        object->normal(Ogre::Vector3::UNIT_Y);
    }
    object->triangle(0, 1, 2);
    object->end();
    object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    scene.manager().getRootSceneNode()->createChildSceneNode()->attachObject(object);
}

/// Two suns that share a setup.
Ogre::Light* addSecondSun(HardScene& scene) {
    scene.manager().setShadowTextureSettings(1024, 2, Ogre::PF_FLOAT32_R);
    Ogre::Light* const second = scene.manager().createLight("Second");
    second->setType(Ogre::Light::LT_DIRECTIONAL);
    Ogre::SceneNode* const node = scene.manager().getRootSceneNode()->createChildSceneNode();
    node->attachObject(second);
    node->setDirection(Ogre::Vector3(0.6F, -1, 0.5F), Ogre::Node::TS_WORLD);
    second->setCustomShadowCameraSetup(scene.light->getCustomShadowCameraSetup());
    return second;
}

} // namespace

std::vector<HardCase> bodyCases() {
    std::vector<HardCase> cases;
    const auto add = [&](const char* name, const Build& build) {
        cases.push_back({.name = name, .build = build});
        return &cases.back();
    };
    add("world offset 1e6", fieldAt({1e6F, 0, 1e6F}, false));
    add("world offset 1e6, camera-relative", fieldAt({1e6F, 0, 1e6F}, true));
    add("world offset 1e7", fieldAt({1e7F, 0, 1e7F}, false));
    add("world offset 1e7, camera-relative", fieldAt({1e7F, 0, 1e7F}, true));
    add("scale 1e-4", scaledField(1e-4F));
    add("scale 1e5", scaledField(1e5F));
    add("scale 1e-12", scaledField(1e-12F));
    add("scale 1e9", scaledField(1e9F));
    add("scale 1e12", scaledField(1e12F));
    // Of which the oracle makes out nothing: what counts is that they are survived.
    add("scale 1e15", scaledField(1e15F))->nothingShadowed = true;
    add("scale 1e18", scaledField(1e18F))->nothingShadowed = true;
    add("scale 1e12, lamp", [](HardScene& s) {
        scaledField(1e12F)(s);
        s.spot({20, 20, 5}, {0, 0, 0}, 60);
        s.light->setAttenuation(1e15F, 1, 0, 0);
    });
    // Its box is next to nothing on it: what counts is that it is survived.
    for (const float side : {5e9F, 5e12F, 5e15F})
        add(fmt::format("ground of {:.0e} units", side).c_str(), [side](HardScene& s) {
            s.addBox({0, -0.5F, 0}, {side, 1, side}, false);
            s.addBox({0, 1, 0}, {2, 2, 2});
        })->nothingShadowed = true;
    for (const float side : {5e9F, 5e12F})
        add(fmt::format("ground of {:.0e} units, half of it in shadow", side).c_str(),
            [side](HardScene& s) {
                s.setPlanes(0.1F, 0);
                s.setReach(0);
                s.addBox({0, -0.5F, 0}, {side, 1, side}, false);
                s.addBox({0, side / 4, 0}, {side / 2, 1, side / 2});
                s.look({0, side / 8, side / 2}, {0, 0, 0});
            });

    HardCase* const empty = add("empty scene", [](HardScene&) {});
    empty->repair = boxOnGround;
    add("no casters", [](HardScene& s) { s.addGround(); })->nothingShadowed = true;
    add("no receivers", [](HardScene& s) {
        s.addBox({0, -1, 0}, {100, 1, 100}, true, false);
        s.addBox({0, 1, 0}, {2, 2, 2}, true, false);
    })->nothingShadowed = true;
    add("one box on the ground", boxOnGround);
    add("one receiver without area: a point", [](HardScene& s) {
        s.addBox({0, 0, 0}, {0, 0, 0}, false);
        s.addBox({2, 2, 0.6F}, {2, 2, 2}, true, false);
    })->nothingShadowed = true;
    add("one receiver without area: a line", [](HardScene& s) {
        s.addBox({0, 0, 0}, {10, 0, 0}, false);
        s.addBox({2, 2, 0.6F}, {2, 2, 2}, true, false);
    })->nothingShadowed = true;
    add("one receiver a thousandth wide", [](HardScene& s) {
        s.addBox({0, 0, 0}, {1e-3F, 1e-3F, 1e-3F}, false);
        s.addBox({2, 2, 0.6F}, {2, 2, 2}, true, false);
        s.look({0, 2e-3F, 2e-3F}, {0, 0, 0});
        s.setPlanes(1e-4F, 10);
    });
    add("caster without area: a point", [](HardScene& s) {
        s.addGround();
        s.addBox({0, 1, 0}, {0, 0, 0});
    })->nothingShadowed = true;
    add("flat caster", [](HardScene& s) {
        s.addGround();
        s.addBox({0, 1, 0}, {2, 0, 2});
    });
    add("caster without bounds", [](HardScene& s) {
        s.addField();
        addBoundless(s);
    });
    HardCase* const boundless = add("caster without bounds, infinite view", boxOnGround);
    boundless->change = [](HardScene& s) {
        addBoundless(s);
        s.setPlanes(0.1F, 0);
        s.setReach(0);
    };
    boundless->repair = [](HardScene& s) {
        s.manager().destroyManualObject("Boundless");
        s.setPlanes(0.1F, 1000);
        s.setReach(100);
    };
    add("one caster far away among many", [](HardScene& s) {
        s.addField();
        s.addBox({2e4F, 2e4F, 6e3F}, {5, 5, 5});
    });
    add("one caster a million units away", [](HardScene& s) {
        s.addField();
        s.addBox({7e5F, 7e5F, 2.1e5F}, {5, 5, 5});
    });
    add("one receiver far away among many", [](HardScene& s) {
        s.addField();
        s.addBox({0, 0, -1e6F}, {100, 100, 100});
        s.setPlanes(0.1F, 0);
        s.setReach(0);
    });
    add("caster over everything", [](HardScene& s) {
        s.addField();
        s.addBox({0, 100, 0}, {1000, 1, 1000});
    });
    add("caster cut by the near plane", [](HardScene& s) {
        s.addField();
        s.addBox({0.5F, 7.7F, 15.8F}, {0.6F, 0.6F, 0.6F});
    });
    add("viewer inside a receiver's box", [](HardScene& s) {
        s.addField();
        s.addBox({0, 8, 16}, {60, 60, 60}, false);
    });
    add("viewer inside a caster's box", [](HardScene& s) {
        s.addField();
        s.addBox({0, 8, 16}, {3, 3, 3});
    });
    add("negative scale", [](HardScene& s) {
        s.addGround();
        s.addBox({0, 1, 0}, {-2, 2, 2});
        s.addBox({4, 1, -3}, {-2, -2, -2});
        s.addBox({-4, 1, -3}, {2, 2, -2})->pitch(Ogre::Degree(30));
    });
    // Their boxes hold much that they do not.
    add("planks aslant", [](HardScene& s) {
        s.addGround();
        for (int i = 0; i < 5; ++i) {
            Ogre::SceneNode* const plank =
                s.addBox({3.0f * static_cast<float>(i) - 6.0f, 2, -4.0f * static_cast<float>(i)},
                         {6, 0.3f, 0.5f});
            plank->yaw(Ogre::Degree(20.0f + 25.0f * static_cast<float>(i)));
            plank->roll(Ogre::Degree(15.0f * static_cast<float>(i)));
        }
    });
    add("a plank aslant, mirrored", [](HardScene& s) {
        s.addGround();
        s.addBox({0, 3, -2}, {-8, 0.2f, 0.2f})
            ->setOrientation(
                Ogre::Quaternion(Ogre::Degree(50), Ogre::Vector3(1, 2, 3).normalisedCopy()));
    });
    add("a wall aslant", [](HardScene& s) {
        s.addGround();
        s.addBox({0, 1, -12}, {12, 4, 0.2f})->yaw(Ogre::Degree(40));
        s.addBox({1, 2, -6}, {1, 1, 1});
    });
    add("map of 32 texels", [](HardScene& s) {
        s.mapWidth = s.mapHeight = 32;
        s.addField();
    });
    add("map of 2048 x 128 texels", [](HardScene& s) {
        s.mapWidth = 2048;
        s.mapHeight = 128;
        s.addField();
    });
    add("two lights of one setup: the first", [](HardScene& s) {
        s.addField();
        addSecondSun(s);
    });
    add("two lights of one setup: the second", [](HardScene& s) {
        s.addField();
        s.light = addSecondSun(s);
    });
    return cases;
}

const std::vector<HardCase>& hardCases() {
    static const std::vector<HardCase> all = [] {
        std::vector<HardCase> cases = viewCases();
        for (const std::vector<HardCase>& more : {lightCases(), bodyCases()})
            cases.insert(cases.end(), more.begin(), more.end());
        return cases;
    }();
    return all;
}

} // namespace Lixel::Tests
