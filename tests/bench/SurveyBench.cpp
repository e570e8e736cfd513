// lixel-bench-survey: CPU time of the survey and of the fits, beside OGRE's own visibility pass and
// its LiSPSM setup, in whole frames of the same scene in one process.
//
//     lixel-bench-survey [--frames N] [--objects N] [--manager TYPE]
//
// Nothing is drawn: OGRE finds what is visible, sorts it, and is then told to skip it. The viewer
// turns a little from frame to frame. Times are medians over the frames, in microseconds of wall
// clock, so an idle core is all that the machine needs to give.
//
// The survey (with the search for the sun's casters) and OGRE's search for what is visible are
// timed in pairs, one right after the other, each the first in every other pair: so both find the
// caches alike. The ratio is the median of the pairs' ratios.
//
// Lixel's scene manager comes twice: the second time, "told", the application announces changes of
// objects (LixelSceneManager::setChangesAnnounced).
#include "HeadlessOgre.h"
#include "SkipDrawing.h"

#include "common/Median.h"
#include "manager/LixelSceneManager.h"
#include "scene/CasterSearch.h"
#include "scene/OgreMath.h"
#include "setup/ShadowCameraSetups.h"
#include "setup/ShadowMapObserver.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreRenderQueue.h>
#include <OgreSceneNode.h>
#include <OgreShadowCameraSetupLiSPSM.h>
#include <OgreViewport.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <vector>

namespace Lixel::Tests {
namespace {

using Ogre::Vector3;
using Samples::median;

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

double since(Clock::time_point begin) {
    return Microseconds(Clock::now() - begin).count();
}

std::size_t countVisible(const Ogre::Camera& camera, const std::vector<Ogre::Entity*>& objects) {
    return static_cast<std::size_t>(
        std::count_if(objects.begin(), objects.end(), [&](const Ogre::Entity* object) {
            return camera.isVisible(object->getWorldBoundingBox());
        }));
}

/// Times a shadow camera setup, and counts whom its camera sees.
class TimedSetup : public Ogre::ShadowCameraSetup {
public:
    TimedSetup(Ogre::ShadowCameraSetupPtr inner, const std::vector<Ogre::Entity*>& objects)
        : mInner(std::move(inner)), mObjects(objects) {}
    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const override {
        const Clock::time_point begin = Clock::now();
        mInner->getShadowCamera(sceneManager, viewer, viewport, light, shadowCamera, iteration);
        microseconds = since(begin);
        if (countCasters) casters = countVisible(*shadowCamera, mObjects);
    }

    mutable double microseconds = 0.0;
    mutable std::size_t casters = 0;
    bool countCasters = false;

private:
    Ogre::ShadowCameraSetupPtr mInner;
    const std::vector<Ogre::Entity*>& mObjects;
};

/// What the last of Lixel's maps was and took.
class LastMap : public ShadowMapObserver {
public:
    LastMap() { addShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        fit = map.fitMicroseconds;
        reason = map.fit.reason;
    }

