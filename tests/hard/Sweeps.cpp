#include "Sweeps.h"

#include <Eigen/Geometry>

#include <cmath>

namespace Lixel::Tests {
namespace {

using Eigen::Vector3d;

/// Where the viewer stands and looks, in units.
struct Eye {
    Vector3d position;
    Vector3d forward;
};

const Vector3d Down = -Vector3d::UnitY();
/// Over the ground, slightly down.
const Eye Walker{{0.0, 2.0, 0.0}, Vector3d(0.0, -0.15, -1.0).normalized()};
/// Slightly up, as one who looks into a sun.
const Eye SunGazer{{0.0, 2.0, 0.0}, Vector3d(0.0, 0.25, -1.0).normalized()};
/// Straight down onto the boxes.
const Eye Bird{{0.0, 25.0, -16.0}, Down};

Ogre::Vector3 toOgre(const Vector3d& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Vector3d rightOf(const Eye& eye) {
    const Vector3d right = eye.forward.cross(Vector3d::UnitY());
    return right.norm() > 1e-6 ? Vector3d(right.normalized()) : Vector3d(Vector3d::UnitX());
}

Vector3d upOf(const Eye& eye) {
    return rightOf(eye).cross(eye.forward);
}

Vector3d turned(const Vector3d& direction, const Vector3d& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis.normalized()) * direction;
}

/// Looks from there, turned about an axis of the world.
void look(HardScene& scene, const Eye& eye, const Vector3d& axis, double angle) {
    Eigen::Matrix3d wsFromCamera;
    wsFromCamera << rightOf(eye), upOf(eye), -eye.forward;
    wsFromCamera = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix() * wsFromCamera;
    const Eigen::Quaternionf rotation(Eigen::Quaterniond(wsFromCamera).cast<float>());
    Ogre::SceneNode* const node = scene.viewer().getParentSceneNode();
    node->setFixedYawAxis(false);
    node->setPosition(scene.toWorld(toOgre(eye.position)));
    node->setOrientation(rotation.w(), rotation.x(), rotation.y(), rotation.z());
}

void shine(HardScene& scene, const Vector3d& direction) {
    scene.light->getParentSceneNode()->resetOrientation();
    scene.setOwnDirection(toOgre(direction.normalized()));
}

/// Nine boxes on one ground, 4 to 28 units ahead of the origin.
void addBoxes(HardScene& scene) {
    scene.viewer().setFOVy(Ogre::Degree(60));
    scene.setPlanes(0.1F, 500);
    scene.addGround(100, 1);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const float height = 1.0F + 0.8F * static_cast<float>(column);
            scene.addBox({4.0F * static_cast<float>(column - 1), 0.5F * height,
                          -4.0F - 12.0F * static_cast<float>(row)},
                         {1.2F, height, 1.2F});
        }
}

/// The sun turns about an axis while the viewer stands still.
Sweep sun(const char* name, const Eye& eye, const Vector3d& direction, const Vector3d& axis) {
    return {name,
            [eye](HardScene& scene) {
                addBoxes(scene);
                scene.light->setType(Ogre::Light::LT_DIRECTIONAL);
                look(scene, eye, Vector3d::UnitY(), 0.0);
            },
            [direction, axis](HardScene& scene, double angle) {
                shine(scene, turned(direction, axis, angle));
            }};
}

/// The viewer turns under a sun.
Sweep viewer(const char* name, const Eye& eye, const Vector3d& axis, const Vector3d& direction) {
    return {name,
            [direction](HardScene& scene) {
                addBoxes(scene);
                scene.light->setType(Ogre::Light::LT_DIRECTIONAL);
                shine(scene, direction);
            },
            [eye, axis](HardScene& scene, double angle) { look(scene, eye, axis, angle); }};
}

void addSpot(HardScene& scene, const Vector3d& position, float outerDegrees) {
    scene.spot(toOgre(position), toOgre(position + Down), outerDegrees);
}

/// A spot turns about an axis while the viewer stands still.
Sweep spot(const char* name, const Eye& eye, const Vector3d& position, float outerDegrees,
           const Vector3d& direction, const Vector3d& axis) {
    Sweep sweep = sun(name, eye, direction, axis);
    sweep.build = [eye, position, outerDegrees](HardScene& scene) {
        addBoxes(scene);
        addSpot(scene, position, outerDegrees);
        look(scene, eye, Vector3d::UnitY(), 0.0);
    };
    return sweep;
}

/// The viewer turns while a spot stands still.
Sweep viewerAtSpot(const char* name, const Eye& eye, const Vector3d& axis, const Vector3d& position,
                   float outerDegrees, const Vector3d& direction) {
    Sweep sweep = viewer(name, eye, axis, direction);
    sweep.build = [position, outerDegrees, direction](HardScene& scene) {
        addBoxes(scene);
        addSpot(scene, position, outerDegrees);
        shine(scene, direction);
    };
    return sweep;
}

} // namespace

const std::vector<Sweep>& sweeps() {
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    const Vector3d forward = Walker.forward;
    const Vector3d gaze = SunGazer.forward;
    const Vector3d slanting(0.8, -1.0, 0.3);
    // A direction across the view from which the ground is lit.
    const Vector3d across =
        Vector3d(0.6, -1.0, 0.0) - Vector3d(0.6, -1.0, 0.0).dot(forward) * forward;
    const Vector3d lamp(0.0, 6.0, -34.0);
    const Eye lampGazer{Walker.position, (lamp - Walker.position).normalized()};
    static const std::vector<Sweep> all{
        sun("miner's lamp, sideways", Walker, forward, y),
        sun("miner's lamp, slanting", Walker, forward, Vector3d(1.0, 0.3, 0.0).cross(forward)),
        sun("duel, sideways", SunGazer, -gaze, y),
        sun("duel, slanting", SunGazer, -gaze, Vector3d(1.0, 0.2, 0.0).cross(gaze)),
        sun("across the view", Walker, across, across.cross(forward)),
        sun("straight down, forth", Walker, Down, x),
        sun("straight down, sideways", Walker, Down, z),
        sun("along the camera's up", Walker, -upOf(Walker), x),
        sun("z changes its sign", Walker, {0.5, -std::sqrt(0.75), 0.0},
            {std::sqrt(0.75), 0.5, 0.0}),
        sun("along the boxes' sides", Walker, {0.0, -1.0, -1.0}, y),
        sun("along the boxes' diagonals", Walker, {1.0, -1.0, -1.0}, y),
        viewer("yaw past the sun", Walker, y, {0.0, -0.5, -1.0}),
        viewer("yaw against the sun", Walker, y, {0.0, -0.5, 1.0}),
        viewer("pitch through the sun's direction", Walker, x, forward),
        viewer("pitch against the sun's direction", SunGazer, x, -gaze),
        viewer("pitch through straight down", Bird, x, slanting),
        viewer("the same under a sun overhead", Bird, x, Down),
        spot("spot's miner's lamp", Walker, {0.5, 2.5, 0.0}, 50.0F, forward, y),
        spot("spot's duel", SunGazer, lamp, 90.0F, -gaze, y),
        spot("spot straight down", Walker, {0.0, 8.0, -12.0}, 100.0F, Down, x),
        viewerAtSpot("yaw past a spot", Walker, y, {0.0, 8.0, -12.0}, 90.0F, {0.0, -1.0, -0.5}),
        viewerAtSpot("pitch through a spot", lampGazer, x, lamp, 90.0F, -lampGazer.forward),
    };
    return all;
}

} // namespace Lixel::Tests
