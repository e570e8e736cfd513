#include "scene/SurveyCache.h"

#include "scene/OgreVersions.h"

#include <OgreCamera.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <chrono>
#include <map>
#include <memory>

namespace Lixel {
namespace {

/// One scene manager's survey, which ends with the preparation that it was taken for.
class CachedSurvey : public SceneManagerListener {
public:
    const TimedSurvey& get(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
                           double distance) {
        const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
        if (mCamera == &viewer && mViewport == &viewport && mFrame == frame && reaches(distance)) {
            mTimed.microseconds = 0.0;
            return mTimed;
        }
        const auto begin = std::chrono::steady_clock::now();
        mTimed.survey.take(viewer, viewport, distance);
        const std::chrono::duration<double, std::micro> passed =
            std::chrono::steady_clock::now() - begin;
        mTimed.microseconds = passed.count();
        mCamera = &viewer;
        mViewport = &viewport;
        mFrame = frame;
        mDistance = distance;
        return mTimed;
    }

    void end() { mCamera = nullptr; }
    void shadowTexturesUpdated(std::size_t) override { end(); }
    void sceneManagerDestroyed(Ogre::SceneManager* source) override;

private:
    bool reaches(double distance) const {
        return mDistance == 0.0 || (distance > 0.0 && distance <= mDistance);
    }

    TimedSurvey mTimed;
    const Ogre::Camera* mCamera = nullptr;
    const Ogre::Viewport* mViewport = nullptr;
    unsigned long mFrame = 0;
    /// 0: to the viewer's far plane.
    double mDistance = 0.0;
};

std::map<Ogre::SceneManager*, std::unique_ptr<CachedSurvey>>& cache() {
    static std::map<Ogre::SceneManager*, std::unique_ptr<CachedSurvey>> surveys;
    return surveys;
}

void CachedSurvey::sceneManagerDestroyed(Ogre::SceneManager* source) {
    cache().erase(source); // destroys this
}

} // namespace

const TimedSurvey& surveyFor(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
                             double shadowDistance) {
    Ogre::SceneManager* const manager = viewer.getSceneManager();
    std::unique_ptr<CachedSurvey>& entry = cache()[manager];
    if (!entry) {
        entry = std::make_unique<CachedSurvey>();
        addSceneManagerListener(*manager, *entry);
    }
    return entry->get(viewer, viewport, shadowDistance);
}

void endSurvey(Ogre::SceneManager& sceneManager) {
    const auto found = cache().find(&sceneManager);
    if (found != cache().end()) found->second->end();
}

void dropSurveys() {
    for (const auto& [manager, survey] : cache())
        removeSceneManagerListener(*manager, *survey);
    cache().clear();
}

} // namespace Lixel
