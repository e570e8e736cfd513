#include "scene/SurveyCache.h"

#include "scene/PerScene.h"

#include <OgreCamera.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <chrono>

namespace Lixel {
namespace {

/// One scene manager's survey, which ends with the preparation that it was taken for.
class CachedSurvey : public SceneManagerListener {
public:
    const TimedSurvey& get(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
                           double distance, double margin, std::size_t parts) {
        const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
        if (mCamera == &viewer && mViewport == &viewport && mFrame == frame &&
            reaches(distance, margin) && parts <= mParts) {
            mTimed.microseconds = 0.0;
            // A map was drawn meanwhile, to listeners of the application's.
            mTimed.survey.forgetObjects();
            return mTimed;
        }
        const auto begin = std::chrono::steady_clock::now();
        mTimed.survey.take(viewer, viewport, distance, margin, parts);
        const std::chrono::duration<double, std::micro> passed =
            std::chrono::steady_clock::now() - begin;
        mTimed.microseconds = passed.count();
        mCamera = &viewer;
        mViewport = &viewport;
        mFrame = frame;
        mDistance = distance;
        mMargin = margin;
        mParts = parts;
        return mTimed;
    }

    void end() { mCamera = nullptr; }
    void shadowTexturesUpdated(std::size_t) override { end(); }

private:
    bool reaches(double distance, double margin) const {
        return margin <= mMargin && (mDistance == 0.0 || (distance > 0.0 && distance <= mDistance));
    }

    TimedSurvey mTimed;
    const Ogre::Camera* mCamera = nullptr;
    const Ogre::Viewport* mViewport = nullptr;
    unsigned long mFrame = 0;
    /// 0: to the viewer's far plane.
    double mDistance = 0.0;
    double mMargin = 0.0;
    std::size_t mParts = 0;
};

PerScene<CachedSurvey>& cache() {
    static PerScene<CachedSurvey> surveys;
    return surveys;
}

} // namespace

const TimedSurvey& surveyFor(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
                             double shadowDistance, double margin, std::size_t parts) {
    return cache()
        .of(*viewer.getSceneManager())
        .listener.get(viewer, viewport, shadowDistance, margin, parts);
}

void endSurvey(Ogre::SceneManager& sceneManager) {
    if (CachedSurvey* const survey = cache().find(sceneManager)) survey->end();
}

void dropSurveys() {
    cache().clear();
}

} // namespace Lixel
