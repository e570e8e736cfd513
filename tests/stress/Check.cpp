#include "Check.h"

#include "common/OracleView.h"
#include "common/TruthComparison.h"

#include <Lixel/scene/OgreVersions.h>

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fstream>

namespace Lixel::Tests {
namespace {

using namespace Samples;

/// A pixel at least so bright in a light's channel is lit: n.l is 0.05 or more there.
constexpr int LitFrom = 7;
/// Wrong pixels that need no second look: texels' edges, and a handful of rasterisation.
constexpr double FewPercent = 2.0;
constexpr std::size_t FewPixels = 25;
/// Texels of the map for the second look.
constexpr Ogre::ushort LargeMap = 4096;

struct Picture {
    int left, top, width, height; ///< of the viewport
    int stride;                   ///< pixels
    std::vector<std::uint8_t> rgb;
    int at(int column, int row, std::size_t channel) const {
        return rgb[3 * static_cast<std::size_t>((top + row) * stride + left + column) + channel];
    }
};

std::vector<std::uint8_t> read(Ogre::RenderTarget& target) {
    std::vector<std::uint8_t> bytes(std::size_t{3} * target.getWidth() * target.getHeight());
    const Ogre::Box box(0, 0, target.getWidth(), target.getHeight());
    target.copyContentsToMemory(box, Ogre::PixelBox(box, Ogre::PF_BYTE_RGB, bytes.data()));
    return bytes;
}

/// Hides what OGRE does not draw for this viewport, and shows it again.
class HiddenBodies {
public:
    HiddenBodies(const World& world, const Ogre::Viewport& viewport) {
        const Ogre::Camera& viewer = *viewport.getCamera();
        for (Ogre::Entity* const body : world.bodies) {
            const Ogre::Node* const node = body->getParentNode();
            if (!body->getVisible() || node == nullptr) continue;
            const Ogre::Vector3 scale = node->_getDerivedScale();
            const float reach =
                body->getRenderingDistance() +
                body->getBoundingRadius() *
                    std::max({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)});
            const bool far = body->getRenderingDistance() > 0 && viewer.getUseRenderingDistance() &&
                             node->getSquaredViewDepth(&viewer) > reach * reach;
            const bool masked = (body->getVisibilityFlags() & viewport.getVisibilityMask()) == 0;
            if (!far && !masked) continue;
            body->setVisible(false);
            mHidden.push_back(body);
        }
    }
    ~HiddenBodies() {
        for (Ogre::Entity* const body : mHidden)
            body->setVisible(true);
    }
    HiddenBodies(const HiddenBodies&) = delete;
    HiddenBodies& operator=(const HiddenBodies&) = delete;

private:
    std::vector<Ogre::Entity*> mHidden;
};

TriangleScene trianglesOf(const World& world, const Ogre::Viewport& viewport) {
    const HiddenBodies hidden(world, viewport);
    TriangleScene scene = collectTriangles(*world.manager);
    if (!world.manager->getShadowTextureSelfShadow())
        for (Triangle& triangle : scene.triangles)
            triangle.receives = triangle.receives && !triangle.casts;
    return scene;
}

template <typename Matrix>
Eigen::Matrix4d toEigen(const Matrix& m) {
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = static_cast<double>(m[row][column]);
    return matrix;
}

bool isFinite(const Ogre::Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Lights that take part in this frame's shadows, as OGRE counts them.
std::size_t casters(const World& world) {
    return static_cast<std::size_t>(
        std::count_if(world.lamps.begin(), world.lamps.end(), [](const Lamp& lamp) {
            return lamp.light->getVisible() && lamp.light->getCastShadows();
        }));
}

bool hasSeveralTextures(const World& world) {
    return std::any_of(world.lamps.begin(), world.lamps.end(), [&](const Lamp& lamp) {
        return world.manager->getShadowTextureCountPerLightType(lamp.light->getType()) > 1;
    });
}

bool isTextured(Ogre::ShadowTechnique technique) {
    return (technique & Ogre::SHADOWDETAILTYPE_TEXTURE) != 0;
}

/// Whether the picture shows what Lixel's materials make of the maps.
bool isReadable(const Application& application, const World& world) {
    if (!isTextured(world.technique)) return world.technique == Ogre::SHADOWTYPE_NONE;
    return application.pluginLoaded && world.readableFormat;
}

const UsedSetup& setupOf(const World& world, const Lamp& lamp) {
    return lamp.own.setup ? lamp.own : world.sceneSetup;
}

enum class Expected { Unknown, Shadows, AllLit };

Expected expected(const Application& application, const World& world, const Lamp& lamp,
                  const Ogre::Viewport& viewport) {
    const Ogre::Light& light = *lamp.light;
    if (!light.getVisible()) return Expected::Unknown;
    const bool textured = isTextured(world.technique);
    const bool modulative = world.technique == Ogre::SHADOWTYPE_TEXTURE_MODULATIVE;
    const bool integrated = world.technique == Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED;
    // One light darkens what another has, and lights that are out of an object's reach shift the
    // textures of the others.
    if ((modulative || integrated) && casters(world) > 1) return Expected::Unknown;
    if (modulative && !light.getCastShadows()) return Expected::Unknown;
    // Outside of integrated techniques OGRE counts one texture a light; Lixel says so in the log.
    if (textured && !integrated && casters(world) > 1 && hasSeveralTextures(world))
        return Expected::Unknown;
    if (!textured || !light.getCastShadows() || !viewport.getShadowsEnabled())
        // OGRE's materials read what was left in the textures where shadows are off in a viewport.
        return textured && !viewport.getShadowsEnabled() ? Expected::Unknown : Expected::AllLit;
    const ToldMaps* const told = application.told(*viewport.getCamera(), light);
    if (told == nullptr) return Expected::AllLit;
    const UsedSetup& used = setupOf(world, lamp);
    if (!used.recipe || !used.recipe->isExact()) return Expected::Unknown;
    if (told->maps > 6) return Expected::Unknown;
    const bool parted = used.recipe->isCube() || light.getType() == Ogre::Light::LT_POINT ||
                        light.getSpotlightOuterAngle() > Ogre::Degree(155);
    if (parted && told->maps > 1 && told->maps < 6) return Expected::Unknown;
    if (used.recipe->isCube() && told->maps < 6) return Expected::Unknown;
    if (told->drawn == 0 && told->last >= FitReason::Unbounded) return Expected::AllLit;
    return Expected::Shadows;
}

struct Losses {
    std::size_t counted = 0, shadowed = 0, acne = 0, leaks = 0;
    std::size_t wrong() const { return acne + leaks; }
    double percent() const {
        return counted > 0 ? 100.0 * static_cast<double>(wrong()) / static_cast<double>(counted)
                           : 0.0;
    }
    bool few() const { return wrong() <= FewPixels || percent() <= FewPercent; }
    std::string text() const {
        return fmt::format("{} of {} pixels are dark and should be lit, {} lit and should be dark",
                           acne, counted, leaks);
    }
};

/// Draws the frame again with other setups, and other maps if told.
class SecondLook {
public:
    SecondLook(Application& application, World& world) : mApplication(application), mWorld(world) {
        for (Lamp& lamp : world.lamps)
            mOwn.push_back(lamp.own);
        mAll = world.sceneSetup;
        mTextures = world.manager->getShadowTextureConfigList();
        for (Lamp& lamp : world.lamps)
            if (lamp.own.setup) application.setUp(lamp, {lamp.own.recipe->make(), lamp.own.recipe});
        if (mAll.setup) application.setUp(world, {mAll.recipe->make(), mAll.recipe});
    }
    void enlargeMaps() { mWorld.manager->setShadowTextureSize(LargeMap); }
    ~SecondLook() {
        for (std::size_t i = 0; i < mOwn.size(); ++i)
            mApplication.setUp(mWorld.lamps[i], mOwn[i]);
        if (mAll.setup) mApplication.setUp(mWorld, mAll);
        for (std::size_t i = 0; i < mTextures.size(); ++i)
            mWorld.manager->setShadowTextureConfig(i, mTextures[i]);
    }
    SecondLook(const SecondLook&) = delete;
    SecondLook& operator=(const SecondLook&) = delete;

private:
    Application& mApplication;
    World& mWorld;
    std::vector<UsedSetup> mOwn;
    UsedSetup mAll;
    Ogre::ShadowTextureConfigList mTextures;
};

class ViewCheck {
public:
    ViewCheck(Application& application, World& world, Screen& screen, Ogre::Viewport& viewport,
              CheckCounts& counts, const std::string& pictureFile)
        : mApplication(application),
          mWorld(world),
          mScreen(screen),
          mViewport(viewport),
          mCounts(counts),
          mPictureFile(pictureFile),
          mOracle(trianglesOf(world, viewport)) {
        const Ogre::Camera& viewer = *viewport.getCamera();
        mView.vsFromWs = toEigen(Ogre::Matrix4(viewer.getViewMatrix(true)));
        mView.clipFromVs = toEigen(viewer.getProjectionMatrix());
        mView.width = viewport.getActualWidth();
        mView.height = viewport.getActualHeight();
        mPoints = mOracle.visiblePoints(mView);
        look();
    }

    std::string find() {
        std::array<bool, 3> used{};
        for (const Lamp& lamp : mWorld.lamps) {
            used.at(lamp.channel) = true;
            const std::string wrong = judge(lamp);
            if (!wrong.empty())
                return fmt::format("{}, light '{}' of {}, technique {}{}: {}",
                                   mViewport.getCamera()->getName(), lamp.light->getName(),
                                   setupOf(mWorld, lamp).recipe
                                       ? setupOf(mWorld, lamp).recipe->name()
                                       : "OGRE's own setup",
                                   static_cast<int>(mWorld.technique), fitOf(lamp), wrong);
        }
        if ((mWorld.technique & Ogre::SHADOWDETAILTYPE_MODULATIVE) != 0) return {};
        for (std::size_t channel = 0; channel < used.size(); ++channel)
            for (int row = 0; row < mPicture.height && !used.at(channel); ++row)
                for (int column = 0; column < mPicture.width; ++column)
                    if (mPicture.at(column, row, channel) > 2)
                        return fmt::format("channel {} is lit by no light", channel);
        return {};
    }

private:
    std::string fitOf(const Lamp& lamp) const {
        const ToldMaps* const told = mApplication.told(*mViewport.getCamera(), *lamp.light);
        return told == nullptr ? ""
                               : fmt::format(", {} maps, {} drawn, {}", told->maps, told->drawn,
                                             toString(told->last));
    }

    void look() {
        mPicture = {mViewport.getActualLeft(),
                    mViewport.getActualTop(),
                    mView.width,
                    mView.height,
                    static_cast<int>(mScreen.target->getWidth()),
                    read(*mScreen.target)};
    }

    std::string judge(const Lamp& lamp) {
        const Ogre::Light& light = *lamp.light;
        if (!isPlaced(light)) return {};
        if (!isFinite(light.getDerivedDirection()) || !isFinite(light.getDerivedPosition()))
            return {};
        const Expected expectation = expected(mApplication, mWorld, lamp, mViewport);
        if (expectation == Expected::Unknown) return {};
        mView.shadowDistance = static_cast<double>(light.getShadowFarDistance());
        const ShadowTruth truth = mOracle.classify(mPoints, mView, oracleLight(light));
        const Losses losses = compare(truth, lamp, expectation);
        ++mCounts.lights;
        mCounts.shadowed += losses.shadowed >= 30 ? 1U : 0U;
        if (losses.few()) return {};
        if (!mPictureFile.empty()) writePicture(truth, lamp.channel);
        if (expectation == Expected::AllLit) return "should have no shadows: " + losses.text();
        return judgeAgain(lamp, truth, losses);
    }

    /// From a point to the light; far beyond the scene for a sun.
    static Eigen::Vector3d wayToLight(const SurfacePoint& point, const OracleLight& light) {
        if (light.kind == OracleLight::Kind::Directional) return -1e4 * light.direction;
        return light.position - point.position;
    }

    /// Whether the faces of casters that OGRE draws into maps block the light. The ray goes towards
    /// the light, so it meets from the front what the light sees from behind. Where backs alone are
    /// drawn, light gets into a closed body, and a viewer in there sees it.
    bool isBlocked(const SurfacePoint& point, const OracleLight& light) const {
        const Eigen::Vector3d way = wayToLight(point, light);
        const CasterRay ray{point.position + mOracle.rayOffset() * point.normal, way.normalized(),
                            way.norm()};
        double distance = 0.0;
        mOracle.firstCasters({&ray, 1},
                             mWorld.manager->getShadowCasterRenderBackFaces() ? CasterFaces::Fronts
                                                                              : CasterFaces::Backs,
                             {&distance, 1});
        return std::isfinite(distance);
    }

    /// Modulative receivers fade where the light comes in low; the others need no limit.
    bool isFaded(const SurfacePoint& point, const OracleLight& light) const {
        constexpr double FadeBelow = 0.27; // 0.25 in the program
        return mWorld.technique == Ogre::SHADOWTYPE_TEXTURE_MODULATIVE &&
               point.normal.dot(wayToLight(point, light).normalized()) < FadeBelow;
    }

    Losses compare(const ShadowTruth& truth, const Lamp& lamp, Expected expectation) const {
        const OracleLight light = oracleLight(*lamp.light);
        Losses losses;
        for (int row = 0; row < mPicture.height; ++row)
            for (int column = 0; column < mPicture.width; ++column) {
                const PixelClass known = truth.at(column, row);
                if (known != PixelClass::Lit && known != PixelClass::Shadowed) continue;
                if (isFaded(*mPoints.at(column, row), light)) continue;
                const bool lit = known == PixelClass::Lit || expectation == Expected::AllLit;
                const bool drawnLit = mPicture.at(column, row, lamp.channel) >= LitFrom;
                if (!lit && drawnLit && !isBlocked(*mPoints.at(column, row), light)) continue;
                ++losses.counted;
                losses.shadowed += lit ? 0U : 1U;
                losses.acne += lit && !drawnLit ? 1U : 0U;
                losses.leaks += !lit && drawnLit ? 1U : 0U;
            }
        return losses;
    }

    void writePicture(const ShadowTruth& truth, std::size_t channel) const {
        std::vector<std::uint8_t> visibility;
        for (int row = 0; row < mPicture.height; ++row)
            for (int column = 0; column < mPicture.width; ++column)
                visibility.push_back(mPicture.at(column, row, channel) >= LitFrom ? 255 : 0);
        const std::vector<std::uint8_t> rgb = paintComparison(truth, visibility);
        std::ofstream file(mPictureFile, std::ios::binary);
        file << "P6 " << mPicture.width << ' ' << mPicture.height << " 255\n";
        file.write(reinterpret_cast<const char*>(rgb.data()),
                   static_cast<std::streamsize>(rgb.size()));
    }

    /// What texels alone may do, fresh setups do on maps of the same size, and do no more on large
    /// maps.
    std::string judgeAgain(const Lamp& lamp, const ShadowTruth& truth, const Losses& losses) {
        ++mCounts.lookedTwice;
        Losses fresh;
        Losses large;
        {
            SecondLook second(mApplication, mWorld);
            mApplication.drawFrame();
            look();
            fresh = compare(truth, lamp, Expected::Shadows);
            second.enlargeMaps();
            mApplication.drawFrame();
            look();
            large = compare(truth, lamp, Expected::Shadows);
        }
        mApplication.drawFrame();
        look();
        if (losses.percent() > 1.5 * fresh.percent() + FewPercent)
            return "a stale shadow: " + losses.text() + "; from a new setup " + fresh.text();
        if (!large.few() && large.percent() > 0.5 * losses.percent())
            return "a wrong shadow: " + losses.text() + "; on a large map " + large.text();
        return {};
    }

    Application& mApplication;
    World& mWorld;
    Screen& mScreen;
    Ogre::Viewport& mViewport;
    CheckCounts& mCounts;
    const std::string& mPictureFile;
    ShadowOracle mOracle;
    OracleView mView;
    VisiblePoints mPoints;
    Picture mPicture{};
};

} // namespace

std::string findWrongShadow(Application& application, CheckCounts& counts,
                            const std::string& pictureFile) {
    for (Screen& screen : application.screens)
        for (unsigned short i = 0; i < screen.target->getNumViewports(); ++i) {
            Ogre::Viewport& viewport = *screen.target->getViewport(i);
            const auto world = std::find_if(
                application.worlds.begin(), application.worlds.end(), [&](const auto& one) {
                    return one->manager == viewport.getCamera()->getSceneManager();
                });
            if (!isReadable(application, **world)) continue;
            const std::string wrong =
                ViewCheck(application, **world, screen, viewport, counts, pictureFile).find();
            if (!wrong.empty()) return wrong;
        }
    return {};
}

} // namespace Lixel::Tests
