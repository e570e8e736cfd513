// The garden: the shadow of each kind of caster alone, and a shader system that comes and goes with
// the scene.

#include "PictureCasters.h"

#include "common/GardenFigure.h"
#include "common/GardenGround.h"
#include "common/Setups.h"
#include "common/Stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace Lixel::Samples {
namespace {

using Ogre::Vector3;

constexpr std::uint8_t Dark = 64;
constexpr std::uint8_t Bright = 192;
/// So many pixels, at least, have to be as expected: at edges they are on either side.
constexpr double Almost = 0.98;

/// Counts pixels, and those that are as expected.
struct Tally {
    int all = 0;
    int right = 0;
    void add(bool isRight) {
        ++all;
        right += isRight ? 1 : 0;
    }
    double share() const { return all > 0 ? static_cast<double>(right) / all : 0.0; }
};

class Garden : public testing::Test {
protected:
    Garden() {
        stage.show(*findSampleScene("garden"));
        // High enough for shadows to be near, and low enough for what casts them not to hide them
        // from above.
        sun.shadowPreset = "Garden/Sun";
        stage.setLight(sun);
    }

    /// Hides all but the ground and what wears this material, or every so many of it. @return these
    std::vector<Ogre::MovableObject*> showOnly(const Ogre::String& material, int every = 1) {
        std::vector<Ogre::MovableObject*> shown;
        int found = 0;
        for (Ogre::Node* child : stage.sceneManager().getRootSceneNode()->getChildren()) {
            for (Ogre::MovableObject* object :
                 static_cast<Ogre::SceneNode*>(child)->getAttachedObjects()) {
                const Ogre::String worn = materialOf(*object);
                if (worn.empty()) continue; // camera and light
                const bool isShown = worn == material && found++ % every == 0;
                object->setVisible(isShown || worn == "Garden/Ground");
                if (isShown) shown.push_back(object);
            }
        }
        return shown;
    }

    /// Looks down at a place of the ground, at this many metres from side to side.
    void lookDownAt(const Vector3& place, float wide) {
        constexpr float Above = 16.0F;
        SampleView view;
        view.position = place + Vector3(0.0F, Above, 0.3F);
        view.target = place;
        view.fovYDegrees =
            2.0F * Ogre::Math::ATan(0.5F * wide * Height / Width / Above).valueDegrees();
        view.farDistance = 200.0F;
        stage.setView(view);
    }

    /// Where a ray from a point above the ground meets it.
    static Vector3 groundBelow(const Vector3& point, const Vector3& direction) {
        float far = 0.0F;
        for (float step = 0.5F; step > 1e-4F;) {
            const Vector3 next = point + (far + step) * direction;
            if (next.y > gardenHeight(next.x, next.z))
                far += step;
            else
                step *= 0.5F;
        }
        return point + far * direction;
    }

    void draw() {
        stage.drawFrame(); // in which materials get their programs
        visibility = stage.drawVisibility();
        const char* const folder = std::getenv("LIXEL_PICTURES");
        if (folder == nullptr) return;
        stage.drawFrame();
        const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
        stage.window().writeContentsToFile(std::string(folder) + "/garden-" + test.name() + ".png");
    }

    std::uint8_t visibilityAt(int column, int row) const {
        return visibility.at(static_cast<std::size_t>(row * Width + column));
    }

    /// The visibility where a point of the world is seen; it has to be in the picture.
    std::uint8_t visibilityAt(const Vector3& ws) {
        const Vector3 ndc =
            stage.camera().getProjectionMatrix() * (stage.camera().getViewMatrix() * ws);
        return visibilityAt(static_cast<int>((ndc.x + 1) / 2 * Width),
                            static_cast<int>((1 - ndc.y) / 2 * Height));
    }

