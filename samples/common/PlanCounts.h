#pragma once

#include <Lixel/setup/MapPlan.h>
#include <Lixel/setup/ShadowMapObserver.h>

namespace Lixel::Samples {

/// Counts what is done with shadow maps, while it lives.
class PlanCounts : public ShadowMapObserver {
public:
    PlanCounts() { addShadowMapObserver(*this); }
    ~PlanCounts() override { removeShadowMapObserver(*this); }
    PlanCounts(const PlanCounts&) = delete;
    PlanCounts& operator=(const PlanCounts&) = delete;

    void shadowMapFitted(const ShadowMap& map) override {
        switch (map.decision.plan) {
        case MapPlan::DrawMoving:
            ++moving;
            [[fallthrough]];
        case MapPlan::Draw:
            ++drawn;
            reason = toString(map.decision.reason);
            if (!map.decision.name.empty()) reason += ": " + map.decision.name;
            break;
        case MapPlan::Reuse:
            ++reused;
            postponed += map.decision.reason == PlanReason::Postponed ? 1 : 0;
            break;
        case MapPlan::Skip:
            ++skipped;
            break;
        }
    }
    void clear() {
        drawn = moving = reused = skipped = postponed = 0;
        reason.clear();
    }

    std::size_t drawn = 0;
    /// The drawn ones that were drawn over a copy of what stands still.
    std::size_t moving = 0;
    std::size_t reused = 0;
    std::size_t skipped = 0;
    /// Of the reused ones, those that would be drawn without a budget.
    std::size_t postponed = 0;
    /// Why the last one was drawn.
    std::string reason;
};

} // namespace Lixel::Samples
