#include "scene/CasterSearch.h"

#include "fit/focus/ViewVolume.h"
#include "scene/OgreMath.h"

#include <OgreMovableObject.h>

namespace Lixel {

const BoxSet& CasterSearch::find(const Survey& survey, const ShadowLight& light,
                                 double shadowDistance, double margin) {
    const BoxSet& receivers = survey.receivers();
    if (receivers.unbounded() > 0) return findAll(survey);
    clear(survey);
    ShadowViewer viewer = survey.viewer();
    viewer.shadowDistance = shadowDistance;
    viewer = widened(viewer, margin);
    if (!receivers.empty() && receivers.invalid() == 0 && CasterSweep::isUsable(light) &&
        mReach.set(viewer, light, survey.receiverBounds(), survey.wsOrigin()))
        collect(survey, mReach.volume());
    return mCasters;
}

const BoxSet& CasterSearch::findIn(const Survey& survey, const NodeCuller& volume) {
    clear(survey);
    collect(survey, volume);
    return mCasters;
}

const BoxSet& CasterSearch::findAll(const Survey& survey) {
    return findIn(survey, NodeCuller());
}

void CasterSearch::clear(const Survey& survey) {
    mCasters.clear();
    mUnboundedName.clear();
    mShapes.reset(survey.meshes(), survey.wsOrigin());
}

void CasterSearch::collect(const Survey& survey, const NodeCuller& volume) {
    std::size_t guess = 0;
    for (const auto& [object, touches] : mWalk.collect(survey.rules().sceneManager(), volume))
        if (touches || !volume.excludes(object->getWorldBoundingBox(), guess)) add(survey, *object);
}

void CasterSearch::add(const Survey& survey, const Ogre::MovableObject& object) {
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull() || !survey.rules().draws(object) || !survey.rules().casts(object)) return;
    if (bounds.isInfinite()) {
        mCasters.addUnbounded();
        mUnboundedName = object.getName();
        return;
    }
    const std::size_t index = mCasters.size();
    mCasters.add(relativeBox(bounds, survey.wsOrigin()));
    if (mCasters.size() > index)
        mShapes.add(object);
    else
        mUnboundedName = object.getName(); // finite, and too large to have bounds
}

} // namespace Lixel