    /// Compares the ground of every third pixel with a ray to the sun, traced through the pictures.
    void compareWith(const PictureCasters& casters) {
        draw();
        Tally shadowed, throughHoles, beside;
        for (int row = 0; row < Height; row += 3) {
            for (int column = 0; column < Width; column += 3) {
                const Ogre::Ray ray = stage.camera().getCameraToViewportRay(
                    (static_cast<float>(column) + 0.5F) / Width,
                    (static_cast<float>(row) + 0.5F) / Height);
                const Vector3 ground = groundBelow(ray.getOrigin(), ray.getDirection());
                if (casters.meet({ray.getOrigin(), ray.getDirection()}) != Meeting::Nothing)
                    continue;
                const std::uint8_t seen = visibilityAt(column, row);
                switch (casters.meet({ground, -toGround})) {
                case Meeting::Picture:
                    shadowed.add(seen < Dark);
                    break;
                case Meeting::Hole:
                    throughHoles.add(seen > Bright);
                    break;
                case Meeting::Nothing:
                    beside.add(seen > Bright);
                    break;
                case Meeting::Edge:
                    break;
                }
            }
        }
        EXPECT_GT(shadowed.all, 50);
        EXPECT_GT(throughHoles.all, 50);
        EXPECT_GT(beside.all, 50);
        EXPECT_GE(shadowed.share(), Almost);
        EXPECT_GE(throughHoles.share(), Almost);
        EXPECT_GE(beside.share(), Almost);
    }

