#include "common/Setups.h"

#include <Lixel/material/ShadowParameters.h>
#include <Lixel/setup/SetupList.h>
#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreLight.h>
#include <OgreMovablePlane.h>
#include <OgreShadowCameraSetupFocused.h>
#include <OgreShadowCameraSetupLiSPSM.h>
#include <OgreShadowCameraSetupPSSM.h>
#include <OgreShadowCameraSetupPlaneOptimal.h>

#include <stdexcept>

namespace Lixel::Samples {
namespace {

/// OGRE's setup keeps a pointer to its plane; this one brings the plane along.
class GroundOptimalSetup : private Ogre::MovablePlane, public Ogre::PlaneOptimalShadowCameraSetup {
public:
    GroundOptimalSetup()
        : Ogre::MovablePlane(Ogre::Vector3::UNIT_Y, 0), Ogre::PlaneOptimalShadowCameraSetup(this) {}
};

/// OGRE's parallel splits, made for each viewer: what OGRE's sample does by hand.
class SplitSetup : public Ogre::PSSMShadowCameraSetup {
public:
    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override {
        // The splits are the viewer's, which the setup is not told when it is made; OGRE calls
        // this const but keeps it as any other option.
        const_cast<SplitSetup*>(this)->setSplits(*viewer,
                                                 reachOf(*viewer, light->getShadowFarDistance()));
        PSSMShadowCameraSetup::getShadowCamera(sceneManager, viewer, viewport, light, shadowCamera,
                                               iteration);
    }
    virtual void setSplits(const Ogre::Camera& viewer, Ogre::Real shadowDistance) = 0;

