#include "SetupRecipe.h"

#include "Random.h"

#include <Lixel/setup/CascadesShadowCameraSetup.h>
#include <Lixel/setup/LiSPSMShadowCameraSetup.h>
#include <Lixel/setup/ObservedShadowCameraSetup.h>
#include <Lixel/setup/OptimalShadowCameraSetup.h>
#include <Lixel/setup/PSMShadowCameraSetup.h>
#include <Lixel/setup/PlaneOptimalShadowCameraSetup.h>
#include <Lixel/setup/PostProjectiveCubeShadowCameraSetup.h>
#include <Lixel/setup/TrapezoidalShadowCameraSetup.h>
#include <Lixel/setup/UniformShadowCameraSetup.h>
#include <Lixel/setup/XPSMShadowCameraSetup.h>

#include <OgreShadowCameraSetupFocused.h>
#include <OgreShadowCameraSetupLiSPSM.h>

#include <array>

namespace Lixel::Tests {
namespace {

/// A kind of setup: how to make one, and how to turn its options.
struct Kind {
    const char* name;
    Ogre::ShadowCameraSetupPtr (*make)(Random& random);
    void (*turn)(Ogre::ShadowCameraSetup& setup, Random& random);
};

template <typename T>
Ogre::ShadowCameraSetupPtr plain(Random&) {
    return T::create();
}

template <typename T>
T& as(Ogre::ShadowCameraSetup& setup) {
    return dynamic_cast<T&>(setup);
}

Ogre::ShadowCameraSetupPtr makeCascades(Random& random) {
    Ogre::ShadowCameraSetupPtr technique;
    switch (random.below(4)) {
    case 0:
        return CascadesShadowCameraSetup::create();
    case 1:
        technique = XPSMShadowCameraSetup::create();
        break;
    case 2:
        technique = UniformShadowCameraSetup::create();
        as<UniformShadowCameraSetup>(*technique).setStable(true);
        break;
    default:
        technique = LiSPSMShadowCameraSetup::create();
        break;
    }
    return CascadesShadowCameraSetup::create(technique);
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
}

const std::array<Kind, 12> Kinds{{
    {"Uniform", plain<UniformShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<UniformShadowCameraSetup>(setup).setStable(random.oneIn(3));
     }},
    {"XPSM", plain<XPSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         auto& xpsm = as<XPSMShadowCameraSetup>(setup);
         xpsm.setStrength(random.of({0.0F, 1.0F, 2.0F, 10.0F}));
         xpsm.setEpsilonW(random.of({0.1F, 0.7F, 1.0F}));
         xpsm.setGuarded(!random.oneIn(3));
     }},
    {"Optimal", plain<OptimalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<OptimalShadowCameraSetup>(setup).setSamples(random.of({1, 64, 64, 300}));
         as<OptimalShadowCameraSetup>(setup).setEvaluations(random.of({8, 32, 100}));
     }},
    {"LiSPSM", plain<LiSPSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<LiSPSMShadowCameraSetup>(setup).setDistanceFactor(random.of({0.1F, 1.0F, 20.0F}));
     }},
    {"Trapezoidal", plain<TrapezoidalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<TrapezoidalShadowCameraSetup>(setup).setFocusDistance(random.between(0.05F, 0.9F));
         as<TrapezoidalShadowCameraSetup>(setup).setFocusShare(random.between(0.1F, 0.9F));
     }},
    {"PSM", plain<PSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<PSMShadowCameraSetup>(setup).setSlideBack(random.of({0.0F, 0.25F, 5.0F}));
     }},
    {"PlaneOptimal", plain<PlaneOptimalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         const Ogre::Vector3 normal(random.between(-1, 1), 1, random.between(-1, 1));
         as<PlaneOptimalShadowCameraSetup>(setup).setPlane(
             random.oneIn(2) ? Ogre::Plane(Ogre::Vector3::UNIT_Y, 0)
                             : Ogre::Plane(normal.normalisedCopy(), random.between(-5, 5)));
     }},
    {"Cascades", makeCascades,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         auto& cascades = as<CascadesShadowCameraSetup>(setup);
         cascades.setUniformity(random.of({0.0F, 0.5F, 1.0F}));
         cascades.setFollowReceivers(!random.oneIn(3));
         cascades.setSplitDepths(random.oneIn(4) ? std::vector<Ogre::Real>{3, 9, 30}
                                                 : std::vector<Ogre::Real>{});
     }},
    {"PostProjectiveCube", plain<PostProjectiveCubeShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<PostProjectiveCubeShadowCameraSetup>(setup).setSlideBack(
             random.of({0.0F, 0.25F, 5.0F}));
     }},
    {"PlaneOptimalExact", plain<PlaneOptimalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random&) {
         as<PlaneOptimalShadowCameraSetup>(setup).setExact(true);
     }},
    {"ObservedLiSPSM",
     [](Random&) -> Ogre::ShadowCameraSetupPtr {
         return ObservedShadowCameraSetup::create(
             std::make_shared<Ogre::LiSPSMShadowCameraSetup>());
     },
     [](Ogre::ShadowCameraSetup&, Random&) {}},
    {"ObservedDefault",
     [](Random&) -> Ogre::ShadowCameraSetupPtr {
         return ObservedShadowCameraSetup::create(
             std::make_shared<Ogre::DefaultShadowCameraSetup>());
     },
     [](Ogre::ShadowCameraSetup&, Random&) {}},
}};

constexpr std::size_t Exact = 9; ///< the first that may leave something unserved
constexpr std::size_t Cube = 8;

} // namespace

Ogre::ShadowCameraSetupPtr SetupRecipe::make() const {
    // What an instance is made of stays with it; its options may change later.
    Random random(kind);
    Ogre::ShadowCameraSetupPtr setup = Kinds[kind % Kinds.size()].make(random);
    apply(*setup);
    return setup;
}

void SetupRecipe::apply(Ogre::ShadowCameraSetup& setup) const {
    Random random(options);
    if (auto* const fitted = dynamic_cast<FittedShadowCameraSetup*>(&setup))
        turnCommon(*fitted, random);
    Kinds[kind % Kinds.size()].turn(setup, random);
}

std::string SetupRecipe::name() const {
    return Kinds[kind % Kinds.size()].name;
}

bool SetupRecipe::isExact() const {
    return kind % Kinds.size() < Exact;
}

bool SetupRecipe::isCube() const {
    return kind % Kinds.size() == Cube;
}

} // namespace Lixel::Tests
