// What OGRE really draws into shadow maps under Lixel's setups: in whole frames, in both scene
// managers, counted where OGRE tells each object that a camera draws it.
#include "SceneTest.h"

#include "scene/OgreMath.h"
#include "setup/ShadowCameraSetups.h"
#include "setup/ShadowMapObserver.h"

#include <OgreMovableObject.h>

#include <random>
#include <set>
#include <vector>

using Ogre::Vector3;

namespace Lixel::Tests {
namespace {

constexpr float ShadowDistance = 100;

class CasterCullingTest : public SceneTest,
                          public Ogre::MovableObject::Listener,
                          public ShadowMapObserver {
protected:
    CasterCullingTest() {
        addShadowMapObserver(*this);
        mCameraNode->setPosition(0, 3, 0);
        mCamera->setFarClipDistance(300);
        // The ground receives only, and does not count.
        Ogre::Entity* ground = addCube(Vector3(0, -0.05f, 0));
        ground->getParentSceneNode()->setScale(2000, 0.1f, 2000);
        ground->setCastShadows(false);
    }
    ~CasterCullingTest() override {
        mManager->destroyAllMovableObjects(); // while their listener is there
    }

    void setSun(const Ogre::ShadowCameraSetupPtr& setup, const Vector3& direction) {
        mSunDirection = direction.normalisedCopy();
        addSun(setup, direction);
        mManager->setShadowFarDistance(ShadowDistance);
    }

    Ogre::Entity* addCaster(const Vector3& position, float halfExtent) {
        Ogre::Entity* caster = addCube(position, halfExtent);
        caster->setListener(this);
        mCasters.push_back(caster);
        return caster;
    }

    void addField(int count) {
        std::mt19937 engine(1);
        std::uniform_real_distribution<float> place(-300, 300);
        std::uniform_real_distribution<float> size(0.2f, 2);
        for (int i = 0; i < count; ++i) {
            const float half = size(engine);
            addCaster(Vector3(place(engine), half, place(engine)), half);
        }
    }

    void drawFrame() {
        mDrawn.clear();
        mMaps.clear();
        mRoot.renderOneFrame();
    }

    bool objectRendering(const Ogre::MovableObject* object, const Ogre::Camera* camera) override {
        // The viewer draws too, and is no shadow camera.
        if (camera != mCamera) mDrawn.insert(object);
        return true;
    }
    void shadowMapFitted(const ShadowMap& map) override { mMaps.push_back(map.fit.reason); }

    /// Whether some sampled point of the caster has its shadow on ground in view.
    bool matters(const Ogre::Entity& caster) const {
        const Ogre::AxisAlignedBox& box = caster.getWorldBoundingBox();
        const int steps = 6;
        for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1); ++i) {
            const Vector3 t(static_cast<float>(i % (steps + 1)),
                            static_cast<float>(i / (steps + 1) % (steps + 1)),
                            static_cast<float>(i / (steps + 1) / (steps + 1)));
            const Vector3 p = box.getMinimum() + t / steps * box.getSize();
            const Vector3 shadow = p + mSunDirection * (p.y / -mSunDirection.y);
            const Vector3 relative = shadow - mCamera->getDerivedPosition();
            if (mCamera->isVisible(shadow) &&
                relative.dotProduct(mCamera->getDerivedDirection()) < ShadowDistance)
                return true;
        }
        return false;
    }

    /// All that matter are drawn, and of the others no more than a part.
    void expectWhatMatters(double greatestShareOfTheOthers) {
        std::size_t matter = 0;
        std::size_t othersDrawn = 0;
        for (const Ogre::Entity* caster : mCasters) {
            const bool drawn = mDrawn.count(caster) != 0;
            if (matters(*caster)) {
                ++matter;
                EXPECT_TRUE(drawn) << caster->getWorldBoundingBox();
            } else if (drawn) {
                ++othersDrawn;
            }
        }
        EXPECT_GT(matter, 0U);
        EXPECT_LE(static_cast<double>(othersDrawn),
                  greatestShareOfTheOthers * static_cast<double>(mCasters.size() - matter))
            << matter << " matter, " << mDrawn.size() << " were drawn";
        RecordProperty("matter", static_cast<int>(matter));
        RecordProperty("drawn", static_cast<int>(mDrawn.size()));
    }

    Vector3 mSunDirection;
    std::vector<Ogre::Entity*> mCasters;
    std::set<const Ogre::MovableObject*> mDrawn;
    std::vector<FitReason> mMaps;
};

INSTANTIATE_TEST_SUITE_P(SceneManager, CasterCullingTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(CasterCullingTest, DrawsWhatMattersOfAField) {
    addField(500);
    setSun(XPSMShadowCameraSetup::create(), Vector3(1, -1, 0.3f));
    drawFrame();
    ASSERT_EQ(mMaps.size(), 1U);
    EXPECT_TRUE(hasMap(mMaps[0]));
    expectWhatMatters(0.1);
}

TEST_P(CasterCullingTest, DrawsWhatMattersUnderALowSun) {
    addField(500);
    setSun(UniformShadowCameraSetup::create(), Vector3(1, -0.2f, 0.5f));
    drawFrame();
    expectWhatMatters(0.1);
}

TEST_P(CasterCullingTest, DrawsWhatMattersInTheFrameAfterACut) {
    addField(500);
    setSun(XPSMShadowCameraSetup::create(), Vector3(1, -1, 0.3f));
    drawFrame();
    mCameraNode->yaw(Ogre::Degree(180));
    drawFrame();
    expectWhatMatters(0.1);
}

TEST_P(CasterCullingTest, CasterBehindViewer) {
    setSun(XPSMShadowCameraSetup::create(), Vector3(0, -0.1763f, -1)); // 10° high
    addField(400);
    // Its shadow falls 20 before the viewer, from 2000 behind.
    const Vector3 shadow(0, 0, -20);
    Ogre::Entity* far = addCaster(shadow - 2020 * mSunDirection, 1);
    drawFrame();
    EXPECT_EQ(mDrawn.count(far), 1U);
    expectWhatMatters(0.15);
}

TEST_P(CasterCullingTest, DrawsWhatMattersFarFromTheWorldsOrigin) {
    const Vector3 far(100000, 0, -100000);
    addField(400);
    for (Ogre::Node* child : mRootNode->getChildren())
        child->translate(far);
    setSun(XPSMShadowCameraSetup::create(), Vector3(1, -1, 0.3f));
    drawFrame();
    expectWhatMatters(0.1);
}

TEST_P(CasterCullingTest, DrawsNothingWhereNothingInViewIsShadowed) {
    setSun(XPSMShadowCameraSetup::create(), Vector3(0, -1, 0));
    for (int i = 0; i < 10; ++i)
        addCaster(Vector3(static_cast<float>(i), 5, 50), 1);
    drawFrame();
    ASSERT_EQ(mMaps.size(), 1U);
    EXPECT_EQ(mMaps[0], FitReason::NothingShadowed);
    EXPECT_TRUE(mDrawn.empty());
}

} // namespace
} // namespace Lixel::Tests