    double fit = 0.0;
    FitReason reason = FitReason::InvalidInput;
};

/// Medians of walking the scene.
struct Walks {
    double visibility = 0.0;
    /// Of what is seen, and of who casts on it.
    double survey = 0.0;
    double casters = 0.0;
    double ratio = 0.0;
};

/// Medians of one way of drawing the scene.
struct Cost {
    double fit = 0.0;
    /// getShadowCamera as a whole.
    double setup = 0.0;
    double frame = 0.0;
    /// Objects that the shadow camera lets pass.
    std::size_t casters = 0;
};

/// Where the viewer stands and looks to.
enum class View {
    Inside,   ///< from the middle of the field: a quarter of it is seen
    Outwards, ///< from its rim, out of it: next to nothing is seen
    Wall      ///< the same, at a wall under a low sun: nothing is seen but the field's shadow
};

const char* toString(View view) {
    switch (view) {
    case View::Inside:
        return "inside";
    case View::Outwards:
        return "outwards";
    case View::Wall:
        return "wall";
    }
    return "?";
}

/// A field of cubes on the ground.
class Field {
public:
    Field(HeadlessOgre& ogre, const std::string& managerType, bool announced, int objects,
          View view)
        : mRoot(ogre.root()),
          mWindow(ogre.window()),
          mManager(*mRoot.createSceneManager(managerType)) {
        if (announced) static_cast<LixelSceneManager&>(mManager).setChangesAnnounced(true);
        Ogre::SceneNode* root = mManager.getRootSceneNode();
        mCamera = mManager.createCamera("viewer");
        mCamera->setNearClipDistance(0.1f);
        mCamera->setFarClipDistance(2000);
        mCamera->setFOVy(Ogre::Degree(60));
        mCamera->setAspectRatio(16.0f / 9.0f);
        const float reach = 10 * std::sqrt(static_cast<float>(objects));
        mHeading = view == View::Inside ? 0.0f : 170.0f;
        mCameraNode =
            root->createChildSceneNode(Vector3(0, 5, view == View::Inside ? 0 : 0.48f * reach));
        mCameraNode->attachObject(mCamera);
        mWindow.addViewport(mCamera);

        std::mt19937 engine(1);
        std::uniform_real_distribution<float> place(-reach / 2, reach / 2);
        std::uniform_real_distribution<float> size(0.5f, 6);
        addCube(Vector3(0, -0.5f, 0), Vector3(reach, 1, reach));
        for (int i = 1; i < objects; ++i) {
            const float height = size(engine);
            addCube(Vector3(place(engine), height / 2, place(engine)),
                    Vector3(size(engine), height, size(engine)));
        }

        if (view == View::Wall) addCube(Vector3(0, 0, reach / 2 + 100), Vector3(reach, 200, 1));

        mSun = mManager.createLight();
        mSun->setType(Ogre::Light::LT_DIRECTIONAL);
        Ogre::SceneNode* sunNode = root->createChildSceneNode();
        sunNode->attachObject(mSun);
        sunNode->setDirection(view == View::Wall ? Vector3(0, -0.02f, 1) : Vector3(1, -1, 0.3f),
                              Ogre::Node::TS_WORLD);
        mManager.setShadowFarDistance(300);
        mManager.setShadowTextureSelfShadow(true);
        mManager.setShadowTextureCasterMaterial(flatMaterial(true));
        mManager.addRenderQueueListener(&mSkip);
    }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
    ~Field() {
        mWindow.removeAllViewports();
        mRoot.destroySceneManager(&mManager);
    }

    /// @param setup null for no shadows
    Cost measure(const Ogre::ShadowCameraSetupPtr& setup, int frames) {
        mManager.setShadowTechnique(setup ? Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED
                                          : Ogre::SHADOWTYPE_NONE);
        std::shared_ptr<TimedSetup> timed;
        if (setup) {
            mManager.setShadowTextureSettings(512, 1, Ogre::PF_FLOAT32_R);
            timed = std::make_shared<TimedSetup>(setup, mCubes);
            mSun->setCustomShadowCameraSetup(timed);
        }
        LastMap map;
        std::vector<double> fit, camera, frame;
        for (int i = -5; i < frames; ++i) {
            turn(i);
            const Clock::time_point begin = Clock::now();
            mRoot.renderOneFrame();
            const double passed = since(begin);
            if (i < 0) continue; // buffers still grow
            fit.push_back(map.fit);
            camera.push_back(timed ? timed->microseconds : 0.0);
            frame.push_back(passed);
        }
        if (timed) {
            timed->countCasters = true;
            mRoot.renderOneFrame();
        }
        mSun->resetCustomShadowCameraSetup();
        return {median(fit), median(camera), median(frame), timed ? timed->casters : 0};
    }

    /// Times the survey and OGRE's search for what is visible, in pairs.
    Walks pair(int frames) {
        const ShadowLight sun{.wsDirection = toDouble(mSun->getDerivedDirection())};
        const double shadowDistance = mSun->getShadowFarDistance();
        const Ogre::Viewport& viewport = *mCamera->getViewport();
        double visibleTime = 0.0;
        const auto see = [&] {
            mManager.getRenderQueue()->clear();
            Ogre::VisibleObjectsBoundsInfo bounds;
            const Clock::time_point begin = Clock::now();
            mManager._findVisibleObjects(mCamera, &bounds, false);
            visibleTime = since(begin);
        };
        std::vector<double> visible, survey, casters, ratio;
        for (int i = -6; i < frames; ++i) {
            turn(i);
            mManager._updateSceneGraph(mCamera);
            if (i % 2 == 0) see();
            const Clock::time_point begin = Clock::now();
            mSurvey.take(*mCamera, viewport, shadowDistance);
            const Clock::time_point middle = Clock::now();
            mSearch.find(mSurvey, sun, shadowDistance);
            const Clock::time_point end = Clock::now();
            if (i % 2 != 0) see();
            if (i < 0) continue;
            visible.push_back(visibleTime);
            survey.push_back(Microseconds(middle - begin).count());
            casters.push_back(Microseconds(end - middle).count());
            ratio.push_back(Microseconds(end - begin).count() / visibleTime);
        }
        return {median(visible), median(survey), median(casters), median(ratio)};
    }

