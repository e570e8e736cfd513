// Shadow maps of LixelSceneManager hold the nearest depth of each texel, in whatever order casters
// are drawn.
#include "BatchScene.h"
#include "ManagerOgre.h"

#include <Lixel/setup/ShadowCameraSetups.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreSubEntity.h>

#include <gtest/gtest.h>

namespace Lixel::Tests {
namespace {

/// A map whose casters are drawn in an order.
/// @param first whether entities that were made first are drawn first
std::vector<std::uint8_t> drawInOrder(BatchScene& scene, bool first) {
    Ogre::ushort priority = 50;
    for (const auto& [name, object] : scene.manager().getMovableObjects("Entity")) {
        static_cast<Ogre::Entity*>(object)->getSubEntity(0)->setRenderQueueGroupAndPriority(
            Ogre::RENDER_QUEUE_MAIN, first ? priority : static_cast<Ogre::ushort>(200 - priority));
        ++priority;
    }
    return scene.drawMap();
}

/// Boxes in each other whose bottoms are at one height: equally near, as far as rounding goes. Bottoms,
/// because OGRE draws the back faces of casters.
void addBottoms(BatchScene& scene) {
    for (int i = 0; i < 40; ++i) {
        const float height = 0.7f + 0.013f * static_cast<float>(i);
        const Ogre::Vector3 at(0.7f * static_cast<float>(i % 8) - 3, 1 + height / 2,
                               0.7f * static_cast<float>(i / 8));
        scene.scene()
            .add(Shape::Cube, at, Ogre::Vector3(1.7f, height, 1.3f), Ogre::ColourValue::White)
            ->getParentSceneNode()
            ->yaw(Ogre::Degree(17.0f * static_cast<float>(i)));
    }
    scene.scene().moving.clear();
}

TEST(NearestDepth, IsDrawnInAnyOrder) {
    BatchScene scene(false);
    addBottoms(scene);
    const std::vector<std::uint8_t> first = drawInOrder(scene, true);
    const std::vector<std::uint8_t> last = drawInOrder(scene, false);
    EXPECT_EQ(differingTexels(first, last), 0U);
    scene.scene().place().setPosition(0, 0.01f, 0);
    EXPECT_GT(differingTexels(first, drawInOrder(scene, true)), 100U);
}

} // namespace
} // namespace Lixel::Tests
