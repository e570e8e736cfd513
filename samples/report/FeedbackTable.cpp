#include "report/FeedbackTable.h"

#include "common/Flicker.h"
#include "common/MapCapture.h"
#include "common/OracleView.h"

#include <Lixel/setup/VisiblePointFeedback.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

/// At 60 frames a second, in a scene whose shadows reach 100 units: 1.4 m/s of a man, and 30
/// degrees a second.
constexpr float ReachPerFrame = 1.4F / 60.0F / 100.0F;
constexpr float DegreesPerFrame = 30.0F / 60.0F;

/// Of so many frames one is compared with the truth; after a cut each of the first ones is.
constexpr int Judged = 6;
constexpr int AfterCut = 4;

/// Half a pixel is added to both errors of a ratio, so that no error at all has one too.
constexpr double HalfPixelError = 0.5;

enum class Points { Rays, Feedback, Exact };

struct FeedbackCandidate {
    std::string setup;
    Points points;
};

std::vector<FeedbackCandidate> candidatesOfFeedback() {
    std::vector<FeedbackCandidate> all;
    for (const char* const setup : {"XPSM", "Optimal", "Cascades-2"})
        for (const Points points : {Points::Rays, Points::Feedback, Points::Exact})
            all.push_back({setup, points});
    return all;
}

const char* nameOf(Points points) {
    switch (points) {
    case Points::Rays:
        return "view rays";
    case Points::Feedback:
        return "feedback";
    default:
        return "exact points";
    }
}

/// What is seen in a judged frame.
enum class Phase : std::size_t { Walk, Cut, Settled, Count };
constexpr auto Phases = static_cast<std::size_t>(Phase::Count);

const char* nameOf(Phase phase) {
    switch (phase) {
    case Phase::Walk:
        return "walking and turning";
    case Phase::Cut:
        return "frame of a cut";
    default:
        return "frames after it";
    }
}

/// What one candidate has given in one phase.
struct PhaseSums {
    std::vector<double> errors; ///< pixels, of each judged frame
    double counted = 0.0;
    std::size_t shadowed = 0;
    std::size_t lost = 0;
    std::size_t followed = 0;
    std::size_t changed = 0;
    double known = 0.0;
    double age = 0.0;
    std::size_t used = 0;
    std::vector<double> microseconds;    ///< of feedback
    std::vector<double> fitMicroseconds; ///< of all maps' fits
};

struct WalkAndCut {
    SampleView view;
    SampleView next; ///< after the cut
};

class FeedbackMeasurement {
public:
    FeedbackMeasurement(Stage& stage, const TableOptions& options, const SampleScene& scene,
                        int frames)
        : mStage(stage),
          mOptions(options),
          mReach(static_cast<double>(scene.shadowDistance)),
          mFrames(frames),
          mOracle(collectTriangles(stage.sceneManager())),
          mEmulation(mOracle, casterFaces(stage.sceneManager())) {
        const double size = mReach > 0.0 ? mReach : mOracle.scene().box().diagonal().norm();
        mWalk = ReachPerFrame * static_cast<float>(size);
    }

    void measure(const SampleLight& light, const WalkAndCut& film,
                 const std::vector<FeedbackCandidate>& candidates,
                 std::vector<std::array<PhaseSums, Phases>>& sums) {
        mStage.setLight(light);
        std::vector<std::vector<JudgedMaps>> films;
        {
            MapCapture capture(mStage);
            for (const FeedbackCandidate& candidate : candidates)
                films.push_back(drawFilm(capture, film, candidate));
        }
        for (std::size_t i = 0; i < films.front().size(); ++i) {
            const int frame = films.front()[i].frame;
            look(film, frame);
            const ShadowTruth& truth = mEmulation.truth();
            std::vector<std::size_t> followed;
            if (phaseOf(frame) == Phase::Walk) followed = followedFrom(film, frame);
            const auto shadowed =
                static_cast<std::size_t>(std::ranges::count(truth.pixels, PixelClass::Shadowed));
            for (std::size_t c = 0; c < candidates.size(); ++c) {
                const JudgedMaps& judged = films[c][i];
                PhaseSums& sum = sums[c][static_cast<std::size_t>(phaseOf(frame))];
                const ClassificationError error = mEmulation.error(judged.maps);
                sum.errors.push_back(static_cast<double>(error.acnePixels + error.leakPixels));
                sum.counted += static_cast<double>(error.counted());
                sum.shadowed += shadowed;
                sum.lost += mEmulation.shadowedOutside(judged.maps);
                if (!followed.empty()) {
                    sum.followed += followed.size();
                    sum.changed += changedPixels(followed, mEmulation.visibility(judged.maps),
                                                 mEmulation.visibility(judged.nextMaps, mNextView));
                }
                sum.microseconds.push_back(judged.feedback.microseconds);
                sum.fitMicroseconds.push_back(judged.fitMicroseconds);
                if (judged.feedback.state != FeedbackState::Used) continue;
                ++sum.used;
                sum.known += judged.feedback.known;
                sum.age += judged.feedback.age;
            }
        }
    }

private:
    struct JudgedMaps {
        int frame;
        std::vector<EmulatedMap> maps;
        double fitMicroseconds;
        FeedbackStatistics feedback;
        std::vector<EmulatedMap> nextMaps; ///< of the frame that follows
    };

