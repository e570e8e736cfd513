#include "Steadiness.h"

#include "CaseRun.h"
#include "MapProbe.h"

#include "common/OracleView.h"

#include <Lixel/fit/problem/TexelInPixels.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace Lixel::Tests {
namespace {

using Eigen::Vector3d;
using namespace Samples;

/// Pixels of the picture in which m is measured.
constexpr int Width = 640;
constexpr int Height = 480;
/// Points across and down that are looked for in it.
constexpr int PointsAcross = 48;
constexpr int PointsDown = 36;

/// Frames before the first that is measured, all alike: for setups that look at the frame before.
constexpr int SettlingFrames = 3;

/// What is seen or lit flatter than this is not measured.
constexpr double LeastCosine = 0.05;

/// The viewer's, the light's and the maps' side of one frame.
struct Frame {
    OracleView view;
    Vector3d wsEye;
    OracleLight light;
    std::vector<ProbedMap> maps;
    /// Of each of them, as it is drawn with: positions are relative to the world's origin here.
    std::vector<ShadowFit> fits;

    /// Whether there are maps, except those that have nothing to show.
    bool hasMaps() const {
        return std::ranges::any_of(fits, &ShadowFit::hasMap) &&
               std::ranges::all_of(
                   fits, [](const ShadowFit& fit) { return fit.reason < FitReason::Unbounded; });
    }
};

/// What one point has in one frame.
struct PointInMap {
    std::size_t map;   ///< which of the light's maps it reads
    double logTexel;   ///< ln m
    double logDensity; ///< of texels on the surface, up to a constant of the point
    /// Gradients of the map's coordinates: across the lines of its texel grid.
    std::array<Vector3d, 2> wsAxes;
};

OracleView viewOf(HardScene& scene, int width, int height) {
    const double reach = static_cast<double>(scene.light->getShadowFarDistance());
    return oracleView(scene.viewer(), width, height, reach);
}

/// @param maps of the frame: none where the setup was not asked for any
Frame frameOf(HardScene& scene, const std::vector<ProbedMap>& maps) {
    Frame frame{.view = viewOf(scene, Width, Height),
                .wsEye = {},
                .light = oracleLight(*scene.light),
                .maps = maps,
                .fits = {}};
    frame.wsEye = -frame.view.vsFromWs.topLeftCorner<3, 3>().transpose() *
                  frame.view.vsFromWs.topRightCorner<3, 1>();
    for (const ProbedMap& map : maps) {
        ShadowFit& fit = frame.fits.emplace_back();
        fit.reason = map.reason;
        fit.clipFromWorld = map.receivers.relativeTo(Vector3d::Zero());
    }
    return frame;
}

/// None where the frame does not show it, light it, or have it in its map.
std::optional<PointInMap> pointIn(const Frame& frame, const SurfacePoint& point) {
    const Vector3d towardsEye = (frame.wsEye - point.position).normalized();
    const bool sun = frame.light.kind == OracleLight::Kind::Directional;
    const Vector3d towardsLight =
        sun ? Vector3d(-frame.light.direction)
            : Vector3d((frame.light.position - point.position).normalized());
    if (point.normal.dot(towardsEye) < LeastCosine) return std::nullopt;
    if (point.normal.dot(towardsLight) < LeastCosine) return std::nullopt;
    if (!sun && -towardsLight.dot(frame.light.direction) < std::cos(frame.light.outerAngle / 2.0))
        return std::nullopt;
    const auto inside = [](const Eigen::Vector4d& clip) {
        return clip.w() > 0.0 && std::abs(clip.x()) <= clip.w() && std::abs(clip.y()) <= clip.w();
    };
    const std::size_t serving = servingMap(frame.maps, point.position);
    const ShadowFit& fit = frame.fits[serving];
    if (!fit.hasMap()) return std::nullopt;
    const Eigen::Matrix4d& map = fit.clipFromWorld;
    const Eigen::Vector4d clip = map * point.position.homogeneous();
    if (!inside(frame.view.clipFromVs * frame.view.vsFromWs * point.position.homogeneous()) ||
        !inside(clip))
        return std::nullopt;
    const auto m =
        texelInPixels(fit, Vec2(frame.maps[serving].width, frame.maps[serving].height),
                      {.viewFromWorld = frame.view.vsFromWs, .clipFromView = frame.view.clipFromVs},
                      Vec2(Width, Height), point.position, point.normal);
    if (!m || !std::isfinite(*m)) return std::nullopt;
    const auto gradient = [&](int row) {
        return Vector3d((map.row(row) - clip[row] / clip.w() * map.row(3)).head<3>() / clip.w());
    };
    const Vector3d u = gradient(0);
    const Vector3d v = gradient(1);
    return PointInMap{serving,
                      std::log(*m),
                      std::log(std::abs(point.normal.dot(u.cross(v)))),
                      {u.normalized(), v.normalized()}};
}

/** The angle in degrees by which a texel grid has turned: each of its directions, as a line, is
    compared with the nearest one before, so that a grid that is turned by 90 degrees is the same.
*/
double turnBetween(const PointInMap& before, const PointInMap& after) {
    double greatest = 0.0;
    for (const Vector3d& axis : after.wsAxes) {
        const double nearest =
            std::max(std::abs(axis.dot(before.wsAxes[0])), std::abs(axis.dot(before.wsAxes[1])));
        greatest = std::max(greatest, std::acos(std::min(nearest, 1.0)));
    }
    return greatest * 180.0 / std::numbers::pi;
}

/// The value that this share of all are below; 0 without any. Moves values around.
double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Whether a map's share of the world is what it was in the frame before, and not another map's,
/// whose place in the list it has taken.
bool isSamePart(const Eigen::RowVector4d& before, const Eigen::RowVector4d& after) {
    constexpr double Different = 0.05; // many times what 1e-4 rad change it by
    return (after - before).norm() <= Different * before.norm();
}

/// Collects what changes from frame to frame.
class Changes {
public:
    explicit Changes(std::vector<SurfacePoint> points) : mPoints(std::move(points)) {}

