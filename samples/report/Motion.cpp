#include "report/Motion.h"

#include "common/Flicker.h"
#include "common/MapCapture.h"
#include "common/OracleView.h"
#include "common/Scenes.h"
#include "common/Setups.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace Lixel::Samples {
namespace {

constexpr float FramesPerSecond = 60.0F;
constexpr float WalkPerSecond = 1.4F;  ///< world units, which are metres in all these scenes
constexpr float TurnPerSecond = 30.0F; ///< degrees

/// Frames of the same motion before those that count: searches follow, and maps have an age.
constexpr int EarlierFrames = 20;

/// Half a pixel is added to both errors of a ratio, so that no error at all has one too.
constexpr double HalfPixel = 0.5;

struct Motion {
    std::string name;
    float walk; ///< world units per second
    float turn; ///< degrees per second
};

const std::array<Motion, 3> Motions{{{"walk", WalkPerSecond, 0.0F},
                                     {"turn", 0.0F, TurnPerSecond},
                                     {"both", WalkPerSecond, TurnPerSecond}}};

/// What is shown and from where; views are by name.
struct Film {
    SampleScene scene;
    std::string view;
};

std::vector<Film> films(const MotionOptions& options) {
    std::vector<Film> all{{*findSampleScene("street"), "down-the-street"},
                          {*findSampleScene("field"), "head-height"},
                          {*findSampleScene("miners-lamp"), "down-the-nave"}};
    if (!options.modelFile.empty()) all.push_back({modelScene(options.modelFile), "inside"});
    if (!options.scene.empty())
        std::erase_if(all, [&](const Film& film) { return film.scene.name != options.scene; });
    if (all.empty())
        throw std::runtime_error("there is no scene '" + options.scene +
                                 "' to film; 'model' goes with --scene FILE");
    return all;
}

/// A setup and its bound.
struct Candidate {
    NamedSetup setup;
    double bound = 0.0;
    /// Of the same setup fitted in each frame, among the candidates.
    std::size_t fresh = 0;
};

std::vector<Candidate> candidates() {
    std::vector<Candidate> all;
    for (const char* const name : {"Uniform", "Stable", "XPSM", "Optimal"}) {
        const std::size_t fresh = all.size();
        for (const double bound : {0.0, 0.05, 0.1, 0.2})
            all.push_back(
                {withOptions(*findEmulatedSetup(name), {fmt::format("lasting_maps={}", bound)}),
                 bound, fresh});
    }
    for (const NamedSetup& setup : emulatedSetups())
        if (setup.name.starts_with("Ogre-")) all.push_back({setup, 0.0, all.size()});
    return all;
}

/// The view in a frame of the motion. The viewer walks straight on, and turns his head.
SampleView viewOf(SampleView view, const Motion& motion, int frame) {
    const float seconds = static_cast<float>(frame) / FramesPerSecond;
    Ogre::Vector3 ahead = view.target - view.position;
    const Ogre::Vector3 level = Ogre::Vector3(ahead.x, 0.0F, ahead.z).normalisedCopy();
    ahead = Ogre::Quaternion(Ogre::Degree(motion.turn * seconds), Ogre::Vector3::UNIT_Y) * ahead;
    view.position += motion.walk * seconds * level;
    view.target = view.position + ahead;
    return view;
}

/// What one candidate has given so far.
struct Sums {
    std::vector<CapturedFrame> frames;
    std::vector<double> errors;  ///< pixels
    std::vector<double> counted; ///< pixels
    std::size_t followed = 0;
    std::size_t changed = 0;
    double worstFlicker = 0.0;
    // Of those judged frames in which maps were drawn.
    double drawing = 0.0; ///< milliseconds
    std::size_t drawings = 0;
};

/// Whether two frames have the same maps, so that they classify alike.
bool sameMaps(const CapturedFrame& a, const CapturedFrame& b) {
    return std::ranges::equal(a.maps, b.maps, [](const EmulatedMap& p, const EmulatedMap& q) {
        return p.clipFromWs == q.clipFromWs && p.wsShare == q.wsShare &&
               p.beginDepth == q.beginDepth && p.endDepth == q.endDepth;
    });
}

double percent(double part, double whole) {
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
}

class FilmMeasurement {
public:
    FilmMeasurement(Stage& stage, const MotionOptions& options, const Film& film,
                    const std::vector<Candidate>& candidates)
        : mStage(stage),
          mOptions(options),
          mFilm(film),
          mView(*std::ranges::find(film.scene.views, film.view, &SampleView::name)),
          mCandidates(candidates),
          mOracle(collectTriangles(stage.sceneManager())),
          mEmulation(mOracle, casterFaces(stage.sceneManager())) {
        mStage.setLight(defaultLight(film.scene, mView));
    }

