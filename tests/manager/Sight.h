#pragma once

#include "Heard.h"

#include <OgreRenderQueueListener.h>
#include <OgreSceneManager.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace Lixel::Tests {

/// What one camera was shown in one pass, as text.
struct Sight {
    std::string camera;
    /// Each renderable in the queue with its group, priority, pass, place, depth and lights.
    /// Sorted: a scene manager may find objects in any order.
    std::vector<std::string> queued;
    /// VisibleObjectsBoundsInfo of the camera, to the last bit.
    std::string bounds;
    /// The lights that affect the frustum, in order.
    std::string lights;
};

struct PartName {
    std::string name;
    /// Whether its depth is that in the camera that sees it. OGRE does not tell the parts of coarse
    /// meshes of other cameras: they keep the depth in a camera that had the same address.
    bool hasDepth;
};

/// What belongs to a world's objects.
using RenderableNames = std::unordered_map<const Ogre::Renderable*, PartName>;

/// The renderables of one of a world's objects, as "name#part".
void addRenderables(RenderableNames& names, Ogre::MovableObject& object, const std::string& name);

/// What the scene manager's current viewport is about to be drawn with.
Sight look(Ogre::SceneManager& manager, const RenderableNames& renderables, const Names& names);

/// The first difference, as text for people; empty where there is none.
std::string difference(const Sight& expected, const Sight& actual);

/// Of texts and how often each occurs: those that differ, up to a handful.
std::string difference(const std::map<std::string, int>& expected,
                       const std::map<std::string, int>& actual);

} // namespace Lixel::Tests
