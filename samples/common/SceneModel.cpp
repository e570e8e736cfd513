#include "common/ModelFile.h"
#include "common/Scenes.h"

#include <Lixel/scene/Log.h>

#include <algorithm>
#include <filesystem>

namespace Lixel::Samples {

SampleScene modelScene(const std::string& path) {
    // The scene may be copied and built several times; the file is read once.
    const auto file = std::make_shared<const ModelFile>(path);
    const Ogre::Vector3 centre = file->box().getCenter();
    const Ogre::Vector3 size = file->box().getSize();
    const float extent = size.length();
    const Ogre::Vector3 foot(centre.x, file->box().getMinimum().y, centre.z);

    SampleScene scene;
    scene.name = "model";
    scene.title = "Model: " + std::filesystem::path(path).filename().string();
    scene.build = [file, path](Ogre::SceneManager& sceneManager) {
        const ImportedModel model = file->addTo(sceneManager, *sceneManager.getRootSceneNode());
        for (const std::string& note : model.notes)
            logWarning("model '" + path + "': " + note);
    };
    const auto view = [&](const std::string& name, const Ogre::Vector3& position,
                          const Ogre::Vector3& target) {
        return SampleView{name, position, target, 0.01F * extent, 12.0F * extent, 45.0F, {}};
    };
    // Along the longer side at a visitor's height, from so near that its other end is far.
    const bool longX = size.x >= size.z;
    const Ogre::Vector3 alongSide = longX ? Ogre::Vector3::UNIT_X : Ogre::Vector3::UNIT_Z;
    const Ogre::Vector3 outwards = longX ? Ogre::Vector3::UNIT_Z : Ogre::Vector3::UNIT_X;
    const float half = 0.5F * std::max(size.x, size.z);
    const float halfWidth = 0.5F * std::min(size.x, size.z);
    scene.views = {
        view("along-the-side",
             foot - 1.1F * half * alongSide + (halfWidth + 0.2F * half) * outwards +
                 Ogre::Vector3(0.0F, 0.3F * size.y, 0.0F),
             foot + half * alongSide + halfWidth * outwards +
                 Ogre::Vector3(0.0F, 0.1F * size.y, 0.0F)),
        view("from-the-corner", centre + extent * Ogre::Vector3(0.75F, 0.5F, 0.85F), centre),
        view("low", foot + Ogre::Vector3(-0.55F * extent, 0.1F * extent, 1.0F * extent),
             foot + Ogre::Vector3(0.0F, 0.35F * size.y, 0.0F)),
        view("from-above", centre + extent * Ogre::Vector3(-0.35F, 1.2F, 0.3F), centre),
        view("at-the-wall",
             foot - 0.15F * half * alongSide + 0.85F * halfWidth * outwards +
                 Ogre::Vector3(0.0F, 0.35F * size.y, 0.0F),
             foot + 0.5F * half * alongSide + 0.55F * halfWidth * outwards +
                 Ogre::Vector3(0.0F, 0.1F * size.y, 0.0F)),
        view("from-afar", centre + extent * Ogre::Vector3(2.2F, 0.6F, 3.0F), foot),
        view("inside", foot - 0.3F * half * alongSide + Ogre::Vector3(0.0F, 0.2F * size.y, 0.0F),
             foot + 0.5F * half * alongSide + 0.4F * halfWidth * outwards),
    };
    scene.views.back().fovYDegrees = 75.0F;
    // Far away, with a narrow field of view.
    scene.views[5].fovYDegrees = 18.0F;
    scene.lights = {sunlight("afternoon", 80.0F, 40.0F),
                    sunlight("low-from-the-side", 120.0F, 15.0F),
                    sunlight("from-behind", 35.0F, 35.0F), sunlight("against", 221.0F, 25.0F),
                    sunlight("noon", 150.0F, 80.0F)};
    scene.shadowDistance = 6.0F * extent;
    return scene;
}

} // namespace Lixel::Samples
