#include "Walk.h"

#include "LastWords.h"
#include "ManagerOgre.h"
#include "Meshes.h"
#include "Operation.h"
#include "Queries.h"

#include "../stress/Shrink.h"

#include <OgreFrameListener.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreRoot.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace Lixel::Tests {
namespace {

/// Of a frame, in seconds: particles must not see the machine's clock.
constexpr float FrameTime = 1.0f / 30;

/// One frame after another has been drawn that nothing was done before: what is kept from frame to
/// frame has to be right, too.
constexpr std::size_t OneIn = 8;

const Operation& anyOperation(Random& random) {
    const Operations& all = allOperations();
    static const std::size_t weights =
        std::accumulate(all.begin(), all.end(), std::size_t{0},
                        [](std::size_t sum, const Operation& each) { return sum + each.weight; });
    std::size_t at = random.below(weights);
    for (const Operation& operation : all) {
        if (at < operation.weight) return operation;
        at -= operation.weight;
    }
    return all.back();
}

/// What walks before have changed that scenes share.
void resetShared(Ogre::SceneManager& manager) {
    meshes(manager);
    for (const auto& [handle, resource] :
         Ogre::MaterialManager::getSingleton().getResourceIterator())
        if (resource->getGroup() == Ogre::RGN_DEFAULT)
            static_cast<Ogre::Material&>(*resource).setReceiveShadows(resource->getName() !=
                                                                      "unshadowed");
    Ogre::MeshManager::getSingleton()
        .getByName(ChangingMesh, Ogre::RGN_DEFAULT)
        ->_setBounds({-0.5f, -0.5f, -0.5f, 0.5f, 0.5f, 0.5f}, false);
}

std::string perform(const Operation& operation, World& world, Random random) {
    const World::Turn turn(world);
    try {
        return operation.perform(world, random);
    } catch (const Ogre::Exception& exception) {
        return std::string(operation.name) + " throws " + exception.getDescription();
    }
}

class Pair {
public:
    explicit Pair(const Walk& walk)
        : mOgre(ogreWithManagers()),
          mExpected(mOgre.root(), walk.reference, "expected"),
          mActual(mOgre.root(), walk.candidate, "actual") {
        resetShared(mExpected.manager());
    }

    /// Says what was done in `deed`. @return a difference
    std::string act(Random& random, std::string& deed, WalkEnd& end) {
        for (int tries = 0; tries < 20 && deed.empty(); ++tries) {
            const Operation& operation = anyOperation(random);
            const Random same(random.next());
            LastWords::say(operation.name);
            deed = perform(operation, mExpected, same);
            const std::string actual = perform(operation, mActual, same);
            for (World* world : {&mExpected, &mActual}) {
                const World::Turn turn(*world);
                world->mendViews();
                world->nameAll();
            }
            if (!deed.empty()) ++end.done[operation.name];
            if (deed != actual) return "done: " + deed + ", and here: " + actual;
        }
        return "";
    }

    std::string drawFrame(WalkEnd& end) {
        LastWords::say("draw");
        Ogre::FrameEvent event{FrameTime, FrameTime};
        mOgre.root()._fireFrameStarted(event);
        mExpected.draw();
        mActual.draw();
        mOgre.root()._fireFrameRenderingQueued(event);
        mOgre.root()._fireFrameEnded(event);
        const FrameRecord expected = mExpected.takeRecord();
        const FrameRecord actual = mActual.takeRecord();
        if (expected.sights.size() != actual.sights.size())
            return fmt::format("{} passes, and here {}", expected.sights.size(),
                               actual.sights.size());
        for (std::size_t i = 0; i < expected.sights.size(); ++i) {
            ++end.sights;
            end.queued += expected.sights[i].queued.size();
            const std::string found = difference(expected.sights[i], actual.sights[i]);
            if (!found.empty()) return found;
        }
        return difference(expected.heard, actual.heard);
    }

    std::string ask(Random& random, WalkEnd& end) {
        LastWords::say("ask");
        const Random same(random.next());
        const std::vector<std::string> expected = answers(mExpected, same);
        const std::vector<std::string> actual = answers(mActual, same);
        end.answers += expected.size();
        if (expected == actual) return "";
        const auto [one, other] =
            std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end());
        return "answered " + (one == expected.end() ? "nothing" : *one) + ", and here " +
               (other == actual.end() ? "nothing" : *other);
    }

private:
    HeadlessOgre& mOgre;
    World mExpected;
    World mActual;
};

std::string takeStep(Pair& pair, Random& random, bool asks, WalkEnd& end) {
    std::string deed;
    const std::string other = pair.act(random, deed, end);
    end.deeds.push_back(fmt::format("{}: {}", end.step, deed));
    if (!other.empty()) return other;
    if (random.oneIn(3)) return ""; // the next frame shows several steps at once
    std::string found = pair.drawFrame(end);
    if (found.empty() && random.oneIn(OneIn)) found = pair.drawFrame(end);
    if (found.empty() && asks && random.oneIn(OneIn)) found = pair.ask(random, end);
    return found;
}

} // namespace

std::vector<std::size_t> allSteps(std::size_t count) {
    std::vector<std::size_t> steps(count);
    std::iota(steps.begin(), steps.end(), std::size_t{0});
    return steps;
}

WalkEnd go(const Walk& walk) {
    WalkEnd end;
    const std::string name =
        fmt::format("{} beside {}, seed {}", walk.candidate, walk.reference, walk.seed);
    LastWords::begin(name, end.deeds);
    {
        Pair pair(walk);
        for (const std::size_t step : walk.steps) {
            end.step = step;
            Random random(walk.seed * 0x2545F4914F6CDD1DULL + step);
            end.difference = takeStep(pair, random, walk.asks, end);
            if (!end.difference.empty()) break;
        }
        LastWords::say("destroy both");
    }
    LastWords::forget();
    return end;
}

Walk shrink(const Walk& walk) {
    return leaveOutSteps(walk, [](const Walk& one) {
        const WalkEnd end = go(one);
        return end.difference.empty() ? std::nullopt : std::optional(end.step);
    });
}

std::string story(const Walk& walk) {
    const Walk shortest = shrink(walk);
    const WalkEnd end = go(shortest);
    std::string told = fmt::format("{} beside {}, seed {}, {} steps:\n", walk.candidate,
                                   walk.reference, walk.seed, shortest.steps.size());
    for (const std::string& deed : end.deeds)
        told += "  " + deed + "\n";
    return told + end.difference;
}

} // namespace Lixel::Tests
