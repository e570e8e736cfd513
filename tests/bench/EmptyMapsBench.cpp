// lixel-bench-empty-maps: what lights and maps without shadows cost.
//
//     lixel-bench-empty-maps [--frames K] [--json FILE]
//
// A few boxes on a ground, drawn for real, by Lixel's scene manager and by OGRE's default one: with no
// shadows at all, and with lights whose maps have nothing to show. All take turns of some frames each,
// with a viewer who turns a little; times are medians of wall clock until all is drawn.
#include "BenchMain.h"
#include "FinishDrawing.h"
#include "HeadlessOgre.h"
#include "WriteJson.h"

#include "common/Median.h"
#include "setup/CascadesShadowCameraSetup.h"
#include "setup/ShadowCameraSetups.h"
#include "setup/ShadowMapObserver.h"

#include <fmt/core.h>

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreFrameListener.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreLight.h>
#include <OgreRenderTexture.h>
#include <OgreSceneNode.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <random>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;

constexpr int FramesATurn = 6;
constexpr int UncountedFrames = 2;
constexpr Ogre::ushort MapSide = 1024;

/// One light and how many maps it has.
struct LightCase {
    const char* name;
    Ogre::Light::LightTypes type;
    Vector3 position;
    Vector3 direction;
    Ogre::ShadowCameraSetupPtr setup; ///< null for no shadows
    unsigned maps;
};

std::vector<LightCase> lightCases() {
    CascadeOptions slices;
    // Boxes are less than 40 away.
    slices.vsSplitDepths = {45, 120};
    const Vector3 sun(1, -1, 0.3F);
    return {
        {"no shadows", Ogre::Light::LT_DIRECTIONAL, {}, sun, nullptr, 1},
        {"sun, one map", Ogre::Light::LT_DIRECTIONAL, {}, sun, XPSMShadowCameraSetup::create(), 1},
        {"sun, two of three slices empty",
         Ogre::Light::LT_DIRECTIONAL,
         {},
         sun,
         CascadesShadowCameraSetup::create(XPSMShadowCameraSetup::create(), slices),
         3},
        {"spot behind the viewer, lighting nothing in view", Ogre::Light::LT_SPOTLIGHT,
         Vector3(0, 8, 60), Vector3(0, -0.4F, 1), XPSMShadowCameraSetup::create(), 1},
        {"lamp, five of six faces empty",
         Ogre::Light::LT_POINT,
         Vector3(0, 7, -45),
         {},
         XPSMShadowCameraSetup::create(),
         6},
        {"spot behind the viewer, OGRE's default setup", Ogre::Light::LT_SPOTLIGHT,
         Vector3(0, 8, 60), Vector3(0, -0.4F, 1), Ogre::DefaultShadowCameraSetup::create(), 1},
    };
}

/// Counts what is done with maps.
class PlansOfAFrame : public ShadowMapObserver {
public:
    PlansOfAFrame() { addShadowMapObserver(*this); }
    ~PlansOfAFrame() override { removeShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        shown += map.decision.plan != MapPlan::Skip ? 1U : 0U;
        empty += map.decision.plan == MapPlan::Skip ? 1U : 0U;
    }
    std::size_t shown = 0;
    std::size_t empty = 0;
};

/// A scene manager with a ground, boxes, a light and a viewer.
class EmptyMapsScene {
public:
    EmptyMapsScene(HeadlessOgre& ogre, const std::string& managerType)
        : mRoot(ogre.root()), mManager(*mRoot.createSceneManager(managerType)) {
        mTexture = Ogre::TextureManager::getSingleton().createManual(
            "viewer of " + managerType, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, 320, 180, 0,
            Ogre::PF_BYTE_RGBA, Ogre::TU_RENDERTARGET);
        Ogre::Camera* const camera = mManager.createCamera("viewer");
        camera->setNearClipDistance(0.1F);
        camera->setFarClipDistance(400);
        mViewer = mManager.getRootSceneNode()->createChildSceneNode(Vector3(0, 5, 20));
        mViewer->attachObject(camera);
        target().setAutoUpdated(false);
        target().addViewport(camera)->setOverlaysEnabled(false);
        mLight = mManager.createLight();
        mLightNode = mManager.getRootSceneNode()->createChildSceneNode();
        mLightNode->attachObject(mLight);
        mManager.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
        mManager.setShadowTextureCasterMaterial(flatMaterial(true));
        mManager.setShadowTextureSelfShadow(true);
        addBodies();
    }
    EmptyMapsScene(const EmptyMapsScene&) = delete;
    EmptyMapsScene& operator=(const EmptyMapsScene&) = delete;
    ~EmptyMapsScene() {
        target().removeAllViewports();
        mRoot.destroySceneManager(&mManager);
        Ogre::TextureManager::getSingleton().remove(mTexture);
    }