    static constexpr int Width = 400;
    static constexpr int Height = 300;
    Stage stage{{.headless = true, .width = Width, .height = Height}};
    std::vector<std::uint8_t> visibility;
    SampleLight sun = sunlight("sun", 184.0F, 32.0F);
    const Vector3 toGround = sun.direction;
};

TEST_F(Garden, FenceShadowsTheGroundBehindPicketsAndNotBehindHoles) {
    PictureCasters casters("fence.png");
    for (Ogre::MovableObject* fence : showOnly("Garden/Fence"))
        casters.add(*fence);
    lookDownAt(onGarden(-17.0F, -1.8F), 5.0F);
    compareWith(casters);
}

TEST_F(Garden, LeavesShadowTheGroundAndLetLightBetween) {
    PictureCasters casters("leaves.png");
    for (Ogre::MovableObject* tree : showOnly("Garden/Leaves"))
        casters.add(*tree);
    // South of the tree that stands apart.
    lookDownAt(onGarden(-10.7F, 8.6F), 6.0F);
    compareWith(casters);
}

TEST_F(Garden, InstancesOfGrassShadowTheGround) {
    PictureCasters casters("grass.png");
    const auto tufts = showOnly("Garden/Grass", 3);
    ASSERT_GT(tufts.size(), 200U);
    for (Ogre::MovableObject* tuft : tufts)
        casters.add(*tuft);
    lookDownAt(onGarden(-6.0F, 2.5F), 5.0F);
    compareWith(casters);
}

TEST_F(Garden, GardenerCastsTheShadowOfThePoseAndNotOfTheMesh) {
    const auto shown = showOnly("Garden/Skin");
    ASSERT_EQ(shown.size(), 1U);
    auto& gardener = static_cast<Ogre::Entity&>(*shown.front());
    const Ogre::Affine3 ws = gardener.getParentSceneNode()->_getFullTransform();
    const Vector3 middle = ws * Vector3(0.0F, 1.0F, 0.0F);
    lookDownAt(groundBelow(middle, toGround), 5.0F);
    draw();
    Ogre::MaterialManager::getSingleton().setActiveScheme(stage.viewport().getMaterialScheme());
    EXPECT_TRUE(gardener.isHardwareAnimationEnabled()) << "OGRE bends it: nothing was tested";
    Ogre::Skeleton& skeleton = *gardener.getSkeleton();
    const std::pair<const char*, const char*> limbs[] = {{"armL", "forearmL"}, {"armR", "forearmR"},
                                                         {"thighL", "shinL"},  {"thighR", "shinR"},
                                                         {"shinR", "footR"},   {"spine", "head"}};
    for (const auto& [from, to] : limbs) {
        const Vector3 a = skeleton.getBone(from)->_getDerivedPosition();
        const Vector3 b = skeleton.getBone(to)->_getDerivedPosition();
        for (const float along : {0.2F, 0.5F, 0.8F})
            EXPECT_LT(visibilityAt(groundBelow(ws * (a + along * (b - a)), toGround)), Dark)
                << from << " at " << along;
    }
    EXPECT_LT(visibilityAt(groundBelow(ws * leftHandOf(gardener), toGround)), Dark);
    // Stretched out, as the mesh has them.
    for (const float side : {-1.0F, 1.0F})
        for (const float out : {0.45F, 0.6F, 0.72F})
            EXPECT_GT(visibilityAt(groundBelow(ws * Vector3(side * out, 1.36F, 0.0F), toGround)),
                      Bright)
                << "arm at " << side * out;
}

TEST_F(Garden, LanternShadowsTheGround) {
    const SampleScene& garden = *findSampleScene("garden");
    const auto night = std::ranges::find(garden.views, "lantern", &SampleView::name);
    ASSERT_NE(night, garden.views.end());
    stage.setLight(*night->light);
    EXPECT_EQ(stage.preset(), "Lixel/Point");
    // Behind the gardener's middle, and beside it.
    const std::vector<Ogre::MovableObject*> gardeners = showOnly("Garden/Skin");
    ASSERT_EQ(gardeners.size(), 1U);
    const Ogre::SceneNode& node = *gardeners.front()->getParentSceneNode();
    const Vector3 lamp = night->light->position;
    const Vector3 middle = node._getFullTransform() * Vector3(0.0F, 0.85F, 0.0F);
    const Vector3 away = (middle - lamp).normalisedCopy();
    const Vector3 aside = Ogre::Quaternion(Ogre::Degree(20), Vector3::UNIT_Y) * away;
    lookDownAt(groundBelow(middle, away), 8.0F);
    draw();
    EXPECT_LT(visibilityAt(groundBelow(middle, away)), Dark);
    EXPECT_GT(visibilityAt(groundBelow(lamp, aside)), Bright);
}

TEST_F(Garden, IsTheSameAfterAnotherScene) {
    const auto pictureOfIt = [&] {
        stage.setLight(sun);
        stage.drawFrame(); // in OGRE's first instances have no bounds yet
        stage.setShadowSetup(findShadowSetup("Uniform")->create());
        stage.drawFrame();
        return stage.picture();
    };
    const std::vector<std::uint8_t> first = pictureOfIt();
    stage.clear();
    stage.show(*findSampleScene("duel"));
    EXPECT_FALSE(Ogre::ResourceGroupManager::getSingleton().resourceGroupExists(MediaGroup));
    EXPECT_EQ(stage.preset(), "");
    stage.drawFrame();
    EXPECT_TRUE(stage.picture() != first);
    stage.clear();
    stage.show(*findSampleScene("garden"));
    EXPECT_TRUE(pictureOfIt() == first);
}

TEST_F(Garden, HasOtherSetupsOnDemandAndItsOwnAgain) {
    const auto maps = [&] { return stage.sceneManager().getShadowTextureConfigList().size(); };
    EXPECT_EQ(stage.preset(), "Garden/Sun");
    EXPECT_EQ(maps(), 3U);
    stage.setShadowMapSize(256);
    stage.setShadowSetup(findShadowSetup("XPSM")->create());
    EXPECT_EQ(stage.preset(), "");
    EXPECT_EQ(maps(), 1U);
    EXPECT_EQ(stage.sceneManager().getShadowTextureConfigList().front().width, 256U);
    stage.drawFrame();
    stage.usePresets();
    EXPECT_EQ(stage.preset(), "Garden/Sun");
    EXPECT_EQ(maps(), 3U);
    EXPECT_EQ(stage.sceneManager().getShadowTextureConfigList().front().width, 256U);
    stage.drawFrame();
}

} // namespace
} // namespace Lixel::Samples
