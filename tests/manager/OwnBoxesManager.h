#pragma once

#include <OgreSceneManager.h>

#include <array>
#include <memory>
#include <ostream>
#include <string>

namespace Lixel::Tests {

/** OGRE's own scene manager with CullingRule::OwnBoxes, in as few lines as possible: what a flat
    scene manager has to show, found by walking the scene graph.

    A node's box is that of its own objects, and each node in the scene graph is asked alone, in the
    order of the graph. All else is OGRE's. */
inline const std::string OwnBoxesManager = "OwnBoxesManager";

/// Faults that a flat scene manager may have. A test of the tests sees each of them found.
enum class Fault {
    None,
    SecondObjects,   ///< of a node's objects it knows the first
    LeftNodes,       ///< it shows nodes that have left the scene graph
    LateBoxes,       ///< boxes are those of the frame before
    NoInfiniteBoxes, ///< infinite boxes are not shown
    NoNotification,  ///< objects are not told which camera sees them
    NoBounds,        ///< no bounds of what is visible
    NoDebugDrawing,  ///< nodes' axes and boxes are not drawn
    LooseFrustum,    ///< what touches the bounding sphere of the frustum is in it
};

/// For the names of tests.
std::ostream& operator<<(std::ostream& out, Fault fault);

/// The type's name of a scene manager with a fault, else as OwnBoxesManager.
std::string faultyManager(Fault fault);

inline constexpr std::array AllFaults{
    Fault::SecondObjects,  Fault::LeftNodes, Fault::LateBoxes,      Fault::NoInfiniteBoxes,
    Fault::NoNotification, Fault::NoBounds,  Fault::NoDebugDrawing, Fault::LooseFrustum};

/// For faultyManager(fault); without a fault, for OwnBoxesManager.
std::unique_ptr<Ogre::SceneManagerFactory> makeOwnBoxesFactory(Fault fault);

} // namespace Lixel::Tests