    void use(const LightCase& light) {
        mLight->setType(light.type);
        mLight->setSpotlightRange(Ogre::Degree(40), Ogre::Degree(60));
        mLight->setAttenuation(60, 1, 0, 0);
        mLightNode->setPosition(light.position);
        if (light.direction != Vector3::ZERO)
            mLightNode->setDirection(light.direction, Ogre::Node::TS_WORLD);
        mLight->setCastShadows(light.setup != nullptr);
        if (light.setup) mLight->setCustomShadowCameraSetup(light.setup);
        mManager.setShadowTextureCountPerLightType(light.type, light.maps);
        mManager.setShadowTextureSettings(MapSide, static_cast<Ogre::ushort>(light.maps),
                                          Ogre::PF_FLOAT32_R);
    }
    void draw(int frame) {
        mViewer->setOrientation(
            Ogre::Quaternion(Ogre::Degree(0.2F * static_cast<float>(frame % 50)), Vector3::UNIT_Y));
        Ogre::FrameEvent event{};
        mRoot._fireFrameStarted(event);
        target().update();
        mRoot._fireFrameEnded(event);
    }

private:
    Ogre::RenderTarget& target() const { return *mTexture->getBuffer()->getRenderTarget(); }
    void addBody(const Vector3& at, const Vector3& size, bool casts) {
        Ogre::SceneNode* const node = mManager.getRootSceneNode()->createChildSceneNode(at);
        node->setScale(size);
        Ogre::Entity* const body = mManager.createEntity(cubeMesh(mManager));
        body->setMaterial(flatMaterial(true));
        body->setCastShadows(casts);
        node->attachObject(body);
    }
    void addBodies() {
        addBody(Vector3(0, -0.5F, 0), Vector3(600, 1, 600), false);
        std::mt19937 engine(1);
        std::uniform_real_distribution<float> place(-8, 8);
        for (int i = 0; i < 200; ++i)
            addBody(Vector3(place(engine), 1, place(engine)), Vector3(0.4F, 2, 0.4F), true);
    }

    Ogre::Root& mRoot;
    Ogre::SceneManager& mManager;
    Ogre::TexturePtr mTexture;
    Ogre::SceneNode* mViewer = nullptr;
    Ogre::Light* mLight = nullptr;
    Ogre::SceneNode* mLightNode = nullptr;
};

struct EmptyMapsRow {
    EmptyMapsScene* scene;
    std::string manager;
    LightCase light;
    std::vector<double> microseconds{};
    std::size_t shown = 0;
    std::size_t empty = 0;
};

void takeEmptyMapsTurn(EmptyMapsRow& row, int frame) {
    using Clock = std::chrono::steady_clock;
    row.scene->use(row.light);
    for (int i = -UncountedFrames; i < FramesATurn; ++i) {
        const PlansOfAFrame plans;
        finishDrawing();
        const Clock::time_point begin = Clock::now();
        row.scene->draw(frame + i);
        finishDrawing();
        if (i < 0) continue;
        row.microseconds.push_back(
            std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
        row.shown = plans.shown;
        row.empty = plans.empty;
    }
}

void runEmptyMaps(int frames, const std::string& jsonFile) {
    HeadlessOgre ogre;
    std::vector<std::unique_ptr<EmptyMapsScene>> scenes;
    std::vector<EmptyMapsRow> rows;
    for (const std::string& manager : {DefaultManager, FlatManager}) {
        scenes.push_back(std::make_unique<EmptyMapsScene>(ogre, manager));
        for (const LightCase& light : lightCases())
            rows.push_back({scenes.back().get(), manager, light});
    }
    std::vector<EmptyMapsRow*> order;
    for (EmptyMapsRow& row : rows)
        order.push_back(&row);
    std::mt19937 engine(1);
    for (int frame = 0; frame < frames; frame += FramesATurn) {
        std::shuffle(order.begin(), order.end(), engine);
        for (EmptyMapsRow* row : order)
            takeEmptyMapsTurn(*row, frame);
    }
    nlohmann::json json = nlohmann::json::array();
    fmt::print("{:20} {:50} {:>5} {:>5} {:>9} {:>9}\n", "manager", "light", "shown", "empty",
               "frame us", "more us");
    double without = 0.0;
    for (const EmptyMapsRow& row : rows) {
        const double frame = Samples::median(row.microseconds);
        if (!row.light.setup) without = frame;
        fmt::print("{:20} {:50} {:5} {:5} {:9.0f} {:9.0f}\n", row.manager, row.light.name,
                   row.shown, row.empty, frame, frame - without);
        json.push_back({{"manager", row.manager},
                        {"light", row.light.name},
                        {"shown", row.shown},
                        {"empty", row.empty},
                        {"frame_us", frame}});
    }
    writeJson(json, jsonFile);
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    using namespace Lixel::Tests;
    int frames = 120;
    std::string jsonFile;
    CLI::App app("What lights and maps without shadows cost");
    addFrames(app, frames);
    addJson(app, jsonFile);
    return runBench("lixel-bench-empty-maps", app, argc, argv,
                    [&] { runEmptyMaps(frames, jsonFile); });
}
