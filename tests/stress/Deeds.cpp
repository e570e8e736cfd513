#include "Deeds.h"

#include "BodyDeeds.h"
#include "LightDeeds.h"
#include "SceneDeeds.h"
#include "ViewDeeds.h"

#include <numeric>

namespace Lixel::Tests {

std::string doSomething(Application& application, Random& random) {
    static const std::vector<Deed> deeds = [] {
        std::vector<Deed> all;
        for (const std::vector<Deed>* some :
             {&bodyDeeds(), &lightDeeds(), &sceneDeeds(), &viewDeeds()})
            all.insert(all.end(), some->begin(), some->end());
        return all;
    }();
    static const std::size_t weights =
        std::accumulate(deeds.begin(), deeds.end(), std::size_t{0},
                        [](std::size_t sum, const Deed& deed) { return sum + deed.weight; });
    std::size_t at = random.below(weights);
    std::size_t i = 0;
    for (; at >= deeds[i].weight; ++i)
        at -= deeds[i].weight;
    World& world = *application.worlds[random.below(application.worlds.size())];
    std::string did = deeds[i].perform(application, world, random);
    return std::string(deeds[i].name) + (did.empty() ? " (nothing to do)" : ": " + did);
}

} // namespace Lixel::Tests