    std::vector<MotionRow> measure(const Motion& motion) {
        std::vector<Sums> sums(mCandidates.size());
        MapCapture capture(mStage);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i].frames = film(capture, mCandidates[i].setup, motion);
        for (int frame = 0; frame + 1 < mOptions.frames; ++frame)
            if (isJudged(frame)) classify(motion, frame, sums);

        std::vector<MotionRow> rows;
        for (std::size_t i = 0; i < sums.size(); ++i)
            rows.push_back(rowOf(motion, mCandidates[i], sums[i], sums[mCandidates[i].fresh]));
        return rows;
    }

private:
    double reach() const { return static_cast<double>(mFilm.scene.shadowDistance); }
    const Eigen::Vector3d& origin() const { return mOracle.scene().wsOrigin; }
    bool isJudged(int frame) const { return frame % mOptions.judged == 0; }
    OracleView see(const Motion& motion, int frame) {
        mStage.setView(viewOf(mView, motion, frame));
        return oracleView(mStage.camera(), mOptions.width, mOptions.height, reach(), origin());
    }

    /// The maps of all frames.
    std::vector<CapturedFrame> film(MapCapture& capture, const NamedSetup& setup,
                                    const Motion& motion) {
        std::vector<CapturedFrame> frames;
        mStage.setView(viewOf(mView, motion, -EarlierFrames));
        capture.begin(setup, mOptions.mapSize, reach(), origin());
        for (int frame = -EarlierFrames; frame < mOptions.frames; ++frame) {
            mStage.setView(viewOf(mView, motion, frame));
            const bool draws = frame >= 0 && isJudged(frame);
            CapturedFrame captured =
                capture.nextFrame(draws ? MapCapture::Draws::Maps : MapCapture::Draws::Nothing);
            if (frame >= 0) frames.push_back(std::move(captured));
        }
        return frames;
    }

    /// One frame's errors, and what changes up to the next frame.
    void classify(const Motion& motion, int frame, std::vector<Sums>& sums) {
        const OracleView nextView = see(motion, frame + 1);
        const OracleView view = see(motion, frame);
        mEmulation.setView(view);
        mEmulation.setLight(oracleLight(mStage.light(), origin()));
        const std::vector<std::size_t> followed =
            followedPixels(mEmulation.points(), view, mEmulation.truth(),
                           mOracle.visiblePoints(nextView), nextView);
        const auto number = static_cast<std::size_t>(frame);
        for (Sums& sum : sums) {
            const CapturedFrame& now = sum.frames[number];
            const std::vector<std::uint8_t> visible = mEmulation.visibility(now.maps);
            const ClassificationError error = compareWithTruth(mEmulation.truth(), visible);
            sum.errors.push_back(static_cast<double>(error.acnePixels + error.leakPixels));
            sum.counted.push_back(static_cast<double>(error.counted()));
            if (now.mapsDrawn > 0) {
                sum.drawing += now.casterMilliseconds;
                ++sum.drawings;
            }
            sum.followed += followed.size();
            const CapturedFrame& next = sum.frames[number + 1];
            if (sameMaps(now, next)) continue;
            const std::size_t changed =
                changedPixels(followed, visible, mEmulation.visibility(next.maps, nextView));
            sum.changed += changed;
            sum.worstFlicker =
                std::max(sum.worstFlicker, percent(static_cast<double>(changed),
                                                   static_cast<double>(followed.size())));
        }
    }

    MotionRow rowOf(const Motion& motion, const Candidate& candidate, const Sums& sum,
                    const Sums& fresh) const {
        MotionRow row;
        row.scene = mFilm.scene.name;
        row.view = mFilm.view;
        row.motion = motion.name;
        row.setup = candidate.setup.name;
        row.bound = candidate.bound;
        double errors = 0.0;
        double freshErrors = 0.0;
        for (std::size_t i = 0; i < sum.errors.size(); ++i) {
            const double error = percent(sum.errors[i], sum.counted[i]);
            row.meanError += error / static_cast<double>(sum.errors.size());
            row.worstError = std::max(row.worstError, error);
            errors += sum.errors[i] + HalfPixel;
            freshErrors += fresh.errors[i] + HalfPixel;
            const double ratio = (sum.errors[i] + HalfPixel) / (fresh.errors[i] + HalfPixel);
            row.worstRatio = i == 0 ? ratio : std::max(row.worstRatio, ratio);
        }
        row.meanRatio = errors / freshErrors;
        row.flicker = percent(static_cast<double>(sum.changed), static_cast<double>(sum.followed));
        row.worstFlicker = sum.worstFlicker;
        const auto maps = static_cast<double>(candidate.setup.maps);
        const auto count = static_cast<double>(sum.frames.size());
        std::size_t framesDrawn = 0;
        for (const CapturedFrame& frame : sum.frames) {
            row.drawn += percent(static_cast<double>(frame.mapsDrawn), maps) / count;
            row.fitting += 1e-3 * (frame.surveyMicroseconds + frame.fitMicroseconds) / count;
            framesDrawn += frame.mapsDrawn > 0 ? 1 : 0;
        }
        if (sum.drawings > 0)
            row.drawing = sum.drawing / static_cast<double>(sum.drawings) *
                          static_cast<double>(framesDrawn) / count;
        return row;
    }

