#include "Queries.h"

#include "Operation.h"

#include <OgreLight.h>
#include <OgrePlaneBoundedVolume.h>
#include <OgreSceneQuery.h>
#include <OgreStaticGeometry.h>

#include <fmt/format.h>

#include <algorithm>

namespace Lixel::Tests {
namespace {

/// Some for a few objects, some for all.
void setMasks(Ogre::SceneQuery& query, Random& random) {
    query.setQueryMask(random.of<Ogre::uint32>({0xFFFFFFFF, 5}));
}

class Asker {
public:
    Asker(World& world, Random& random) : mWorld(world), mRandom(random) {}

    void askBox() {
        const Ogre::Vector3 corner = anyPlace(mRandom, 20);
        const Ogre::Vector3 size(mRandom.between(0, 30), 8, mRandom.between(0, 30));
        ask(*mWorld.manager().createAABBQuery({corner, corner + size}), "box");
    }

    void askSphere() {
        const Ogre::Vector3 centre = anyPlace(mRandom, 20);
        ask(*mWorld.manager().createSphereQuery({centre, mRandom.between(0.5f, 15)}), "sphere");
    }

    void askVolumes() {
        Ogre::PlaneBoundedVolumeList volumes;
        for (int i = 0; i < 2; ++i) {
            Ogre::PlaneBoundedVolume volume(Ogre::Plane::NEGATIVE_SIDE);
            for (int plane = 0; plane < 4; ++plane)
                volume.planes.emplace_back(anyPlace(mRandom, 1) + Ogre::Vector3(0, 0.1f, 0.1f),
                                           anyPlace(mRandom, 10));
            volumes.push_back(volume);
        }
        ask(*mWorld.manager().createPlaneBoundedVolumeQuery(volumes), "volumes");
    }

    void askRay() {
        const Ogre::Vector3 origin = anyPlace(mRandom, 25);
        const Ogre::Vector3 direction = (anyPlace(mRandom, 5) - origin).normalisedCopy();
        Ogre::RaySceneQuery* query = mWorld.manager().createRayQuery({origin, direction});
        setMasks(*query, mRandom);
        query->setSortByDistance(true);
        float nearest = 0;
        for (const Ogre::RaySceneQueryResultEntry& hit : query->execute()) {
            lines.push_back(fmt::format("ray hits {} at {:a}", nameOf(*hit.movable), hit.distance));
            if (hit.distance < nearest) lines.push_back("ray hits out of order");
            nearest = hit.distance;
        }
        mWorld.manager().destroyQuery(query);
    }

    void askIntersections() {
        Ogre::IntersectionSceneQuery* query = mWorld.manager().createIntersectionQuery();
        setMasks(*query, mRandom);
        for (const auto& [one, other] : query->execute().movables2movables) {
            std::string names[2]{nameOf(*one), nameOf(*other)};
            if (names[1] < names[0]) std::swap(names[0], names[1]);
            lines.push_back(names[0] + " intersects " + names[1]);
        }
        mWorld.manager().destroyQuery(query);
    }

    void askLights() {
        Ogre::LightList lights;
        mWorld.manager()._populateLightList(anyPlace(mRandom, 15), 2, lights,
                                            static_cast<Ogre::uint32>(mRandom.below(4)));
        std::string line = "lit by";
        for (const Ogre::Light* light : lights)
            line += " " + nameOf(*light);
        lines.push_back(line);
    }

    std::vector<std::string> lines;

private:
    std::string nameOf(const Ogre::MovableObject& object) { return mWorld.names.of(object); }

    template <typename Query>
    void ask(Query& query, const char* kind) {
        setMasks(query, mRandom);
        for (const Ogre::MovableObject* object : query.execute().movables)
            lines.push_back(std::string(kind) + " holds " + nameOf(*object));
        mWorld.manager().destroyQuery(&query);
    }

    World& mWorld;
    Random& mRandom;
};

} // namespace

std::vector<std::string> answers(World& world, Random random) {
    // OGRE asks spheres that are as old as the last frame that showed the object, if ever one did.
    // A scene manager may know better.
    for (const ObjectEntry& entry : world.objects)
        if (entry.object->isAttached()) entry.object->getWorldBoundingSphere(true);
    // Since 13 queries find them, too.
    for (const Ogre::StaticGeometry* geometry : world.statics)
        for (const auto& [place, region] : geometry->getRegions())
            region->getWorldBoundingSphere(true);
    Asker asker(world, random);
    for (int i = 0; i < 2; ++i) {
        asker.askBox();
        asker.askSphere();
        asker.askVolumes();
        asker.askRay();
    }
    asker.askIntersections();
    // Without a search, the list of lights keeps those that are destroyed.
    if (world.manager().getFindVisibleObjects()) asker.askLights();
    std::sort(asker.lines.begin(), asker.lines.end());
    return asker.lines;
}

} // namespace Lixel::Tests
