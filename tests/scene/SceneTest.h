#pragma once

#include "HeadlessOgre.h"

#include "scene/CasterSearch.h"
#include "scene/Survey.h"

#include <OgreAxisAlignedBox.h>
#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreMaterial.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreShadowCameraSetup.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace Lixel::Tests {

/// OGRE, once in the process.
HeadlessOgre& ogre();

/** An empty scene in the scene manager that the parameter names, with a viewer at the origin that
    looks along -z (90° high and wide, from 0.1 to 1000) and a tiny window to draw it in. */
class SceneTest : public testing::TestWithParam<std::string> {
protected:
    SceneTest();
    ~SceneTest() override;

    /// A cube of the given half extent. It casts, and receives as its material says.
    Ogre::Entity* addCube(const Ogre::Vector3& position, float halfExtent = 0.5f,
                          bool receives = true, Ogre::SceneNode* parent = nullptr);

    /// Begins another frame, brings boxes and positions up to date, as OGRE does before it prepares
    /// shadow textures, and surveys what the viewer sees.
    /// @param parts as Survey::take
    const Survey& takeSurvey(std::size_t parts = 0);
    /// The casters of the scene surveyed.
    const BoxSet& allCasters() { return mSearch.findAll(mSurvey); }

    /// One light, straight down unless told otherwise, with one shadow map and the given setup.
    Ogre::Light* addSun(const Ogre::ShadowCameraSetupPtr& setup,
                        const Ogre::Vector3& direction = Ogre::Vector3::NEGATIVE_UNIT_Y);

    Ogre::Root& mRoot = ogre().root();
    Ogre::SceneManager* mManager = nullptr;
    Ogre::SceneNode* mRootNode = nullptr;
    Ogre::Camera* mCamera = nullptr;
    Ogre::SceneNode* mCameraNode = nullptr;
    Ogre::Viewport* mViewport = nullptr;
    Survey mSurvey;
    CasterSearch mSearch;
};

/// A box of a set, back in the world.
Ogre::AxisAlignedBox worldBox(const Aabb& box, const Vec3& wsOrigin);

/// Whether the set holds the object's box as it is now, to a float's rounding.
bool holds(const BoxSet& set, const Survey& survey, const Ogre::MovableObject& object);

/// Calls a function for each shadow map where a setup is asked for its camera, and makes the map
/// as OGRE's default setup does.
class ProbeSetup : public Ogre::DefaultShadowCameraSetup {
public:
    using Probe = std::function<void(const Ogre::Camera& viewer, const Ogre::Viewport& viewport)>;
    explicit ProbeSetup(Probe probe) : mProbe(std::move(probe)) {}
    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override {
        mProbe(*viewer, *viewport);
        DefaultShadowCameraSetup::getShadowCamera(sceneManager, viewer, viewport, light,
                                                  shadowCamera, iteration);
    }

private:
    Probe mProbe;
};

} // namespace Lixel::Tests
