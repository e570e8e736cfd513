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
    const SceneRules& rules = survey.rules();
    NodeStore* const store = findStore(rules.sceneManager());
    if (store != nullptr) store->beginReading(rules.fingerprint());
    std::size_t guess = 0;
    for (const auto& [object, touches, slot, known] : mWalk.collect(rules.sceneManager(), volume)) {
        if ((known & NodeStore::CastsKnown) != 0) {
            if ((known & NodeStore::Casts) != 0)
                addCaster(*object, store->box(slot), survey.wsOrigin());
            continue;
        }
        if (!touches && volume.excludes(object->getWorldBoundingBox(), guess)) continue;
        const bool casts = rules.draws(*object) && rules.casts(*object);
        if (SceneRules::canBeKnown(*object, store, slot))
            store->know(slot, NodeStore::CastsKnown | (casts ? unsigned{NodeStore::Casts} : 0U));
        if (casts) addCaster(*object, object->getWorldBoundingBox(), survey.wsOrigin());
    }
}

void CasterSearch::addCaster(const Ogre::MovableObject& object, const Ogre::AxisAlignedBox& bounds,
                             const Vec3& wsOrigin) {
    if (bounds.isNull()) return;
    if (bounds.isInfinite()) {
        mCasters.addUnbounded();
        mUnboundedName = object.getName();
        return;
    }
    const std::size_t index = mCasters.size();
    mCasters.add(relativeBox(bounds, wsOrigin));
    if (mCasters.size() > index)
        mShapes.add(object);
    else
        mUnboundedName = object.getName(); // finite, and too large to have bounds
}

} // namespace Lixel
