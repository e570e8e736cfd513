#include "HeadlessOgre.h"

#include "manager/LixelSceneManager.h"
#include "scene/OgreVersions.h"

#include <Lixel/headless/Headless.h>

#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>

#include <cstdlib>
#include <stdexcept>

namespace Lixel::Tests {
namespace {

constexpr unsigned WindowSize = 32;

class OtherSceneManager : public Ogre::SceneManager {
public:
    using SceneManager::SceneManager;
    const Ogre::String& getTypeName() const override { return OtherManager; }
};

class OtherSceneManagerFactory : public NamedSceneManagerFactory {
public:
    OtherSceneManagerFactory() : NamedSceneManagerFactory(OtherManager) {}
    Ogre::SceneManager* createInstance(const Ogre::String& name) override {
        return new OtherSceneManager(name);
    }
    void destroyInstance(Ogre::SceneManager* manager) override { delete manager; }
};

void createProgram(const std::string& name, Ogre::GpuProgramType type, const char* source) {
    auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(
        name, Ogre::RGN_DEFAULT, "glsl", type);
    program->setSource(source);
    program->load();
}

} // namespace

HeadlessOgre::HeadlessOgre() {
    unsetenv("DISPLAY");
    const std::string error = Headless::enable();
    if (!error.empty()) throw std::runtime_error(error);
    // Made before Root, which would else write Ogre.log.
    mLogs = std::make_unique<Ogre::LogManager>();
    mLogs->createLog("", true, false, true);
    mRoot = std::make_unique<Ogre::Root>("", "", "");
    mRoot->loadPlugin(OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus");
    mRoot->loadPlugin(OGRE_PLUGIN_DIR "/Plugin_OctreeSceneManager");
    mOther = std::make_unique<OtherSceneManagerFactory>();
    mRoot->addSceneManagerFactory(mOther.get());
    mFlat = std::make_unique<LixelSceneManagerFactory>();
    mRoot->addSceneManagerFactory(mFlat.get());
    mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
    mRoot->initialise(false);
    Ogre::NameValuePairList parameters;
    for (const auto& [name, value] : Headless::windowParameters())
        parameters[name] = value;
    mWindow = mRoot->createRenderWindow("window", WindowSize, WindowSize, false, &parameters);
    // Without these OGRE refuses any shadow technique.
    Ogre::ResourceGroupManager::getSingleton().addResourceLocation(OGRE_SHADOW_MEDIA, "FileSystem",
                                                                   Ogre::RGN_INTERNAL);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
}

Ogre::MaterialPtr flatMaterial(bool receivesShadows) {
    const std::string name = receivesShadows ? "receives" : "does not receive";
    Ogre::MaterialManager& materials = Ogre::MaterialManager::getSingleton();
    if (Ogre::MaterialPtr found = materials.getByName(name, Ogre::RGN_DEFAULT)) return found;
    if (!Ogre::HighLevelGpuProgramManager::getSingleton().getByName("flat/vertex",
                                                                    Ogre::RGN_DEFAULT)) {
        createProgram("flat/vertex", Ogre::GPT_VERTEX_PROGRAM, R"(#version 330
            in vec4 vertex;
            uniform mat4 clipFromObject;
            void main() { gl_Position = clipFromObject * vertex; })");
        createProgram("flat/fragment", Ogre::GPT_FRAGMENT_PROGRAM, R"(#version 330
            out vec4 colour;
            void main() { colour = vec4(1.0); })");
    }
    Ogre::MaterialPtr material = materials.create(name, Ogre::RGN_DEFAULT);
    material->setReceiveShadows(receivesShadows);
    Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
    pass->setVertexProgram("flat/vertex");
    pass->setFragmentProgram("flat/fragment");
    pass->getVertexProgramParameters()->setNamedAutoConstant(
        "clipFromObject", Ogre::GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX);
    material->load();
    return material;
}

std::string cubeMesh(Ogre::SceneManager& manager) {
    const std::string name = "cube";
    if (Ogre::MeshManager::getSingleton().resourceExists(name, Ogre::RGN_DEFAULT)) return name;
    Ogre::ManualObject* cube = manager.createManualObject();
    cube->begin(flatMaterial(true)->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST);
    for (int i = 0; i < 8; ++i)
        cube->position((i & 1) != 0 ? 0.5f : -0.5f, (i & 2) != 0 ? 0.5f : -0.5f,
                       (i & 4) != 0 ? 0.5f : -0.5f);
    cube->quad(0, 2, 3, 1);
    cube->quad(4, 5, 7, 6);
    cube->quad(0, 1, 5, 4);
    cube->quad(2, 6, 7, 3);
    cube->quad(0, 4, 6, 2);
    cube->quad(1, 3, 7, 5);
    cube->end();
    // Without the padding that OGRE adds to a mesh's bounds.
    cube->convertToMesh(name, Ogre::RGN_DEFAULT)
        ->_setBounds(Ogre::AxisAlignedBox(-0.5f, -0.5f, -0.5f, 0.5f, 0.5f, 0.5f), false);
    manager.destroyManualObject(cube);
    return name;
}

} // namespace Lixel::Tests
