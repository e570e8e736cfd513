#include "SetupRecipe.h"

#include "Random.h"

#include <Lixel/setup/ShadowCameraSetups.h>

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
        technique = UniformShadowCameraSetup::create({.stable = true});
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
         as<UniformShadowCameraSetup>(setup).setOptions({.stable = random.oneIn(3)});
     }},
    {"XPSM", plain<XPSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<XPSMShadowCameraSetup>(setup).setOptions({.strength = random.of({0.0, 1.0, 2.0, 10.0}),
                                                      .epsilonW = random.of({0.1, 0.7, 1.0}),
                                                      .guarded = !random.oneIn(3)});
     }},
    {"Optimal", plain<OptimalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<OptimalShadowCameraSetup>(setup).setOptions(
             {.samples = random.of({1, 64, 64, 300}), .evaluations = random.of({8, 32, 100})});
     }},
    {"LiSPSM", plain<LiSPSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<LiSPSMShadowCameraSetup>(setup).setOptions(
             {.distanceFactor = random.of({0.1, 1.0, 20.0})});
     }},
    {"Trapezoidal", plain<TrapezoidalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<TrapezoidalShadowCameraSetup>(setup).setOptions(
             {.focusDistance = static_cast<double>(random.between(0.05F, 0.9F)),
              .focusShare = static_cast<double>(random.between(0.1F, 0.9F))});
     }},
    {"PSM", plain<PSMShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<PSMShadowCameraSetup>(setup).setOptions({.slideBack = random.of({0.0, 0.25, 5.0})});
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
         const auto depths = random.oneIn(4) ? std::vector{3.0, 9.0, 30.0} : std::vector<double>();
         as<CascadesShadowCameraSetup>(setup).setOptions({.uniformity = random.of({0.0, 0.5, 1.0}),
                                                          .followReceivers = !random.oneIn(3),
                                                          .vsSplitDepths = depths});
     }},
    {"PostProjectiveCube", plain<PostProjectiveCubeShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random& random) {
         as<PostProjectiveCubeShadowCameraSetup>(setup).setOptions(
             {.slideBack = random.of({0.0, 0.25, 5.0})});
     }},
    {"PlaneOptimalExact", plain<PlaneOptimalShadowCameraSetup>,
     [](Ogre::ShadowCameraSetup& setup, Random&) {
         as<PlaneOptimalShadowCameraSetup>(setup).setOptions({.exact = true});
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