    bool isJudged(int frame) const {
        if (frame >= mFrames) return frame < mFrames + AfterCut;
        return frame % Judged == Judged - 2 && frame + 1 < mFrames;
    }
    Phase phaseOf(int frame) const {
        if (frame < mFrames) return Phase::Walk;
        return frame == mFrames ? Phase::Cut : Phase::Settled;
    }

    void setView(const WalkAndCut& film, int frame) {
        SampleView view = frame < mFrames ? film.view : film.next;
        Ogre::Vector3 ahead = view.target - view.position;
        const auto passed = static_cast<float>(frame < mFrames ? frame : frame - mFrames);
        const Ogre::Vector3 level = Ogre::Vector3(ahead.x, 0.0F, ahead.z).normalisedCopy();
        ahead =
            Ogre::Quaternion(Ogre::Degree(DegreesPerFrame * passed), Ogre::Vector3::UNIT_Y) * ahead;
        view.position += mWalk * passed * level;
        view.target = view.position + ahead;
        mStage.setView(view);
    }

    OracleView oracleViewNow(int width, int height) const {
        return oracleView(mStage.camera(), width, height, mReach, mOracle.scene().wsOrigin);
    }

    void look(const WalkAndCut& film, int frame) {
        setView(film, frame);
        mEmulation.setView(oracleViewNow(mOptions.width, mOptions.height));
        mEmulation.setLight(oracleLight(mStage.light(), mOracle.scene().wsOrigin));
    }

    /// The pixels of a frame, which is looked at, that are seen in the next one too.
    std::vector<std::size_t> followedFrom(const WalkAndCut& film, int frame) {
        const OracleView view = oracleViewNow(mOptions.width, mOptions.height);
        setView(film, frame + 1);
        mNextView = oracleViewNow(mOptions.width, mOptions.height);
        return followedPixels(mEmulation.points(), view, mEmulation.truth(),
                              mOracle.visiblePoints(mNextView), mNextView);
    }

    /// What is seen of the receivers now.
    std::vector<VisiblePoint> exactPoints() const {
        constexpr int Columns = 60;
        constexpr int Rows = 27;
        const OracleView view = oracleViewNow(Columns, Rows);
        const VisiblePoints points = mOracle.visiblePoints(view);
        const ShadowTruth truth =
            mOracle.classify(points, view, oracleLight(mStage.light(), mOracle.scene().wsOrigin));
        std::vector<VisiblePoint> seen;
        for (std::size_t i = 0; i < points.pixels.size(); ++i)
            if (points.pixels[i] && truth.pixels[i] != PixelClass::NotReceiver)
                seen.push_back({points.pixels[i]->position + mOracle.scene().wsOrigin,
                                points.pixels[i]->normal});
        return seen;
    }

    std::vector<JudgedMaps> drawFilm(MapCapture& capture, const WalkAndCut& film,
                                     const FeedbackCandidate& candidate) {
        const NamedSetup& named = *findEmulatedSetup(candidate.setup);
        NamedSetup setup = withOptions(
            named, {candidate.points == Points::Feedback ? "feedback=on" : "feedback=off"});
        const auto instance = std::dynamic_pointer_cast<FittedShadowCameraSetup>(
            std::shared_ptr<Ogre::ShadowCameraSetup>(setup.create()));
        setup.create = [instance] { return Ogre::ShadowCameraSetupPtr(instance); };
        setView(film, 0);
        capture.begin(setup, mOptions.mapSize, mReach, mOracle.scene().wsOrigin);
        const auto draws = candidate.points == Points::Feedback ? MapCapture::Draws::Everything
                                                                : MapCapture::Draws::Nothing;
        std::vector<JudgedMaps> frames;
        for (int frame = 0; frame < mFrames + AfterCut; ++frame) {
            setView(film, frame);
            if (candidate.points == Points::Exact) instance->setVisiblePoints(exactPoints());
            const CapturedFrame captured = capture.nextFrame(draws);
            if (!frames.empty() && frames.back().frame + 1 == frame)
                frames.back().nextMaps = captured.maps;
            if (isJudged(frame))
                frames.push_back({frame,
                                  captured.maps,
                                  captured.fitMicroseconds,
                                  feedbackStatistics(mStage.camera()),
                                  {}});
        }
        return frames;
    }

