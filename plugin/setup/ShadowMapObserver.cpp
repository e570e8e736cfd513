#include "setup/ShadowMapObserver.h"

#include <algorithm>
#include <vector>

namespace Lixel {
namespace {

std::vector<ShadowMapObserver*>& observers() {
    static std::vector<ShadowMapObserver*> list;
    return list;
}

} // namespace

ShadowMapObserver::~ShadowMapObserver() {
    removeShadowMapObserver(*this);
}

void addShadowMapObserver(ShadowMapObserver& observer) {
    removeShadowMapObserver(observer);
    observers().push_back(&observer);
}

void removeShadowMapObserver(ShadowMapObserver& observer) {
    std::erase(observers(), &observer);
}

void publishShadowMap(const ShadowMap& map) {
    for (ShadowMapObserver* observer : observers())
        observer->shadowMapFitted(map);
}

} // namespace Lixel
