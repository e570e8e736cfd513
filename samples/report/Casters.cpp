#include "report/Casters.h"

#include "common/MaterialHoles.h"
#include "common/Measurement.h"
#include "common/OgresCascades.h"

#include <OgreInstanceBatch.h>
#include <OgreInstancedEntity.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <vector>

namespace Lixel::Samples {
namespace {

constexpr int MapSize = 1024;

struct CasterKind {
    const char* name;
    std::function<bool(const Ogre::MovableObject&)> has;
};

bool isInstance(const Ogre::MovableObject& object) {
    return object.getMovableType() == "InstancedEntity";
}

bool isEntity(const Ogre::MovableObject& object) {
    return object.getMovableType() == "Entity";
}

bool isBent(const Ogre::MovableObject& object) {
    return isEntity(object) && static_cast<const Ogre::Entity&>(object).hasSkeleton();
}

bool hasHoles(const Ogre::MovableObject& object) {
    if (!isEntity(object)) return false;
    return std::ranges::any_of(
        static_cast<const Ogre::Entity&>(object).getSubEntities(),
        [](const Ogre::SubEntity* part) { return findHoles(*part->getMaterial()).has_value(); });
}

/// Has textures that cut holes read at full size, as the truth does. Smaller mip levels have other
/// holes, in the picture as in its shadows: a pixel would show another surface than the truth.
void readHolesAtFullSize(const Ogre::String& group) {
    for (const auto& [handle, resource] :
         Ogre::MaterialManager::getSingleton().getResourceIterator()) {
        auto& material = static_cast<Ogre::Material&>(*resource);
        if (material.getGroup() != group) continue;
        material.load();
        if (!findHoles(material)) continue;
        for (Ogre::TextureUnitState* const unit :
             material.getTechnique(0)->getPass(0)->getTextureUnitStates())
            unit->setTextureFiltering(Ogre::FT_MIP, Ogre::FO_NONE);
    }
}

const std::vector<CasterKind>& kinds() {
    static const std::vector<CasterKind> all{
        {"whole",
         [](const Ogre::MovableObject& object) {
             return isEntity(object) && !isBent(object) && !hasHoles(object);
         }},
        {"with holes",
         [](const Ogre::MovableObject& object) { return hasHoles(object) && !isBent(object); }},
        {"bent in hardware", isBent},
        {"instances, with holes", isInstance},
        {"all", [](const Ogre::MovableObject&) { return true; }},
    };
    return all;
}

/// All of a scene's casters. A kind of them can be chosen to cast alone.
class Casters {
public:
    explicit Casters(Ogre::SceneManager& sceneManager) {
        collect(*sceneManager.getRootSceneNode());
    }

    void allow(const CasterKind& kind) const {
        for (Ogre::MovableObject* const object : mAll) {
            // An instance casts as its batch does.
            Ogre::MovableObject* const drawn =
                isInstance(*object) ? static_cast<Ogre::InstancedEntity*>(object)->_getOwner()
                                    : object;
            drawn->setCastShadows(kind.has(*object));
        }
    }

private:
    void collect(const Ogre::SceneNode& node) {
        for (Ogre::MovableObject* const object : node.getAttachedObjects())
            if (isInstance(*object) || (isEntity(*object) && object->getCastShadows()))
                mAll.push_back(object);
        for (const Ogre::Node* const child : node.getChildren())
            collect(*static_cast<const Ogre::SceneNode*>(child));
    }

    std::vector<Ogre::MovableObject*> mAll;
};

/// Pixels of several pictures.
struct Sum {
    std::size_t counted = 0;
    std::size_t shadowed = 0;
    std::size_t wrong = 0;
    void add(const ClassificationError& error) {
        counted += error.counted();
        shadowed += error.shadowed;
        wrong += error.acnePixels + error.leakPixels;
    }
    double ofCounted() const {
        return 100.0 * static_cast<double>(wrong) / static_cast<double>(counted);
    }
    double ofShadowed() const {
        return 100.0 * static_cast<double>(wrong) / static_cast<double>(shadowed);
    }
};

/// The views of a scene that a sun lights.
std::vector<SampleView> sunViews(const SampleScene& scene) {
    std::vector<SampleView> views;
    for (const SampleView& view : scene.views)
        if (defaultLight(scene, view).kind == SampleLight::Kind::Directional) views.push_back(view);
    return views;
}

struct KindErrors {
    Sum lixel;
    Sum ogre;
};

KindErrors measureKind(Stage& stage, const SampleScene& scene) {
    const ShadowOracle oracle(collectTriangles(stage.sceneManager()));
    KindErrors errors;
    const auto measure = [&] {
        stage.drawFrame(); // in which materials get their programs
        return measureError(stage, oracle, static_cast<double>(scene.shadowDistance));
    };
    for (const SampleView& view : sunViews(scene)) {
        stage.setView(view);
        stage.usePresets();
        stage.setLight(defaultLight(scene, view));
        stage.setShadowMapSize(MapSize);
        errors.lixel.add(measure());
        const OgresCascades ogres(stage, MapSize);
        errors.ogre.add(measure());
    }
    return errors;
}

/// A line for each kind.
void printKinds(Stage& stage, const SampleScene& scene) {
    const Casters casters(stage.sceneManager());
    fmt::print("Wrong pixels, in percent of those in shadow, and of all that count\n\n"
               "{:<24} {:>10} {:>10} {:>7} {:>10} {:>7}\n",
               "what casts", "in shadow", "Lixel", "of all", "OGRE PSSM", "of all");
    for (const CasterKind& kind : kinds()) {
        casters.allow(kind);
        const KindErrors errors = measureKind(stage, scene);
        fmt::print("{:<24} {:>10} {:>10.2f} {:>7.3f} {:>10.2f} {:>7.3f}\n", kind.name,
                   errors.lixel.shadowed, errors.lixel.ofShadowed(), errors.lixel.ofCounted(),
                   errors.ogre.ofShadowed(), errors.ogre.ofCounted());
        std::fflush(stdout);
    }
}

} // namespace

void printCasters(int width, int height) {
    const SampleScene& scene = *findSampleScene("garden");
    Stage stage({.headless = true, .width = width, .height = height});
    stage.show(scene);
    readHolesAtFullSize(MediaGroup);
    stage.drawFrame(); // OGRE updates instances' bounds from its second frame on
    try {
        printKinds(stage, scene);
    } catch (const Ogre::Exception& error) {
        // Its type may live in a plugin of the stage's.
        throw std::runtime_error(error.getDescription());
    }
}

} // namespace Lixel::Samples
