#include "Managers.h"

#include "HeadlessOgre.h"
#include "OwnBoxesManager.h"

#include <cstdlib>
#include <string_view>

namespace Lixel::Tests {

Candidate candidate() {
    Candidate chosen;
    if (const char* manager = std::getenv("LIXEL_CANDIDATE")) chosen.manager = manager;
    if (const char* rule = std::getenv("LIXEL_RULE"))
        chosen.rule =
            std::string_view(rule) == "own" ? CullingRule::OwnBoxes : CullingRule::MergedBoxes;
    chosen.answersAlike = chosen.manager != OctreeManager;
    return chosen;
}

std::string referenceOf(CullingRule rule) {
    return rule == CullingRule::OwnBoxes ? OwnBoxesManager : DefaultManager;
}

} // namespace Lixel::Tests
