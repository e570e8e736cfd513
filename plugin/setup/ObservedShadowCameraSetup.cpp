#include "setup/ObservedShadowCameraSetup.h"

#include "scene/OgreMath.h"
#include "scene/OgreVersions.h"
#include "setup/ShadowMapObserver.h"
#include "setup/ShadowPass.h"

#include <Eigen/LU>

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>
#include <OgreStringConverter.h>
#include <OgreViewport.h>

#include <chrono>
#include <cmath>

namespace Lixel {
namespace {

/// A map whose clip w grows beyond this multiple of its least is clamped there: farther points
/// share the last depths, instead of all points sharing a few.
constexpr double GreatestSpread = 1e5;

/// Range of w in the map's own volume: w = 1 / (fourth coordinate of the unprojected corner).
Vec2 rangeOfW(const Mat4& worldFromClip) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0.0;
    for (int i = 0; i < 8; ++i) {
        const Vec4 corner((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                          (i & 4) != 0 ? 1.0 : -1.0, 1.0);
        const double inverse = worldFromClip.row(3).dot(corner);
        if (inverse > 0.0) {
            least = std::min(least, 1.0 / inverse);
            greatest = std::max(greatest, 1.0 / inverse);
        } else {
            greatest = std::numeric_limits<double>::infinity();
        }
    }
    return {least, std::min(greatest, GreatestSpread * least)};
}

} // namespace

std::shared_ptr<ObservedShadowCameraSetup>
ObservedShadowCameraSetup::create(const Ogre::ShadowCameraSetupPtr& inner, Ogre::Real depthBias) {
    return std::make_shared<ObservedShadowCameraSetup>(inner, depthBias);
}

ObservedShadowCameraSetup::ObservedShadowCameraSetup(const Ogre::ShadowCameraSetupPtr& inner,
                                                     Ogre::Real depthBias)
    : mInner(inner), mDepthBias(depthBias) {
    if (!inner)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "inner: there is no setup to observe in a null pointer",
                    "ObservedShadowCameraSetup::create");
    if (!std::isfinite(depthBias) || depthBias < 0)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "depthBias: a number of world units, at least 0, not " +
                        Ogre::StringConverter::toString(depthBias),
                    "ObservedShadowCameraSetup::create");
}

void ObservedShadowCameraSetup::getShadowCamera(const Ogre::SceneManager* sceneManager,
                                                const Ogre::Camera* viewer,
                                                const Ogre::Viewport* viewport,
                                                const Ogre::Light* light,
                                                Ogre::Camera* shadowCamera,
                                                std::size_t iteration) const {
    const auto begin = std::chrono::steady_clock::now();
    mInner->getShadowCamera(sceneManager, viewer, viewport, light, shadowCamera, iteration);
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - begin;
    if (shadowTargetsFrom(*shadowCamera, *viewer->getSceneManager()).empty()) return;

    ShadowFit fit;
    fit.reason = FitReason::None;
    fit.directional = light->getType() == Ogre::Light::LT_DIRECTIONAL;
    fit.clipFromWorld = toDouble(shadowCamera->getProjectionMatrix()) *
                        toDouble(Ogre::Matrix4(shadowCamera->getViewMatrix(true)));
    const Vec2 w = rangeOfW(fit.clipFromWorld.inverse());
    if (!fit.clipFromWorld.allFinite() || !w.allFinite() || !(w.y() > 0.0))
        fit.reason = FitReason::InvalidInput;
    // -w <= z <= w in the map's volume, so this is within 0 and 1.
    fit.depthScale = 0.5 / w.y();
    fit.depthOffset = 0.5;
    Vec3 axis =
        toDouble(light->getType() == Ogre::Light::LT_POINT ? shadowCamera->getDerivedDirection()
                                                           : light->getDerivedDirection());
    fit.depthPerWorldUnit =
        std::abs(fit.depthScale * fit.clipFromWorld.row(2).head<3>().dot(axis.normalized()));

    static const ShadowPart everything;
    static const MapDecision drawn{MapPlan::Draw, PlanReason::NotPlanned, {}};
    publishShadowMap({.sceneManager = *viewer->getSceneManager(),
                      .viewer = *viewer,
                      // OGRE hands out its own, mutable light as const.
                      .light = const_cast<Ogre::Light&>(*light),
                      .shadowCamera = *shadowCamera,
                      .iteration = iteration,
                      .part = everything,
                      .fit = fit,
                      .decision = drawn,
                      .wsOrigin = Vec3::Zero(),
                      .width = shadowCamera->getViewport()->getActualWidth(),
                      .height = shadowCamera->getViewport()->getActualHeight(),
                      .depthBias = static_cast<double>(mDepthBias),
                      .surveyMicroseconds = 0.0,
                      .casterMicroseconds = 0.0,
                      .fitMicroseconds = passed.count()});
}

} // namespace Lixel
