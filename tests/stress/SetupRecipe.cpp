#include "SetupRecipe.h"

#include "Random.h"

#include <Lixel/fit/technique/Techniques.h>
#include <Lixel/setup/SetupList.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreShadowCameraSetupFocused.h>
#include <OgreShadowCameraSetupLiSPSM.h>

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <vector>

namespace Lixel::Tests {
namespace {

/// Counts are what a technique may spend: larger ones only take longer.
constexpr double GreatestCount = 300.0;

/// What leaves points unserved that its kind serves otherwise. It has a kind of its own.
constexpr std::string_view Unserving = "exact";

/// A kind of setup: how to make one, and the options that may be turned.
struct Kind {
    std::string name;
    std::function<Ogre::ShadowCameraSetupPtr(Random& random)> make;
    std::span<const Option> options;
    bool isExact = true;
    bool isCube = false;
};

/// Of any technique.
Ogre::ShadowCameraSetupPtr makeCascades(Random& random) {
    const auto all = techniques();
    const SetupKind& slice = *findSetupKind(all[random.below(all.size())]->name);
    return CascadesShadowCameraSetup::create(slice.create());
}

template <typename OgresSetup>
Kind observed(const char* name) {
    const auto make = [](Random&) -> Ogre::ShadowCameraSetupPtr {
        return ObservedShadowCameraSetup::create(std::make_shared<OgresSetup>());
    };
    return {.name = name, .make = make, .options = {}, .isExact = false};
}

/// All of Lixel's, and some of OGRE's.
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = [] {
        std::vector<Kind> made;
        for (const SetupKind& kind : setupKinds())
            made.push_back({.name = std::string(kind.name),
                            .make = [&kind](Random&) { return kind.create(); },
                            .options = kind.options,
                            .isCube = kind.name == "PostProjectiveCube"});
        for (Kind& kind : made)
            if (kind.name == "Cascades") kind.make = makeCascades;
        const auto makeExact = [](Random&) -> Ogre::ShadowCameraSetupPtr {
            return PlaneOptimalShadowCameraSetup::create({.exact = true});
        };
        made.push_back({.name = "PlaneOptimalExact",
                        .make = makeExact,
                        .options = findSetupKind("PlaneOptimal")->options,
                        .isExact = false});
        made.push_back(observed<Ogre::LiSPSMShadowCameraSetup>("ObservedLiSPSM"));
        made.push_back(observed<Ogre::DefaultShadowCameraSetup>("ObservedDefault"));
        return made;
    }();
    return all;
}

const Kind& kindOf(const SetupRecipe& recipe) {
    return kinds()[recipe.kind % kinds().size()];
}

/// A number of the option's range: every fourth time one of its ends, or next to it.
double drawNumber(const Option& option, Random& random) {
    const OptionRange& range = option.range;
    double greatest = range.greatest;
    if (option.type == OptionType::Count) greatest = std::min(greatest, GreatestCount);
    const auto part = [&](float least, float most) {
        return static_cast<double>(random.between(least, most));
    };
    if (!std::isfinite(greatest)) {
        const double least = std::isfinite(range.least) ? range.least : 0.0;
        return random.oneIn(4) && !range.isLeastOpen ? least
                                                     : least + std::pow(10.0, part(-3.0F, 3.0F));
    }
    const double width = greatest - range.least;
    switch (random.below(8)) {
    case 0:
        return range.least + (range.isLeastOpen ? 1e-3 * width : 0.0);
    case 1:
        return greatest - (range.isGreatestOpen ? 1e-3 * width : 0.0);
    default:
        return range.least + part(0.01F, 0.99F) * width;
    }
}

/// A legal value of the option, as text.
std::string draw(const Option& option, Random& random) {
    switch (option.type) {
    case OptionType::Flag:
        return random.oneIn(3) ? "true" : "false";
    case OptionType::Count:
        return fmt::format("{}", std::lround(drawNumber(option, random)));
    case OptionType::Number:
        return fmt::format("{}", drawNumber(option, random));
    case OptionType::Plane:
        if (random.oneIn(2)) return "0 1 0 0";
        return fmt::format("{} 1 {} {}", random.between(-1, 1), random.between(-1, 1),
                           random.between(-5, 5));
    case OptionType::Ascending:
        return random.oneIn(4) ? "3 9 30" : "none";
    }
    return {};
}

void turnCommon(FittedShadowCameraSetup& setup, Random& random) {
    setup.setFilterRadius(random.of({0.0F, 1.0F, 1.0F, 1.0F, 2.5F, 64.0F}));
    setup.setDepthBias(random.of({0.0F, 0.0F, 0.01F}));
    setup.setMeshHulls(!random.oneIn(4));
    std::vector<VisiblePoint> points;
    if (random.oneIn(8))
        for (std::size_t i = random.below(200); i > 0; --i)
            points.push_back({Vec3(static_cast<double>(random.between(-9, 9)), 0.0,
                                   static_cast<double>(random.between(-9, 9))),
                              Vec3::UnitY()});
    setup.setVisiblePoints(points);
    setup.setFeedback(random.oneIn(3));
}

} // namespace

Ogre::ShadowCameraSetupPtr SetupRecipe::make() const {
    // What an instance is made of stays with it; its options may change later.
    Random random(kind);
    Ogre::ShadowCameraSetupPtr setup = kindOf(*this).make(random);
    apply(*setup);
    return setup;
}

void SetupRecipe::apply(Ogre::ShadowCameraSetup& setup) const {
    Random random(options);
    auto* const fitted = dynamic_cast<FittedShadowCameraSetup*>(&setup);
    if (fitted == nullptr) return;
    turnCommon(*fitted, random);
    for (const Option& option : kindOf(*this).options)
        if (option.keyword != Unserving)
            fitted->setParameter(std::string(option.keyword), draw(option, random));
}

std::string SetupRecipe::name() const {
    return kindOf(*this).name;
}

bool SetupRecipe::isExact() const {
    return kindOf(*this).isExact;
}

bool SetupRecipe::isCube() const {
    return kindOf(*this).isCube;
}

} // namespace Lixel::Tests