    /// How far shadows reach, also where there is no shadow distance (0).
    static Ogre::Real reachOf(const Ogre::Camera& viewer, Ogre::Real shadowDistance) {
        return shadowDistance > 0 ? shadowDistance : viewer.getFarClipDistance();
    }
};

/// Only the first split is drawn, and it holds all; fewer than two are refused.
class OneSplitSetup : public SplitSetup {
public:
    OneSplitSetup() { setSplitPoints({1, 100, 200}); }
    void setSplits(const Ogre::Camera& viewer, Ogre::Real shadowDistance) override {
        setSplitPoints({viewer.getNearClipDistance(), shadowDistance, 2 * shadowDistance});
    }
};

/// OGRE's default is 0.1; 1 is what Wimmer et al. 2004 derive.
class FactorOneLiSPSMSetup : public Ogre::LiSPSMShadowCameraSetup {
public:
    FactorOneLiSPSMSetup() { setOptimalAdjustFactor(1); }
};

class OptimalLiSPSMSetup : public Ogre::LiSPSMShadowCameraSetup {
public:
    OptimalLiSPSMSetup() {
        setUseSimpleOptimalAdjust(false);
        setOptimalAdjustFactor(1);
    }
};

constexpr std::size_t SplitCount = 3;

/// Splits between the viewer's near plane and the shadow distance, as OGRE's sample has them.
class ThreeSplitSetup : public SplitSetup {
public:
    ThreeSplitSetup() {
        setOptimalAdjustFactor(0, 2);
        setOptimalAdjustFactor(1, 1);
        setOptimalAdjustFactor(2, Ogre::Real(0.5));
    }
    void setSplits(const Ogre::Camera& viewer, Ogre::Real shadowDistance) override {
        setSplitPadding(viewer.getNearClipDistance());
        calculateSplitPoints(SplitCount, viewer.getNearClipDistance(), shadowDistance);
    }
};

/** Tells Lixel's receivers which split serves them: OGRE's materials compare their depth in front
    of the viewer with the splits' depths, Lixel's look for the greatest of the maps' functions. */
class ObservedSplits : public ObservedShadowCameraSetup {
public:
    explicit ObservedSplits(const std::shared_ptr<ThreeSplitSetup>& splits)
        : ObservedShadowCameraSetup(splits, 0), mSplits(splits) {}

    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override {
        ObservedShadowCameraSetup::getShadowCamera(sceneManager, viewer, viewport, light,
                                                   shadowCamera, iteration);
        // Sums of depth - split: the one of the next map grows past the one before where the depth
        // passes the split between them.
        const auto& depths = mSplits->getSplitPoints();
        const auto maps = static_cast<Ogre::Real>(iteration);
        Ogre::Vector4 share = -maps * Ogre::Vector4(viewer->getViewMatrix(true)[2]);
        for (std::size_t i = 1; i <= iteration; ++i)
            share.w -= depths.at(i);
        // OGRE hands out its own, mutable light as const.
        const_cast<Ogre::Light*>(light)->setCustomParameter(
            static_cast<Ogre::uint16>(LP_MAP_ROW_SHARE + LP_MAP_STEP * iteration), share);
    }

private:
    std::shared_ptr<ThreeSplitSetup> mSplits;
};

NamedSetup threeSplits() {
    NamedSetup setup;
    setup.name = "Ogre-PSSM-3";
    setup.title = "OGRE: parallel split, three splits";
    setup.create = [] {
        return std::make_shared<ObservedSplits>(std::make_shared<ThreeSplitSetup>());
    };
    setup.maps = SplitCount;
    setup.splitDepths = [](const Ogre::Camera& viewer, double shadowDistance) {
        ThreeSplitSetup splits;
        splits.setSplits(viewer,
                         SplitSetup::reachOf(viewer, static_cast<Ogre::Real>(shadowDistance)));
        return std::vector<double>(splits.getSplitPoints().begin(), splits.getSplitPoints().end());
    };
    return setup;
}

/// One of Lixel's own.
NamedSetup lixel(std::string_view kind) {
    const SetupKind& found = *findSetupKind(kind);
    return {std::string(found.name), "Lixel: " + std::string(found.title), found.create};
}

template <typename T>
NamedSetup ogre(const std::string& name, const std::string& title) {
    return {name, title, [] { return ObservedShadowCameraSetup::create(std::make_shared<T>()); }};
}

const NamedSetup* find(const std::vector<NamedSetup>& setups, const std::string& name) {
    for (const NamedSetup& setup : setups)
        if (setup.name == name) return &setup;
    return nullptr;
}

NamedSetup severalMaps(const std::string& name, const std::string& title, std::size_t maps,
                       const std::function<Ogre::ShadowCameraSetupPtr()>& create) {
    NamedSetup setup{name, title, create};
    setup.maps = maps;
    return setup;
}

Ogre::ShadowCameraSetupPtr createStable() {
    return UniformShadowCameraSetup::create({.stable = true});
}

Ogre::ShadowCameraSetupPtr createStableCascades() {
    return CascadesShadowCameraSetup::create(createStable(), {.followReceivers = false});
}

/// What a list of options lets one set.
std::string describe(std::span<const Option> options) {
    std::string text;
    for (const Option& option : options)
        text += "\n  " + std::string(option.keyword) + ": " + describeValues(option);
    return text;
}

/// The options of one of Lixel's setups, and their values, in lines; empty for OGRE's own.
std::string describeOptions(const NamedSetup& setup) {
    const SetupKind* const kind = findSetupKind(setup.name);
    return kind == nullptr ? std::string()
                           : describe(kind->options) + describe(CommonOptions::declared());
}

} // namespace

const std::vector<NamedSetup>& shadowSetups() {
    static const std::vector<NamedSetup> setups = [] {
        std::vector<NamedSetup> all;
        for (const FitTechnique* const technique : techniques())
            all.push_back(lixel(technique->name));
        all.insert(
            all.end(),
            {
                ogre<Ogre::DefaultShadowCameraSetup>("Ogre-Default", "OGRE: uniform"),
                ogre<Ogre::FocusedShadowCameraSetup>("Ogre-Focused", "OGRE: uniform, focused"),
                ogre<Ogre::LiSPSMShadowCameraSetup>("Ogre-LiSPSM", "OGRE: light space perspective"),
                ogre<OptimalLiSPSMSetup>("Ogre-LiSPSM-Optimal",
                                         "OGRE: light space perspective, its optimal parameter"),
                ogre<OneSplitSetup>("Ogre-PSSM", "OGRE: parallel split, one split"),
                ogre<GroundOptimalSetup>("Ogre-PlaneOptimal", "OGRE: optimal for the ground plane"),
            });
        return all;
    }();
    return setups;
}

const std::vector<NamedSetup>& emulatedSetups() {
    static const std::vector<NamedSetup> setups = [] {
        std::vector<NamedSetup> all = shadowSetups();
        all.push_back(ogre<FactorOneLiSPSMSetup>("Ogre-LiSPSM-1",
                                                 "OGRE: light space perspective, adjust factor 1"));
        all.push_back(threeSplits());
        all.push_back({"Stable", "Lixel: uniform, steady texels", createStable});
        const auto optimalSlices = [] { return CascadesShadowCameraSetup::create(); };
        all.push_back(severalMaps("Cascades-2", "Lixel: optimal, two slices", 2, optimalSlices));
        all.push_back(severalMaps("Cascades-3", "Lixel: optimal, three slices", 3, optimalSlices));
        all.push_back(severalMaps("XPSM-Cascades-2", "Lixel: XPSM, two slices", 2, [] {
            return CascadesShadowCameraSetup::create(XPSMShadowCameraSetup::create());
        }));
        all.push_back(severalMaps("Uniform-Cascades-3", "Lixel: uniform, three slices", 3, [] {
            return CascadesShadowCameraSetup::create(UniformShadowCameraSetup::create());
        }));
        all.push_back(severalMaps("Stable-Cascades-3", "Lixel: stable, three slices", 3,
                                  createStableCascades));
        all.push_back(severalMaps("Cube", "Lixel: cube map of post-projective space", 6,
                                  [] { return PostProjectiveCubeShadowCameraSetup::create(); }));
        return all;
    }();
    return setups;
}

const NamedSetup* findShadowSetup(const std::string& name) {
    return find(shadowSetups(), name);
}

const NamedSetup* findEmulatedSetup(const std::string& name) {
    return find(emulatedSetups(), name);
}

NamedSetup withOptions(const NamedSetup& setup, const std::vector<std::string>& assignments) {
    if (assignments.empty()) return setup;
    NamedSetup result = setup;
    result.create = [create = setup.create, assignments] {
        Ogre::ShadowCameraSetupPtr made = create();
        auto& options = dynamic_cast<FittedShadowCameraSetup&>(*made);
        for (const std::string& assignment : assignments) {
            const std::size_t equals = assignment.find('=');
            if (equals == std::string::npos)
                throw std::invalid_argument("'" + assignment + "' is not KEYWORD=VALUE");
            const std::string keyword = assignment.substr(0, equals);
            options.setParameter(keyword, assignment.substr(equals + 1));
        }
        return made;
    };
    return result;
}

std::string wrongAssignment(const NamedSetup& setup, const std::vector<std::string>& assignments) {
    if (assignments.empty()) return {};
    const std::string known = describeOptions(setup);
    // OGRE's own could not even be made before there is a Root.
    if (known.empty()) return "setup '" + setup.name + "' has no options that can be set";
    std::string wrong;
    try {
        withOptions(setup, assignments).create();
        return {};
    } catch (const Ogre::Exception& error) {
        wrong = error.getDescription();
    } catch (const std::invalid_argument& error) {
        wrong = error.what();
    }
    return "setup '" + setup.name + "': " + wrong + "; its options are" + known;
}

} // namespace Lixel::Samples
