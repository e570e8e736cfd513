// What an earlier frame showed, sorted into the cells of a later picture.
#include "fit/Problems.h"

#include "fit/problem/SeenPicture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>

using namespace Lixel;
using namespace Lixel::Test;

namespace {

constexpr std::size_t PerSide = 4;
const double Tangent = std::tan(0.5);

ShadowViewer viewerTurned(double angle) {
    ShadowViewer viewer;
    viewer.clipFromView = perspective(1.0, 2.0, 0.1, 100.0);
    viewer.viewFromWorld.topLeftCorner<3, 3>() =
        Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    return viewer;
}

/// Points on a wall 10 ahead, four in each cell across and up; or nothing there but the sky.
SeenSurfaces seenWall(bool isSky = false) {
    SeenSurfaces seen;
    constexpr std::size_t Across = PictureCells::Columns * PerSide;
    constexpr std::size_t Up = PictureCells::Rows * PerSide;
    for (std::size_t i = 0; i < Across * Up; ++i) {
        const Vec2 ndc(2.0 * (static_cast<double>(i % Across) + 0.5) / Across - 1.0,
                       2.0 * (static_cast<double>(i / Across) + 0.5) / Up - 1.0);
        const Vec3 ws = 10.0 * Vec3(2.0 * Tangent * ndc.x(), Tangent * ndc.y(), -1.0);
        if (isSky)
            seen.empty.emplace_back(ws.x(), ws.y(), ws.z(), 0.0);
        else
            seen.points.push_back({ws, Vec3::UnitZ()});
    }
    return seen;
}

} // namespace

TEST(PictureCells, AreNumberedByRowsFromTheBottom) {
    EXPECT_EQ(PictureCells::at({-1.0, -1.0}), 0U);
    EXPECT_EQ(PictureCells::at({0.999, -1.0}), PictureCells::Columns - 1);
    EXPECT_EQ(PictureCells::at({-1.0, 0.999}), PictureCells::Count - PictureCells::Columns);
    constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
    for (const Vec2& outside : {Vec2(1.0, 0.0), Vec2(0.0, -1.001), Vec2(NotANumber, 0.0)})
        EXPECT_EQ(PictureCells::at(outside), PictureCells::Count);
}

TEST(SeenPicture, OfAnUnmovedViewerIsWhatWasSeen) {
    SeenPicture picture;
    picture.take(seenWall(), viewerTurned(0.0), Vec3::Zero());
    EXPECT_EQ(picture.known(), PictureCells::Count);
    for (std::size_t cell = 0; cell < PictureCells::Count; ++cell) {
        ASSERT_EQ(picture.points(cell).size(), PerSide * PerSide);
        for (const SeenPicture::Point& point : picture.points(cell)) {
            EXPECT_EQ(PictureCells::at(point.ndc), cell);
            EXPECT_EQ(point.point.ws.z(), -10.0);
            EXPECT_EQ(picture.nearest(cell, point.ndc), &point);
        }
    }
}

TEST(SeenPicture, KnowsNothingOfWhatATurnUncovers) {
    SeenPicture picture;
    // To the right by a fourth of the picture, at its middle.
    picture.take(seenWall(), viewerTurned(std::atan(0.5 * 2.0 * Tangent)), Vec3::Zero());
    for (std::size_t row = 0; row < PictureCells::Rows; ++row) {
        EXPECT_TRUE(picture.isKnown(row * PictureCells::Columns));
        const std::size_t last = (row + 1) * PictureCells::Columns - 1;
        EXPECT_FALSE(picture.isKnown(last));
        EXPECT_TRUE(picture.points(last).empty());
        EXPECT_EQ(picture.nearest(last, {0.99, 0.0}), nullptr);
    }
    EXPECT_LT(picture.known(), PictureCells::Count * 8 / 10);
    EXPECT_GT(picture.known(), PictureCells::Count / 2);
}

TEST(SeenPicture, KnowsNothingAfterACut) {
    SeenPicture picture;
    picture.take(seenWall(), viewerTurned(0.0), Vec3::Zero());
    picture.take(seenWall(), viewerTurned(3.14), Vec3::Zero());
    EXPECT_EQ(picture.known(), 0U);
    for (std::size_t cell = 0; cell < PictureCells::Count; ++cell)
        EXPECT_TRUE(picture.points(cell).empty());
    // Nor in front of the near plane.
    picture.take(seenWall(), viewerTurned(0.0), Vec3(0.0, 0.0, 9.95));
    EXPECT_EQ(picture.known(), 0U);
}

TEST(SeenPicture, KnowsWhereThereIsNothing) {
    SeenPicture picture;
    // The sky does not come nearer.
    picture.take(seenWall(true), viewerTurned(0.0), Vec3(3.0, 4.0, 5.0));
    EXPECT_EQ(picture.known(), PictureCells::Count);
    for (std::size_t cell = 0; cell < PictureCells::Count; ++cell)
        EXPECT_TRUE(picture.isKnown(cell) && picture.points(cell).empty());
}

TEST(SeenPicture, MovesWithTheViewersOrigin) {
    SeenPicture picture;
    const Vec3 offset(0.5, -0.25, -2.0);
    picture.take(seenWall(), viewerTurned(0.0), offset);
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < PictureCells::Count; ++cell)
        for (const SeenPicture::Point& point : picture.points(cell)) {
            ++count;
            EXPECT_EQ(point.point.ws.z(), -12.0);
            EXPECT_NEAR(point.ndc.y(), point.point.ws.y() / (12.0 * Tangent), 1e-12);
        }
    // Farther from the wall, all of it is in view.
    EXPECT_EQ(count, seenWall().points.size());
    EXPECT_LT(picture.known(), PictureCells::Count);
}
