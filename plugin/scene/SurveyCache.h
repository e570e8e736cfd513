#pragma once

#include "scene/Survey.h"

namespace Lixel {

/// A survey and what it took to make it.
struct TimedSurvey {
    Survey survey;
    /// CPU time of taking it in microseconds, 0 where an earlier call took it.
    double microseconds = 0.0;
};

/** The survey of this preparation of shadow textures, taken on the first call.

    One survey serves all lights of one preparation: it stays valid until the scene manager has
    updated its shadow textures, or another camera or frame begins. Neither frame number nor camera
    alone would do: a camera can be drawn twice a frame, into two targets, with moved objects. A
    light whose shadows reach farther than those of the ones before it has it taken again, and so
    has one whose maps have a wider margin, or that wants meshes in more parts.

    @param shadowDistance as ShadowViewer::shadowDistance; the survey reaches as far, or farther
    @param margin as Survey::take; the survey is as wide, or wider
    @param parts as Survey::take; the survey has as many, or more
    @return a reference that holds until the next call for the same scene manager.
*/
LIXEL_API const TimedSurvey& surveyFor(const Ogre::Camera& viewer, const Ogre::Viewport& viewport,
                                       double shadowDistance, double margin = 0.0,
                                       std::size_t parts = 0);

/// Ends a scene manager's survey, for requests outside of a preparation: nothing tells when objects
/// move or go after them.
LIXEL_API void endSurvey(Ogre::SceneManager& sceneManager);

/// Forgets all surveys, and leaves nothing behind in scene managers.
LIXEL_API void dropSurveys();

} // namespace Lixel
