#include "setup/PlannedMap.h"

#include "scene/CasterFingerprint.h"
#include "scene/OgreVersions.h"
#include "setup/ShadowPass.h"

#include <OgreCamera.h>

namespace Lixel {

PlannedMap planMap(const Ogre::Camera& shadowCamera, const Ogre::Viewport& view,
                   const ShadowFit& fit, const ShadowTarget& target, bool readsAtOnce,
                   const std::function<const CasterFingerprint&()>& readCasters) {
    Ogre::SceneManager& manager = *shadowCamera.getSceneManager();
    if (drawsMapsTogether(*target.texture)) return {};
    if (hasForeignListener(manager)) return {{MapPlan::Draw, PlanReason::Listener, {}}, {}};
    if (!hasKnownCasterMaterial(manager))
        return {{MapPlan::Draw, PlanReason::OwnCasterMaterial, {}}, {}};

    MapContent wanted;
    wanted.matrices = matricesOf(shadowCamera, fit);
    wanted.settings = settingsOf(manager, shadowCamera, view);
    wanted.texture = target.texture;
    wanted.textureState = target.texture->getStateCount();
    const MapContent* const shown = contentOf(target);
    const auto drawn = [&](PlanReason reason) {
        if (readsAtOnce && !wanted.casters)
            if (const CasterFingerprint& casters = readCasters(); casters.unknownName().empty())
                wanted.casters = casters.value();
        return PlannedMap{{MapPlan::Draw, reason, {}}, wanted};
    };
    if (shown == nullptr) return drawn(PlanReason::Unknown);
    if (shown->empty || shown->matrices != wanted.matrices) return drawn(PlanReason::MapChanged);
    if (shown->settings != wanted.settings) return drawn(PlanReason::SettingsChanged);

    const CasterFingerprint& casters = readCasters();
    if (!casters.unknownName().empty())
        return {{MapPlan::Draw, PlanReason::RestlessCaster, casters.unknownName()}, wanted};
    wanted.casters = casters.value();
    if (!shown->casters) return drawn(PlanReason::Unknown);
    if (*shown->casters != *wanted.casters) return drawn(PlanReason::CastersChanged);
    return {{MapPlan::Reuse, PlanReason::NothingChanged, {}}, wanted};
}

} // namespace Lixel
