#include "setup/LightNews.h"

#include "scene/Log.h"
#include "setup/InvalidInput.h"

#include <OgreLight.h>
#include <OgreRoot.h>

namespace Lixel {
namespace {

unsigned long thisFrame() {
    return Ogre::Root::getSingleton().getNextFrameNumber();
}

} // namespace

bool isTrouble(FitReason reason) {
    return reason >= FitReason::Unbounded || reason == FitReason::ViewWithoutEnd ||
           reason == FitReason::PartOfLight;
}

bool LightNews::isNew(Trouble trouble) {
    return mNews.isNew(trouble, thisFrame());
}

void LightNews::use() {
    mLastUse = thisFrame();
}

bool LightNews::isForgettable() const {
    const bool isUsed = thisFrame() - mLastUse <= News::Quiet;
    return mNews.isOver(thisFrame()) && !(toldOfParts && isUsed);
}

void LightNews::tell(const Ogre::Light& light, FitReason reason, const ShadowProblem& problem) {
    const bool isNotStable = reason == FitReason::ViewWithoutEnd;
    if (!isTrouble(reason)) return;
    if (!mNews.isNew(static_cast<unsigned>(reason), thisFrame())) return;
    if (isNotStable)
        return logWarning("the shadow map of light '" + light.getName() +
                          "' is not stable: " + toString(reason) +
                          "; set Light::setShadowFarDistance, or the viewer's far distance");
    constexpr const char* SixMaps =
        "; six maps are enough for any light (SceneManager::setShadowTextureCountPerLightType, an "
        "integrated shadow technique, and a material that reads as many)";
    if (reason == FitReason::PartOfLight)
        return logWarning(
            "light '" + light.getName() +
            "' shines too wide for the maps that it has: it casts shadows within a cone of "
            "160 degrees around what is seen, and all else is lit" +
            SixMaps);
    std::string message = "no shadow map for light '" + light.getName() + "': " + toString(reason);
    if (reason == FitReason::TooFewMaps) message += SixMaps;
    if (reason == FitReason::InvalidInput)
        if (const std::string which = describeInvalidInput(problem); !which.empty())
            message += ": " + which;
    logWarning(message);
}

void LightNews::tellWithoutBounds(const Ogre::Light& light, const std::string& body) {
    if (!isNew(BodyWithoutBounds)) return;
    logWarning("'" + body + "' has no bounds; the shadow map of light '" + light.getName() +
               "' is focused as if it were everywhere in view");
}

} // namespace Lixel
