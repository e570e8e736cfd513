#pragma once

#include <OgreLogManager.h>
#include <OgreMaterial.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

#include <memory>
#include <string>

namespace Lixel::Tests {

inline const std::string DefaultManager = "DefaultSceneManager";
inline const std::string OctreeManager = "OctreeSceneManager";

/// A scene manager of an application's own: nothing is known of it except its scene graph.
inline const std::string OtherManager = "OtherSceneManager";

/// Lixel's own.
inline const std::string FlatManager = "LixelSceneManager";

/// OGRE with the GL3+ render system, all of these scene managers, and a tiny window without display.
class HeadlessOgre {
public:
    /// @exception std::runtime_error saying why it cannot draw headless
    HeadlessOgre();

    Ogre::Root& root() { return *mRoot; }
    Ogre::RenderWindow& window() { return *mWindow; }

private:
    std::unique_ptr<Ogre::LogManager> mLogs;
    std::unique_ptr<Ogre::SceneManagerFactory> mOther;
    std::unique_ptr<Ogre::SceneManagerFactory> mFlat;
    std::unique_ptr<Ogre::Root> mRoot;
    Ogre::RenderWindow* mWindow = nullptr;
};

/// Materials that GL3+ can draw with, made on first use. Both draw one flat colour.
Ogre::MaterialPtr flatMaterial(bool receivesShadows);

/// Name of a cube of size 1 about its origin, made on first use. `manager` lends a hand.
std::string cubeMesh(Ogre::SceneManager& manager);

} // namespace Lixel::Tests
