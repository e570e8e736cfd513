// lixel-bench-fit: CPU time of the fits alone, by the number of boxes.
//
//     lixel-bench-fit [--benchmark_filter=REGEX] [other options of Google Benchmark]
//
// A field of boxes on a large ground, as in lixel-bench-survey, with the viewer in its middle. The
// viewer turns a little from one fit to the next, as it does from frame to frame. Each fit is
// measured with nothing known of the bodies but their boxes, with bodies that are known to be
// these, and with hills for a ground. Optimal is also measured with `edge_weight` and without
// `skewed_maps`. Cascades are three maps of Optimal, divided and fitted: into slices by depth, or
// into strips where they are judged better.
#include "fit/core/FitState.h"
#include "fit/parts/CascadeDivision.h"
#include "fit/technique/Optimal.h"
#include "fit/technique/Techniques.h"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include <array>
#include <numbers>
#include <random>

namespace Lixel::Bench {
namespace {

constexpr double Degree = std::numbers::pi / 180.0;

struct Light {
    const char* name;
    LightKind kind;
};
constexpr std::array<Light, 2> Lights = {
    {{"directional", LightKind::Directional}, {"spot", LightKind::Spot}}};

constexpr std::array<int, 4> Sizes = {10, 100, 1000, 10000};

/// OpenGL's perspective projection of 60° and 16 : 9.
Mat4 projection() {
    constexpr double Near = 0.1;
    constexpr double Far = 2000.0;
    const double focal = 1.0 / std::tan(30.0 * Degree);
    Mat4 m = Mat4::Zero();
    m(0, 0) = focal * 9.0 / 16.0;
    m(1, 1) = focal;
    m(2, 2) = -(Far + Near) / (Far - Near);
    m(2, 3) = -2.0 * Far * Near / (Far - Near);
    m(3, 2) = -1.0;
    return m;
}

/// What is known of the bodies beyond their boxes.
enum class Known {
    Nothing,
    Boxes, ///< that they are these
    Hills, ///< the same, but the first is a ground of low hills in as many cells as are read
};
struct NamedKnowledge {
    const char* suffix;
    Known known;
};
constexpr std::array<NamedKnowledge, 3> AllKnowledge = {
    {{"", Known::Nothing}, {"/boxes", Known::Boxes}, {"/hills", Known::Hills}}};

/// Bodies that fill their boxes, the same among casters and receivers.
class Boxes final : public BodyShapes {
public:
    /// @param hills whether the first of them is a ground of hills
    Boxes(const BoxSet& boxes, bool hills) : mBoxes(boxes), mHasHills(hills) {
        if (!hills) return;
        constexpr auto Side = static_cast<int>(ReliefBuilder::Side);
        mHills.steepness = 0.1;
        const Aabb ground = boxes.box(0);
        const Vec3 size = ground.halfExtents * 2.0 / Side;
        for (int i = 0; i < Side * Side; ++i) {
            const double x = i % Side * size.x();
            const double z = i / Side * size.z();
            const Vec3 least = ground.centre - ground.halfExtents + Vec3(x, 0.0, z);
            // Half of them are higher than others.
            const Vec3 most =
                least + Vec3(size.x(), (i % 2 + 1) * ground.halfExtents.y(), size.z());
            mHills.cells.push_back({{least.cast<float>(), most.cast<float>()},
                                    decltype(ReliefCell::rise)::Constant(0.1F)});
        }
    }

    const BodyHull* hullOf(std::size_t, Transform3&) const noexcept override { return nullptr; }
    const void* identityOf(std::size_t index) const noexcept override {
        return reinterpret_cast<const void*>(index + 1);
    }
    bool isSelfShadowFree(std::size_t index, SelfShadowFree& body) const noexcept override {
        const bool isHills = mHasHills && index == 0;
        body = {.around = {mBoxes.box(index), Transform3::Identity()},
                .isBox = !isHills,
                .relief = isHills ? &mHills : nullptr};
        return true;
    }

private:
    const BoxSet& mBoxes;
    bool mHasHills;
    Relief mHills;
};

/// The field, relative to a viewer 5 units above the middle of its ground.
class Field {
public:
    Field(LightKind kind, int objects, Known known) {
        constexpr double Eye = 5.0;
        const double reach = 10.0 * std::sqrt(objects);
        std::mt19937 engine(1);
        std::uniform_real_distribution<double> place(-reach / 2.0, reach / 2.0);
        std::uniform_real_distribution<double> size(0.5, 6.0);
        mBodies.add({Vec3(0.0, -0.5 - Eye, 0.0), Vec3(reach, 1.0, reach) / 2.0});
        for (int i = 1; i < objects; ++i) {
            const Vec3 sides(size(engine), size(engine), size(engine));
            mBodies.add({Vec3(place(engine), sides.y() / 2.0 - Eye, place(engine)), sides / 2.0});
        }
        problem.viewer.clipFromView = projection();
        problem.viewer.shadowDistance = 300.0;
        problem.light.kind = kind;
        problem.light.wsDirection = Vec3(1.0, -1.0, 0.3);
        // A lamp post that lights some hundred boxes around and ahead of the viewer.
        if (kind == LightKind::Spot) {
            problem.light.wsPosition = Vec3(-30.0, 35.0, -10.0);
            problem.light.outerHalfAngle = 40.0 * Degree;
            problem.light.range = 200.0;
        }
        problem.casters = &mBodies;
        problem.receivers = &mBodies;
        if (known != Known::Nothing) {
            mShapes.emplace(mBodies, known == Known::Hills);
            problem.casterShapes = problem.receiverShapes = &*mShapes;
        }
    }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;

