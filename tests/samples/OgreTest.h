#pragma once

#include "common/Surface.h"

#include <Lixel/headless/Headless.h>

#include <Ogre.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace Lixel::Samples {

/// A root, and a stand-in for the material that the samples clone. With a render system and a tiny
/// window, because without their capabilities OGRE 14 crashes on any material with a texture.
class OgreTest : public ::testing::Test {
protected:
    OgreTest() {
        mLog.createLog("", true, false, true);
        const std::string error = Headless::enable();
        if (!error.empty()) throw std::runtime_error(error);
        mRoot = std::make_unique<Ogre::Root>("", "", "");
        mRoot->loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus");
        mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
        mRoot->initialise(false);
        Ogre::NameValuePairList parameters;
        for (const auto& [name, value] : Headless::windowParameters())
            parameters[name] = value;
        mRoot->createRenderWindow("window", 1, 1, false, &parameters);
        addSurfaceTemplate();
        scene = mRoot->createSceneManager();
        camera = scene->createCamera("viewer");
        scene->getRootSceneNode()->createChildSceneNode()->attachObject(camera);
        light = scene->createLight("sun");
        scene->getRootSceneNode()->createChildSceneNode()->attachObject(light);
    }

    ~OgreTest() override {
        mRoot->destroySceneManager(scene);
        Ogre::MeshManager::getSingleton().removeAll();
        mRoot.reset();
    }

    static void addSurfaceTemplate() {
        const auto material = Ogre::MaterialManager::getSingleton().create(
            SurfaceTemplate, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
        Ogre::Technique* technique = material->getTechnique(0);
        technique->getPass(0)->setIlluminationStage(Ogre::IS_AMBIENT);
        technique->createPass()->setIlluminationStage(Ogre::IS_PER_LIGHT);
        for (Ogre::Pass* pass : technique->getPasses())
            pass->createTextureUnitState();
    }

    Ogre::SceneNode& child(const Ogre::Vector3& position = Ogre::Vector3::ZERO) {
        return *scene->getRootSceneNode()->createChildSceneNode(position);
    }

private:
    Ogre::LogManager mLog;
    std::unique_ptr<Ogre::Root> mRoot;

protected:
    Ogre::SceneManager* scene = nullptr;
    Ogre::Camera* camera = nullptr;
    Ogre::Light* light = nullptr;
};

} // namespace Lixel::Samples