    Stage& mStage;
    const MotionOptions& mOptions;
    const Film& mFilm;
    const SampleView& mView;
    const std::vector<Candidate>& mCandidates;
    ShadowOracle mOracle;
    MapEmulation mEmulation;
};

} // namespace

std::vector<MotionRow> measureMotion(const MotionOptions& options) {
    std::vector<MotionRow> rows;
    const std::vector<Candidate> all = candidates();
    for (const Film& film : films(options)) {
        Stage stage({.headless = true, .width = options.width, .height = options.height});
        stage.show(film.scene);
        FilmMeasurement measurement(stage, options, film, all);
        for (const Motion& motion : Motions) {
            const std::vector<MotionRow> some = measurement.measure(motion);
            rows.insert(rows.end(), some.begin(), some.end());
            fmt::print(stderr, "{}, {}: done\n", film.scene.name, motion.name);
        }
    }
    return rows;
}

void printMotion(const MotionOptions& options, const std::vector<MotionRow>& rows) {
    fmt::print(
        "{} frames of each motion at {} a second; {} x {} pixels, {} texels a side. Walk: {} "
        "m/s; turn: {} degrees/s\n",
        options.frames, FramesPerSecond, options.width, options.height, options.mapSize,
        WalkPerSecond, TurnPerSecond);
    std::string film;
    for (const MotionRow& row : rows) {
        const std::string name = fmt::format("{}, {}: {}", row.scene, row.view, row.motion);
        if (name != film) {
            film = name;
            fmt::print("\n{}\n{:<20} {:>6} {:>7} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9} {:>8} {:>8}\n",
                       film, "setup", "bound", "drawn", "error", "worst", "/ fresh", "worst",
                       "flicker", "worst", "fit ms", "draw ms");
        }
        fmt::print(
            "{:<20} {:>4.0f} % {:>5.0f} % {:>6.3f} % {:>6.3f} % {:>8.3f} {:>8.3f} {:>7.4f} % "
            "{:>7.4f} % {:>8.3f} {:>8.3f}\n",
            row.setup, 100.0 * row.bound, row.drawn, row.meanError, row.worstError, row.meanRatio,
            row.worstRatio, row.flicker, row.worstFlicker, row.fitting, row.drawing);
    }
}

void writeMotion(const MotionOptions& options, const std::vector<MotionRow>& rows,
                 const std::string& file) {
    nlohmann::ordered_json films = nlohmann::ordered_json::array();
    for (const MotionRow& row : rows)
        films.push_back({{"scene", row.scene},
                         {"view", row.view},
                         {"motion", row.motion},
                         {"setup", row.setup},
                         {"lasting_maps", row.bound},
                         {"drawn_percent", row.drawn},
                         {"error_percent", row.meanError},
                         {"worst_error_percent", row.worstError},
                         {"error_ratio_to_fresh", row.meanRatio},
                         {"worst_error_ratio_to_fresh", row.worstRatio},
                         {"flicker_percent", row.flicker},
                         {"worst_flicker_percent", row.worstFlicker},
                         {"survey_and_fit_ms", row.fitting},
                         {"drawing_ms", row.drawing}});
    const nlohmann::ordered_json all{{"frames", options.frames},
                                     {"judged_of", options.judged},
                                     {"map", options.mapSize},
                                     {"width", options.width},
                                     {"height", options.height},
                                     {"walk_m_per_s", WalkPerSecond},
                                     {"turn_degrees_per_s", TurnPerSecond},
                                     {"rows", films}};
    std::ofstream stream(file);
    stream << all.dump(2) << '\n';
    if (!stream.flush()) throw std::runtime_error("cannot write '" + file + "'");
}

} // namespace Lixel::Samples
