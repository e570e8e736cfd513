#include "setup/SetupList.h"

#include "setup/ShadowCameraSetups.h"

#include <algorithm>
#include <vector>

namespace Lixel {
namespace {

/// The class of a technique's setup.
template <typename Options>
struct SetupOf {
    using Type = TechniqueShadowCameraSetup<Options>;
};
template <>
struct SetupOf<PlaneOptimalOptions> {
    using Type = PlaneOptimalShadowCameraSetup;
};
template <>
struct SetupOf<CubeOptions> {
    using Type = PostProjectiveCubeShadowCameraSetup;
};

template <typename Options>
SetupKind kindOf() {
    const FitTechnique& technique = Options::technique();
    return {technique.name, technique.title, technique.paper, technique.options,
            []() -> std::shared_ptr<FittedShadowCameraSetup> {
                return SetupOf<Options>::Type::create();
            }};
}

template <typename... Options>
std::vector<SetupKind> kindsOf(TypeList<Options...>) {
    return {kindOf<Options>()...};
}

const std::vector<SetupKind>& allKinds() {
    static const std::vector<SetupKind> all = [] {
        std::vector<SetupKind> kinds = kindsOf(AllTechniques());
        kinds.push_back({"Cascades", "one map for each slice of the view", "Zhang et al. 2006",
                         CascadeOptions::declared(),
                         []() -> std::shared_ptr<FittedShadowCameraSetup> {
                             return CascadesShadowCameraSetup::create();
                         }});
        kinds.push_back(kindOf<CubeOptions>());
        return kinds;
    }();
    return all;
}

} // namespace

std::span<const SetupKind> setupKinds() {
    return allKinds();
}

const SetupKind* findSetupKind(std::string_view name) {
    const auto found = std::ranges::find(allKinds(), name, &SetupKind::name);
    return found == allKinds().end() ? nullptr : &*found;
}

} // namespace Lixel
