// Casters in batches: each texel of each map is that of single draws.

#include "TestStage.h"

#include <Lixel/manager/LixelSceneManager.h>
#include <Lixel/scene/OgreVersions.h>
#include <Lixel/setup/MapPlan.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace Lixel::Tests {
namespace {

using namespace Samples;

/// Draws each map with casters in batches and once more without, while it lives.
class BatchProof {
public:
    explicit BatchProof(Stage& stage) {
        setProofMode(true, [&stage] { stage.finish(); });
    }
    BatchProof(const BatchProof&) = delete;
    BatchProof& operator=(const BatchProof&) = delete;
    ~BatchProof() { setProofMode(false); }
};

StageOptions withLixelSceneManager() {
    return {.width = 160, .height = 120, .sceneManagerType = LixelSceneManager::TypeName};
}

/// Of maps that hold Lixel's depths as colours, and of hardware depth.
constexpr std::array MapFormats{Ogre::PF_FLOAT32_R, Ogre::PF_FLOAT16_R, Ogre::PF_DEPTH16,
                                Ogre::PF_DEPTH32};

class BatchedScene : public testing::TestWithParam<std::string> {
protected:
    BatchedScene() : stage(withLixelSceneManager()) {
        stage.show(*findSampleScene(GetParam()));
        stage.setShadowMapSize(256);
    }

    /// Two frames: what is new is drawn in OGRE's way first.
    void drawTwice(const std::string& what) {
        stage.drawFrame();
        stage.drawFrame();
        EXPECT_EQ(proofCount().different, 0U) << what << "\n" << log.all();
    }

    /// Whether the first map shows something.
    bool hasTexels() {
        const Ogre::TexturePtr& map = stage.sceneManager().getShadowTexture(0);
        const Ogre::PixelFormat format = map->getFormat();
        std::vector<std::uint8_t> texels(
            Ogre::PixelUtil::getMemorySize(map->getWidth(), map->getHeight(), 1, format));
        map->getBuffer()->blitToMemory(
            Ogre::PixelBox(map->getWidth(), map->getHeight(), 1, format, texels.data()));
        const std::size_t size = Ogre::PixelUtil::getNumElemBytes(format);
        return !std::equal(texels.begin() + static_cast<std::ptrdiff_t>(size), texels.end(),
                           texels.begin());
    }

    /// A third of what is there.
    void mirror() {
        std::size_t count = 0;
        for (const auto& [name, object] : stage.sceneManager().getMovableObjects("Entity"))
            if (count++ % 3 == 0) object->getParentSceneNode()->scale(-1, 1, 1);
    }

    /// All of the garden's meshes are worn once, and the forest is one.
    bool hasBatches() const { return GetParam() != "garden" && GetParam() != "forest"; }

    Stage stage;
    LogCollector log{"proof mode"};
};

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const SampleScene& scene : sampleScenes())
        names.push_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Of, BatchedScene, testing::ValuesIn(sceneNames()), [](const auto& test) {
    std::string name = test.param;
    std::erase(name, '-');
    return name;
});

TEST_P(BatchedScene, HasTheTexelsOfSingleDraws) {
    const BatchProof proof(stage);
    const SampleScene& scene = *findSampleScene(GetParam());
    // All of it takes minutes: setups take turns from light to light and from scene to scene.
    const bool isThorough = std::getenv("LIXEL_THOROUGH") != nullptr;
    const std::vector<NamedSetup>& setups = shadowSetups();
    std::size_t turn = GetParam().size();
    for (const SampleLight& light : scene.lights) {
        stage.setLight(light);
        ++turn;
        for (std::size_t i = 0; i < setups.size(); ++i) {
            if (!isThorough && (i + turn) % 4 != 0) continue;
            stage.setShadowSetup(setups[i].create());
            for (const bool relative : {false, true}) {
                if (!isThorough && relative != ((i + turn) / 4 % 2 == 0)) continue;
                stage.sceneManager().setCameraRelativeRendering(relative);
                drawTwice(light.name + ", " + setups[i].name + (relative ? ", relative" : ""));
                if (HasFailure()) return;
            }
        }
        stage.setShadowSetup(findShadowSetup("XPSM")->create());
        mirror();
        drawTwice(light.name + ", mirrored");
        mirror();
    }
    EXPECT_EQ(proofCount().batched > 0, hasBatches());
}

TEST_P(BatchedScene, HasTheTexelsOfSingleDrawsInEachFormat) {
    const BatchProof proof(stage);
    // One map is too few for a point light.
    const std::vector<SampleLight>& lights = findSampleScene(GetParam())->lights;
    stage.setLight(*std::ranges::find_if(
        lights, [](const SampleLight& light) { return light.kind != SampleLight::Kind::Point; }));
    stage.setShadowSetup(findShadowSetup("XPSM")->create());
    for (const Ogre::PixelFormat format : MapFormats) {
        const std::string name = Ogre::PixelUtil::getFormatName(format);
        stage.sceneManager().setShadowTextureSettings(256, 1, format);
        const std::size_t before = proofCount().batched;
        drawTwice(name);
        EXPECT_TRUE(hasTexels()) << name;
        EXPECT_EQ(proofCount().batched > before, hasBatches()) << name;
    }
}

} // namespace
} // namespace Lixel::Tests
