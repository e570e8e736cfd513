#include "Operation.h"

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace Lixel::Tests {
namespace {

/// By hand, to look for what else differs: the environment's LIXEL_WITHOUT lists names, or parts of
/// them, of operations to leave out, each ended by a comma.
void leaveOut(Operations& all) {
    const char* without = std::getenv("LIXEL_WITHOUT");
    if (without == nullptr) return;
    const std::string list = without;
    for (std::size_t begin = 0, end = 0; (end = list.find(',', begin)) != std::string::npos;
         begin = end + 1)
        std::erase_if(all, [part = list.substr(begin, end - begin)](const Operation& operation) {
            return std::strstr(operation.name, part.c_str()) != nullptr;
        });
}

} // namespace

const Operations& allOperations() {
    static const Operations all = [] {
        Operations made;
        for (const auto add :
             {addNodeOperations, addGraphOperations, addEntityOperations, addObjectOperations,
              addDrawnByHandOperations, addEffectOperations, addBoneOperations, addBatchOperations,
              addLightOperations, addViewOperations, addSceneOperations})
            add(made);
        leaveOut(made);
        return made;
    }();
    return all;
}

} // namespace Lixel::Tests
