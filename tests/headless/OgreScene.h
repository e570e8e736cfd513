#pragma once

// An OGRE root with one render system and no files: enough to draw a rectangle and read it back.

#include <OgreCamera.h>
#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreImage.h>
#include <OgreLogManager.h>
#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

namespace Lixel::Tests {

/// Built with EGL, OGRE makes the contexts itself, and OSMesa has no part in it.
inline constexpr bool usesEgl = LIXEL_OGRE_USES_EGL != 0;
inline constexpr const char* onlyWithGlx = "OGRE was built with EGL";

using Parameters = std::map<std::string, std::string>;

/// A root with a render system that has been initialised, but has no window.
class OgreScene {
public:
    /// @param renderSystem the plugin's name, for instance "RenderSystem_GL3Plus"
    /// @param windows how many there will be
    explicit OgreScene(const std::string& renderSystem, int windows = 1) {
        // Made before Root, which would else write Ogre.log.
        mLogs.createLog("", true, false, true);
        mRoot = std::make_unique<Ogre::Root>("", "", "");
        mRoot->loadPlugin(OGRE_PLUGIN_DIR "/" + renderSystem);
        mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
        // What Lixel::Headless::windowParameters says of several windows.
        if (windows > 1) mRoot->getRenderSystem()->setConfigOption("Separate Shader Objects", "No");
        mRoot->initialise(false);
    }

    Ogre::Root& root() { return *mRoot; }

    /// Make a window, and at the first one what is drawn: see addRectangle.
    Ogre::RenderWindow* createWindow(const std::string& name, unsigned width, unsigned height,
                                     const Parameters& parameters) {
        Ogre::RenderWindow* window =
            mRoot->createRenderWindow(name, width, height, false, &parameters);
        if (!mScene) {
            mScene = mRoot->createSceneManager();
            mCamera = mScene->createCamera("camera");
            mScene->getRootSceneNode()->attachObject(mCamera);
            createMaterials();
        }
        return window;
    }

    /// Add a rectangle of one colour in normalised device coordinates, which have y up and z away.
    void addRectangle(float left, float bottom, float right, float top, float depth,
                      const Ogre::ColourValue& colour) {
        Ogre::ManualObject* rectangle = mScene->createManualObject();
        rectangle->begin(mMaterial, Ogre::RenderOperation::OT_TRIANGLE_STRIP);
        for (const auto& [x, y] : {std::pair{left, bottom}, std::pair{right, bottom},
                                   std::pair{left, top}, std::pair{right, top}}) {
            rectangle->position(x, y, depth);
            rectangle->colour(colour);
        }
        rectangle->end();
        rectangle->setUseIdentityProjection(true);
        rectangle->setUseIdentityView(true);
        rectangle->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
        mScene->getRootSceneNode()->attachObject(rectangle);
    }

    /// Let a target show the scene.
    void show(Ogre::RenderTarget* target, const Ogre::ColourValue& background) {
        target->addViewport(mCamera)->setBackgroundColour(background);
    }

private:
    // GL3+ has no fixed functions. The legacy render system draws without a program.
    void createMaterials() {
        auto material = Ogre::MaterialManager::getSingleton().create("flat", Ogre::RGN_DEFAULT);
        Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
        pass->setLightingEnabled(false);
        pass->setVertexColourTracking(Ogre::TVC_AMBIENT | Ogre::TVC_DIFFUSE);
        pass->setCullingMode(Ogre::CULL_NONE);
        if (!mRoot->getRenderSystem()->getCapabilities()->hasCapability(Ogre::RSC_FIXED_FUNCTION)) {
            createProgram("flat/vertex", Ogre::GPT_VERTEX_PROGRAM, R"(#version 330
                in vec4 vertex;
                in vec4 colour;
                uniform mat4 projection;
                out vec4 vertexColour;
                void main() { gl_Position = projection * vertex; vertexColour = colour; })");
            createProgram("flat/fragment", Ogre::GPT_FRAGMENT_PROGRAM, R"(#version 330
                in vec4 vertexColour;
                out vec4 fragmentColour;
                void main() { fragmentColour = vertexColour; })");
            pass->setVertexProgram("flat/vertex");
            pass->setFragmentProgram("flat/fragment");
            // The identity, except that OGRE turns it upside down where it draws to a texture.
            pass->getVertexProgramParameters()->setNamedAutoConstant(
                "projection", Ogre::GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX);
        }
        mMaterial = material->getName();
    }

    static void createProgram(const std::string& name, Ogre::GpuProgramType type,
                              const std::string& source) {
        auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(
            name, Ogre::RGN_DEFAULT, "glsl", type);
        program->setSource(source);
        program->load();
    }

    Ogre::LogManager mLogs;
    std::unique_ptr<Ogre::Root> mRoot;
    Ogre::SceneManager* mScene = nullptr;
    Ogre::Camera* mCamera = nullptr;
    std::string mMaterial;
};

/// What a target shows, read back.
class Picture {
public:
    explicit Picture(Ogre::RenderTarget& target)
        : mWidth(target.getWidth()),
          mHeight(target.getHeight()),
          mBytes(std::size_t{4} * mWidth * mHeight) {
        const Ogre::Box all(0, 0, mWidth, mHeight);
        target.copyContentsToMemory(all, Ogre::PixelBox(all, Ogre::PF_BYTE_RGBA, mBytes.data()));
    }

    unsigned width() const { return mWidth; }
    unsigned height() const { return mHeight; }

    /// A pixel's colour as 0xRRGGBB; the first row is the upper one.
    unsigned at(unsigned x, unsigned y) const {
        const unsigned char* pixel = &mBytes[(std::size_t{y} * mWidth + x) * 4];
        return unsigned{pixel[0]} << 16 | unsigned{pixel[1]} << 8 | pixel[2];
    }

    /// The number of pixels of a colour.
    unsigned count(unsigned colour) const {
        unsigned result = 0;
        for (unsigned y = 0; y < mHeight; ++y)
            for (unsigned x = 0; x < mWidth; ++x)
                result += at(x, y) == colour;
        return result;
    }

private:
    unsigned mWidth, mHeight;
    std::vector<unsigned char> mBytes;
};

} // namespace Lixel::Tests