    Stage& mStage;
    const TableOptions& mOptions;
    double mReach;
    int mFrames;
    float mWalk = 0.0F;
    OracleView mNextView;
    ShadowOracle mOracle;
    MapEmulation mEmulation;
};

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

GeometricMean ratioOf(const PhaseSums& sums, const PhaseSums& baseline) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < sums.errors.size(); ++i)
        ratios.push_back((sums.errors[i] + HalfPixelError) / (baseline.errors[i] + HalfPixelError));
    return geometricMean(ratios);
}

void printPhase(Phase phase, const std::vector<FeedbackCandidate>& candidates,
                const std::vector<std::array<PhaseSums, Phases>>& sums) {
    const auto at = static_cast<std::size_t>(phase);
    fmt::print(
        "\n{}: {} frames\n{:<12} {:<14} {:>8} {:>22} {:>14} {:>9} {:>7} {:>6} {:>6} {:>5} {:>10}\n",
        nameOf(phase), sums.front()[at].errors.size(), "setup", "judged by", "error", "/ view rays",
        "lost", "flicker", "fit ms", "used", "known", "age", "ms a frame");
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        const PhaseSums& sum = sums[c][at];
        const GeometricMean ratio = ratioOf(sum, sums[c - c % 3][at]);
        double errors = 0.0;
        for (const double error : sum.errors)
            errors += error;
        fmt::print("{:<12} {:<14} {:>6.3f} % {:>22} {:>14}", candidates[c].setup,
                   nameOf(candidates[c].points), 100.0 * errors / std::max(sum.counted, 1.0),
                   fmt::format("{:.3f} [{:.3f}, {:.3f}]", ratio.mean, ratio.lower, ratio.upper),
                   fmt::format("{} of {}", sum.lost, sum.shadowed));
        if (sum.followed > 0)
            fmt::print(" {:>7.4f} %", 100.0 * static_cast<double>(sum.changed) /
                                          static_cast<double>(sum.followed));
        else
            fmt::print(" {:>9}", "");
        fmt::print(" {:>7.3f}", 1e-3 * medianOf(sum.fitMicroseconds));
        if (candidates[c].points == Points::Feedback) {
            const auto used = static_cast<double>(std::max<std::size_t>(sum.used, 1));
            fmt::print(" {:>4.0f} % {:>4.0f} % {:>5.1f} {:>10.3f}",
                       100.0 * static_cast<double>(sum.used) /
                           static_cast<double>(std::max<std::size_t>(sum.errors.size(), 1)),
                       100.0 * sum.known / used, sum.age / used, 1e-3 * medianOf(sum.microseconds));
        }
        fmt::print("\n");
    }
}

} // namespace

void printFeedback(const TableOptions& options, int frames) {
    const std::vector<FeedbackCandidate> candidates = candidatesOfFeedback();
    std::vector<std::array<PhaseSums, Phases>> sums(candidates.size());
    for (const SampleScene& scene : measuredScenes()) {
        if (!options.kinds.empty() && std::ranges::count(options.kinds, scene.name) == 0) continue;
        Stage stage({.headless = true, .width = options.width, .height = options.height});
        stage.show(scene);
        FeedbackMeasurement measurement(stage, options, scene, frames);
        const std::size_t views = options.firstView ? 1 : scene.views.size();
        for (std::size_t v = 0; v < views; ++v) {
            const WalkAndCut film{scene.views[v], scene.views[(v + 1) % scene.views.size()]};
            for (std::size_t l = 0; l < std::min(options.lights, scene.lights.size()); ++l)
                measurement.measure(lightOf(scene, scene.views[v], l), film, candidates, sums);
            fmt::print(stderr, "{}, view {} of {}: done\n", scene.name, v + 1, views);
        }
    }
    fmt::print("{} frames a walk; {} x {} pixels, {} texels a side\n", frames, options.width,
               options.height, options.mapSize);
    for (std::size_t phase = 0; phase < Phases; ++phase)
        printPhase(static_cast<Phase>(phase), candidates, sums);
}

} // namespace Lixel::Samples
