#include "setup/MapPlan.h"

#include "scene/NodeStore.h"
#include "setup/ShadowPass.h"

namespace Lixel {

std::string_view toString(MapPlan plan) {
    switch (plan) {
    case MapPlan::Draw:
        return "draw";
    case MapPlan::DrawMoving:
        return "draw what moves";
    case MapPlan::Reuse:
        return "reuse";
    case MapPlan::Skip:
        return "skip";
    }
    return "?";
}

std::string_view toString(PlanReason reason) {
    switch (reason) {
    case PlanReason::NothingChanged:
        return "nothing changed";
    case PlanReason::Postponed:
        return "postponed: the frame's budget is spent";
    case PlanReason::NothingShadowed:
        return "nothing is shadowed";
    case PlanReason::Unknown:
        return "what its texture shows is not known";
    case PlanReason::MapChanged:
        return "the light, what is seen, or the texture is another";
    case PlanReason::SettingsChanged:
        return "settings changed";
    case PlanReason::CastersChanged:
        return "a caster changed";
    case PlanReason::RestlessCaster:
        return "a caster may look different each time";
    case PlanReason::OwnCasterMaterial:
        return "the caster material is not Lixel's";
    case PlanReason::Listener:
        return "a render queue listener of the application";
    case PlanReason::NotPlanned:
        return "the setup is not one of Lixel's";
    case PlanReason::Forbidden:
        return "reuse_maps is off";
    }
    return "?";
}

void redrawShadowMaps() {
    forgetContents();
    announceChangeInStores();
}

} // namespace Lixel
