// Pictures: byte for byte those of OGRE's default scene manager.
#include "ManagerOgre.h"
#include "Managers.h"
#include "OwnBoxesManager.h"
#include "PictureKinds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace Lixel::Tests {
namespace {

constexpr int PicturesInARow = 4;

/// Successive ones, with everything that moves in other places.
std::vector<Picture> drawPictures(const PictureKind& kind, const std::string& managerType,
                                  bool isWhole = true) {
    PictureScene scene(ogreWithManagers(), managerType, kind.origin);
    kind.prepare(scene);
    if (!isWhole) kind.undo(scene);
    std::vector<Picture> pictures;
    for (int i = 0; i < PicturesInARow; ++i)
        pictures.push_back(scene.draw());
    PictureScene::keep(pictures.back(),
                       kind.name + ("-" + managerType) + (isWhole ? "" : "-without"));
    return pictures;
}

/// In percent of the pixels.
double differing(const Picture& a, const Picture& b) {
    constexpr std::ptrdiff_t Bytes = 4;
    std::size_t count = 0;
    for (auto one = a.begin(), other = b.begin(); one != a.end(); one += Bytes, other += Bytes)
        count += std::equal(one, one + Bytes, other) ? 0 : 1;
    return 100.0 * static_cast<double>(Bytes * count) / static_cast<double>(a.size());
}

class Pictures : public testing::TestWithParam<PictureKind> {
protected:
    /// OGRE's controllers take the first frame of a process for another time.
    static void SetUpTestSuite() { drawPictures(pictureKinds().front(), DefaultManager); }
};

INSTANTIATE_TEST_SUITE_P(Of, Pictures, testing::ValuesIn(pictureKinds()),
                         [](const auto& test) { return test.param.name; });

TEST_P(Pictures, AreTheDefaultManagers) {
    const std::vector<Picture> expected = drawPictures(GetParam(), DefaultManager);
    const std::vector<Picture> actual = drawPictures(GetParam(), candidate().manager);
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(differing(expected[i], actual[i]), 0) << "picture " << i;
    EXPECT_GT(differing(expected.front(), expected.back()), 5) << "nothing moves";
    const std::vector<Picture> without = drawPictures(GetParam(), DefaultManager, false);
    EXPECT_GT(differing(expected.back(), without.back()), 0.5) << "there is nothing of the kind";
}

TEST(Picture, ShowsLateBoxes) {
    const PictureKind& kind = pictureKinds().front();
    const std::vector<Picture> late = drawPictures(kind, faultyManager(Fault::LateBoxes));
    EXPECT_GT(differing(late.front(), drawPictures(kind, DefaultManager).front()), 0);
}

} // namespace
} // namespace Lixel::Tests
