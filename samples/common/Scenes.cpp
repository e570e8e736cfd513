#include "common/Scenes.h"

#include "common/SceneList.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {

const std::vector<SampleScene>& sampleScenes() {
    static const std::vector<SampleScene> scenes{
        fieldScene(),    duelScene(),     minersLampScene(), streetScene(),    meadowScene(),
        bridgeScene(),   interiorScene(), forestScene(),     cityScene(),      weaponScene(),
        lampRoomScene(), vastScene(),     solarScene(),      telephotoScene(),
#ifdef LIXEL_SAMPLES_RTSS
        gardenScene()
#endif
    };
    return scenes;
}

const std::vector<SampleScene>& measuredScenes() {
    static const std::vector<SampleScene> scenes = [] {
        std::vector<SampleScene> measured = sampleScenes();
        std::erase_if(measured, [](const SampleScene& scene) { return scene.shaderSystem; });
        return measured;
    }();
    return scenes;
}

const SampleScene* findSampleScene(const std::string& name) {
    const auto& scenes = sampleScenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const SampleScene& scene) { return scene.name == name; });
    return found != scenes.end() ? &*found : nullptr;
}

SampleLight sunlight(const std::string& name, float azimuthDegrees, float elevationDegrees) {
    const float azimuth = Ogre::Degree(azimuthDegrees).valueRadians();
    const float elevation = Ogre::Degree(elevationDegrees).valueRadians();
    SampleLight light;
    light.name = name;
    light.kind = SampleLight::Kind::Directional;
    light.direction = -Ogre::Vector3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                     std::cos(elevation) * std::cos(azimuth));
    const float height = std::max(0.0F, std::sin(elevation));
    const float brightness = 1.0F / (0.72F + 0.28F * height);
    light.colour =
        brightness * Ogre::ColourValue(1.0F, 0.88F + 0.09F * height, 0.7F + 0.2F * height);
    return light;
}

Ogre::Radian headingOf(const SampleView& view) {
    const Ogre::Vector3 ahead = view.target - view.position;
    return Ogre::Radian(std::atan2(-ahead.x, -ahead.z));
}

SampleLight lightOf(const SampleScene& scene, const SampleView& view, std::size_t index) {
    if (index == 0 && view.light) return *view.light;
    SampleLight light = scene.lights.at(index);
    if (!light.turnsWithView) return light;
    light.direction = Ogre::Quaternion(headingOf(view), Ogre::Vector3::UNIT_Y) * light.direction;
    light.turnsWithView = false;
    return light;
}

std::optional<SampleLight> findLight(const SampleScene& scene, const SampleView& view,
                                     const std::string& name) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (SampleLight light = lightOf(scene, view, i); light.name == name) return light;
    return std::nullopt;
}

SampleLight defaultLight(const SampleScene& scene, const SampleView& view) {
    return lightOf(scene, view, 0);
}

void applyView(const SampleView& view, Ogre::Camera& camera) {
    Ogre::SceneNode& node = *camera.getParentSceneNode();
    node.setFixedYawAxis(true);
    node.setPosition(view.position);
    node.lookAt(view.target, Ogre::Node::TS_WORLD);
    camera.setNearClipDistance(view.nearDistance);
    camera.setFarClipDistance(view.farDistance);
    camera.setFOVy(Ogre::Degree(view.fovYDegrees));
}

void applyLight(const SampleLight& light, Ogre::Light& ogreLight) {
    Ogre::SceneNode& node = *ogreLight.getParentSceneNode();
    // OGRE turns a node from where it was, and what rounding does would depend on that.
    node.resetOrientation();
    node.setPosition(light.position);
    ogreLight.setDiffuseColour(light.colour);
    ogreLight.setSpecularColour(light.colour);
    switch (light.kind) {
    case SampleLight::Kind::Directional:
        ogreLight.setType(Ogre::Light::LT_DIRECTIONAL);
        node.setDirection(light.direction, Ogre::Node::TS_WORLD);
        return;
    case SampleLight::Kind::Spot:
        ogreLight.setType(Ogre::Light::LT_SPOTLIGHT);
        node.setDirection(light.direction, Ogre::Node::TS_WORLD);
        ogreLight.setSpotlightRange(Ogre::Degree(light.innerDegrees),
                                    Ogre::Degree(light.outerDegrees), 1.0F);
        break;
    case SampleLight::Kind::Point:
        ogreLight.setType(Ogre::Light::LT_POINT);
        break;
    }
    // Half as bright at a quarter of the range: 1 / (1 + 16 (d / range)^2).
    ogreLight.setAttenuation(light.range, 1.0F, 0.0F, 16.0F / (light.range * light.range));
}

} // namespace Lixel::Samples
