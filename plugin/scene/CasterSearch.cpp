#include "scene/CasterSearch.h"

#include "scene/NodeWalk.h"
#include "scene/OgreMath.h"

#include <OgreMovableObject.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

namespace Lixel {
namespace {

/// The object at the end of a way, if there still is one.
const Ogre::MovableObject* follow(const std::vector<std::size_t>& way,
                                  const Ogre::SceneNode& root) {
    if (way.empty()) return nullptr;
    const Ogre::SceneNode* node = &root;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const auto& children = node->getChildren();
        if (way[i] >= children.size()) return nullptr;
        node = static_cast<const Ogre::SceneNode*>(children[way[i]]);
    }
    const auto& objects = node->getAttachedObjects();
    return way.back() < objects.size() ? objects[way.back()] : nullptr;
}

} // namespace

const BoxSet& CasterSearch::find(const Survey& survey, const ShadowLight& light,
                                 double shadowDistance) {
    const BoxSet& receivers = survey.receivers();
    if (receivers.unbounded() > 0) return findAll(survey);
    clear(survey);
    ShadowViewer viewer = survey.viewer();
    viewer.shadowDistance = shadowDistance;
    if (!receivers.empty() && receivers.invalid() == 0 && CasterSweep::isUsable(light) &&
        mReach.set(viewer, light, survey.receiverBounds(), survey.wsOrigin()))
        collect(survey, mReach.volume());
    if (mCasters.empty() && mCasters.invalid() == 0) addWitness(survey);
    return mCasters;
}

const BoxSet& CasterSearch::findAll(const Survey& survey) {
    clear(survey);
    collect(survey, NodeCuller());
    return mCasters;
}

void CasterSearch::clear(const Survey& survey) {
    mCasters.clear();
    mShapes.reset(survey.meshes(), survey.wsOrigin());
}

void CasterSearch::collect(const Survey& survey, const NodeCuller& volume) {
    const bool culled = collectNodes(survey.rules().sceneManager(), volume, mNodes);
    std::size_t guess = 0;
    for (const Ogre::SceneNode* node : mNodes) {
        for (const Ogre::MovableObject* object : node->getAttachedObjects()) {
            const Ogre::AxisAlignedBox& bounds = object->getWorldBoundingBox();
            if ((culled && bounds == node->_getWorldAABB()) || !volume.excludes(bounds, guess))
                add(survey, *object);
        }
    }
}

bool CasterSearch::add(const Survey& survey, const Ogre::MovableObject& object) {
    const Ogre::AxisAlignedBox& bounds = object.getWorldBoundingBox();
    if (bounds.isNull() || !survey.rules().draws(object) || !survey.rules().casts(object))
        return false;
    if (bounds.isInfinite()) {
        mCasters.addUnbounded();
        return true;
    }
    const std::size_t index = mCasters.size();
    mCasters.add(relativeBox(bounds, survey.wsOrigin()));
    if (mCasters.size() > index) mShapes.add(object);
    return true;
}

void CasterSearch::addWitness(const Survey& survey) {
    Ogre::SceneNode& root = *survey.rules().sceneManager().getRootSceneNode();
    const Ogre::MovableObject* const last = follow(mWitness, root);
    if (last != nullptr && add(survey, *last)) return;
    mWitness.clear();
    searchWitness(survey, root);
}

bool CasterSearch::searchWitness(const Survey& survey, Ogre::SceneNode& node) {
    const auto& objects = node.getAttachedObjects();
    const auto& children = node.getChildren();
    const std::size_t depth = mWitness.size();
    mWitness.push_back(0);
    for (std::size_t& i = mWitness[depth]; i < objects.size(); ++i)
        if (add(survey, *objects[i])) return true;
    for (std::size_t i = 0; i < children.size(); ++i) {
        mWitness[depth] = i;
        if (searchWitness(survey, static_cast<Ogre::SceneNode&>(*children[i]))) return true;
    }
    mWitness.pop_back();
    return false;
}

} // namespace Lixel
