#include "setup/ShadowMapObserver.h"

#include <algorithm>
#include <vector>

namespace Lixel {
namespace {

struct Observers {
    /// Null where one was removed while they are told.
    std::vector<ShadowMapObserver*> list;
    /// Maps that they are being told about: an observer may have another one drawn.
    int telling = 0;
};

Observers& observers() {
    static Observers instance;
    return instance;
}

/// Keeps observers in their places.
class Telling {
public:
    Telling() { ++observers().telling; }
    ~Telling() {
        if (--observers().telling == 0) std::erase(observers().list, nullptr);
    }
    Telling(const Telling&) = delete;
    Telling& operator=(const Telling&) = delete;
};

} // namespace

ShadowMapObserver::~ShadowMapObserver() {
    removeShadowMapObserver(*this);
}

void addShadowMapObserver(ShadowMapObserver& observer) {
    std::vector<ShadowMapObserver*>& list = observers().list;
    if (std::ranges::find(list, &observer) == list.end()) list.push_back(&observer);
}

void removeShadowMapObserver(ShadowMapObserver& observer) {
    std::vector<ShadowMapObserver*>& list = observers().list;
    const auto found = std::ranges::find(list, &observer);
    if (found == list.end()) return;
    *found = nullptr;
    if (observers().telling == 0) list.erase(found);
}

void publishShadowMap(const ShadowMap& map) {
    const Telling telling;
    const std::vector<ShadowMapObserver*>& list = observers().list;
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < count; ++i)
        if (list[i] != nullptr) list[i]->shadowMapFitted(map);
}

} // namespace Lixel