    void add(int number, const Frame& frame) {
        mAfter.clear();
        for (const SurfacePoint& point : mPoints)
            mAfter.push_back(frame.maps.empty() ? std::nullopt : pointIn(frame, point));
        if (!frame.hasMaps()) ++mResult.framesWithoutMap;
        // What changes from one map to another does so at an edge that materials know of.
        for (std::size_t map = 0; map < std::min(mSharesBefore.size(), frame.maps.size()); ++map)
            if (isSamePart(mSharesBefore[map], frame.maps[map].wsShare)) compare(number, map);
        std::swap(mBefore, mAfter);
        mSharesBefore.clear();
        for (const ProbedMap& map : frame.maps)
            mSharesBefore.push_back(map.wsShare);
    }

    Steadiness result() {
        mResult.measured = mAll.size();
        mResult.percentile99 = quantile(mAll, 0.99);
        return mResult;
    }

private:
    void compare(int number, std::size_t map) {
        double greatest = 0.0;
        mTurns.clear();
        mGains.clear();
        for (std::size_t i = 0; i < mPoints.size(); ++i) {
            if (!mBefore[i] || !mAfter[i]) continue;
            if (mBefore[i]->map != map || mAfter[i]->map != map) continue;
            const double change = std::abs(mAfter[i]->logTexel - mBefore[i]->logTexel);
            greatest = std::max(greatest, change);
            mAll.push_back(change);
            mTurns.push_back(turnBetween(*mBefore[i], *mAfter[i]));
            mGains.push_back(1.0 - std::exp(mBefore[i]->logDensity - mAfter[i]->logDensity));
        }
        mResult.greatest = std::max(mResult.greatest, greatest);
        const double turn = quantile(mTurns, 0.5);
        mTurnsBefore.resize(std::max(mTurnsBefore.size(), map + 1));
        const double turnBefore = std::exchange(mTurnsBefore[map], turn);
        if (turn > LeastJump && turn > SuddenTurn * turnBefore) {
            ++mResult.jumps;
            mResult.leastGain = std::min(mResult.leastGain, quantile(mGains, 0.5));
            return;
        }
        if (greatest > MostChange) ++mResult.unsteadySteps;
        if (greatest <= mResult.greatestSteady) return;
        mResult.greatestSteady = greatest;
        mResult.greatestFrame = number;
    }

    std::vector<SurfacePoint> mPoints;
    std::vector<Eigen::RowVector4d> mSharesBefore; ///< of each map
    std::vector<std::optional<PointInMap>> mBefore;
    std::vector<std::optional<PointInMap>> mAfter;
    std::vector<double> mAll;
    std::vector<double> mTurns;
    std::vector<double> mGains;
    std::vector<double> mTurnsBefore; ///< of each map, in degrees
    Steadiness mResult;
};

/// Points of receivers that the viewer sees.
std::vector<SurfacePoint> pointsSeen(HardScene& scene) {
    const ShadowOracle oracle(collectTriangles(scene.manager(), Vector3d::Zero()));
    std::vector<SurfacePoint> points;
    for (const auto& point : oracle.visiblePoints(viewOf(scene, PointsAcross, PointsDown)).pixels)
        if (point) points.push_back(*point);
    return points;
}

} // namespace

Steadiness runSweep(Stage& stage, const Sweep& sweep, const NamedSetup& setup,
                    const SweepOptions& options) {
    stage.setShadowSetup(setup.create());
    HardScene scene(stage);
    if (setup.maps > 1) scene.shareAmong(setup.maps);
    sweep.build(scene);
    sweep.turn(scene, 0.0);
    MapProbe probe(scene, isLixels(setup));
    Changes changes(pointsSeen(scene));
    for (int i = -SettlingFrames; i < options.frames; ++i) {
        const int step = std::max(i, 0) - options.frames / 2;
        sweep.turn(scene, (step + options.offset) * options.step);
        probe.maps.clear();
        stage.drawFrame();
        if (i >= 0) changes.add(i, frameOf(scene, probe.maps));
    }
    return changes.result();
}

} // namespace Lixel::Tests