    /// How many objects the viewer sees now.
    std::size_t inView() const { return countVisible(*mCamera, mCubes); }

private:
    void turn(int frame) {
        mCameraNode->setOrientation(Ogre::Quaternion(
            Ogre::Degree(mHeading + 0.2f * static_cast<float>(frame)), Vector3::UNIT_Y));
    }

    void addCube(const Vector3& centre, const Vector3& size) {
        Ogre::Entity* cube = mManager.createEntity(cubeMesh(mManager));
        cube->setMaterial(flatMaterial(true));
        Ogre::SceneNode* node = mManager.getRootSceneNode()->createChildSceneNode(centre);
        node->setScale(size);
        node->attachObject(cube);
        mCubes.push_back(cube);
    }

    Ogre::Root& mRoot;
    Ogre::RenderWindow& mWindow;
    Ogre::SceneManager& mManager;
    SkipDrawing mSkip;
    Ogre::Camera* mCamera = nullptr;
    Ogre::SceneNode* mCameraNode = nullptr;
    /// In degrees to the left of -z.
    float mHeading = 0;
    Ogre::Light* mSun = nullptr;
    std::vector<Ogre::Entity*> mCubes;
    Survey mSurvey;
    CasterSearch mSearch;
};

void measure(HeadlessOgre& ogre, const std::string& manager, bool announced, int objects, View view,
             int frames) {
    Field field(ogre, manager, announced, objects, view);
    const Walks walks = field.pair(frames);
    const Cost none = field.measure(nullptr, frames);
    const Cost lispsm = field.measure(Ogre::LiSPSMShadowCameraSetup::create(), frames);
    const Cost uniform = field.measure(UniformShadowCameraSetup::create(), frames);
    const Cost xpsm = field.measure(XPSMShadowCameraSetup::create(), frames);
    std::printf("%-7s %-8s %7d %6zu |%8.1f %8.1f %8.1f %6.2f |%8.1f %8.1f %8.1f |%6zu %6zu |%8.0f "
                "%8.0f %8.0f "
                "%8.0f\n",
                announced ? "told" : manager.substr(0, manager.find("SceneManager")).c_str(),
                toString(view), objects, field.inView(), walks.visibility, walks.survey,
                walks.casters, walks.ratio, lispsm.setup, uniform.fit, xpsm.fit, lispsm.casters,
                xpsm.casters, none.frame, lispsm.frame, uniform.frame, xpsm.frame);
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    int frames = 100;
    std::vector<int> sizes{100, 1000, 10000};
    std::vector<std::string> managers{DefaultManager, OctreeManager, FlatManager};
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string option = argv[i];
        const int value = std::atoi(argv[i + 1]);
        if (value > 0 && option == "--frames") {
            frames = value;
        } else if (value > 0 && option == "--objects") {
            sizes = {value};
        } else if (option == "--manager") {
            managers = {argv[i + 1]};
        } else {
            std::fprintf(stderr, "usage: lixel-bench-survey [--frames N] [--objects N] "
                                 "[--manager TYPE]\n");
            return 2;
        }
    }
    HeadlessOgre ogre;
    std::printf("Medians over %d frames in microseconds; one directional light\n\n", frames);
    std::printf("                                |walk of the scene                 |one shadow "
                "camera           "
                "|casters drawn|whole frame without drawing\n");
    std::printf("scene   view     objects   seen | visible   survey  casters  ratio |  LiSPSM  "
                "Uniform     XPSM "
                "|LiSPSM   XPSM |    none   LiSPSM  Uniform     XPSM\n");
    for (const std::string& manager : managers)
        for (const bool announced : {false, true})
            for (const View view : {View::Inside, View::Outwards, View::Wall})
                for (const int objects : sizes)
                    if (!announced || manager == FlatManager)
                        measure(ogre, manager, announced, objects, view, frames);
    return 0;
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    try {
        return Lixel::Tests::run(argc, argv);
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "lixel-bench-survey: %s\n", exception.what());
        return 1;
    }
}