    /// Turns the viewer to where it looks in that frame: to and fro over 20°.
    void setFrame(int frame) {
        const double heading = 0.2 * std::abs(frame % 200 - 100) * Degree;
        problem.viewer.viewFromWorld.topLeftCorner<3, 3>() =
            Eigen::AngleAxisd(-heading, Vec3::UnitY()).toRotationMatrix();
    }

    ShadowProblem problem;

private:
    BoxSet mBodies;
    std::optional<Boxes> mShapes;
};

void measure(benchmark::State& state, const FitTechnique& technique,
             const std::shared_ptr<const void>& options, LightKind kind, int objects, Known known) {
    Field field(kind, objects, known);
    FitState memory;
    int frame = 0;
    for (auto _ : state) {
        field.setFrame(frame++);
        const ShadowFit fit = technique.fit(field.problem, options.get(), memory);
        if (!fit.hasMap()) {
            state.SkipWithError(toString(fit.reason));
            break;
        }
        benchmark::DoNotOptimize(fit);
    }
}

void measureCascades(benchmark::State& state, LightKind kind, int objects, bool strips) {
    Field field(kind, objects, Known::Nothing);
    constexpr std::size_t Maps = 3;
    const CascadeOptions options{.stripLight = strips};
    const PartFit technique = [](const ShadowProblem& part, FitState& memory) {
        return fitMap(part, OptimalOptions{}, memory);
    };
    CascadeMemory memory;
    CascadeScratch scratch;
    std::vector<double> vsSplits;
    std::array<FitState, Maps> states;
    int frame = 0;
    for (auto _ : state) {
        field.setFrame(frame++);
        const LightPartition parts =
            divideView(field.problem, Maps, options, 0.0, memory, scratch, vsSplits, technique);
        for (std::size_t i = 0; i < parts.count; ++i)
            benchmark::DoNotOptimize(
                technique(problemOf(field.problem, parts.parts[i]), states[i]));
    }
}

} // namespace
} // namespace Lixel::Bench

int main(int argc, char** argv) {
    using namespace Lixel::Bench;
    for (const Lixel::FitTechnique* const technique : Lixel::techniques())
        for (const Light& light : Lights)
            for (const int objects : Sizes)
                for (const auto& [suffix, known] : AllKnowledge) {
                    const std::string name = std::string(technique->name) + "/" + light.name + "/" +
                                             std::to_string(objects) + suffix;
                    const auto run = [technique, light, objects, known](auto& state) {
                        measure(state, *technique, technique->makeOptions(nullptr), light.kind,
                                objects, known);
                    };
                    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
                }
    const std::pair<const char*, Lixel::OptimalOptions> variants[] = {
        {"/edges", {.edgeWeight = 0.6}}, {"/rectangles", {.skewedMaps = false}}};
    for (const auto& [variant, options] : variants)
        for (const Light& light : Lights)
            for (const int objects : Sizes) {
                const std::string name =
                    std::string("Optimal/") + light.name + "/" + std::to_string(objects) + variant;
                const auto run = [light, objects, options](auto& state) {
                    measure(state, Lixel::OptimalOptions::technique(),
                            std::make_shared<Lixel::OptimalOptions>(options), light.kind, objects,
                            Known::Nothing);
                };
                benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
            }
    for (const Light& light : Lights)
        for (const int objects : Sizes)
            for (const bool strips : {false, true}) {
                const std::string name = std::string("Cascades/") + light.name + "/" +
                                         std::to_string(objects) + (strips ? "/strips" : "");
                const auto run = [light, objects, strips](auto& state) {
                    measureCascades(state, light.kind, objects, strips);
                };
                benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
            }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
