#include "setup/Detach.h"

#include "scene/Identity.h"
#include "scene/SceneWatch.h"
#include "scene/SurveyCache.h"
#include "setup/LightGuard.h"
#include "setup/ShadowPass.h"
#include "setup/ViewerFeedback.h"

#include <OgreRoot.h>
#include <OgreSceneManager.h>

namespace Lixel {

void detachFromOgre() {
    unguardLights();
    unwatchScenes();
    dropSurveys();
    forgetFeedback();
    forgetShadowPasses();
    for (const auto& [name, sceneManager] : Ogre::Root::getSingleton().getSceneManagers())
        forgetIdentities(*sceneManager);
}

} // namespace Lixel
