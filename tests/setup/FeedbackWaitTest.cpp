// Feedback waits for nothing: OpenGL's functions, as they are handed to whoever asks for them, tell
// how they are called, and play a GPU that is slow.

#include "TestStage.h"

#include <Lixel/setup/ShadowCameraSetups.h>
#include <Lixel/setup/VisiblePointFeedback.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <dlfcn.h>

#include <string_view>

namespace {

using AnyFunction = void (*)();

struct Calls {
    int waits = 0;
    GLuint64 longestWait = 0;
    /// Of depths, and of those without a buffer to copy into.
    int depthReads = 0;
    int depthReadsAtOnce = 0;
    int finishes = 0;
    /// Whether nothing that is waited for is ever over.
    bool isSlow = false;
};
Calls calls;

PFNGLCLIENTWAITSYNCPROC realClientWaitSync;
decltype(&glReadPixels) realReadPixels;
decltype(&glGetIntegerv) realGetIntegerv;
decltype(&glFinish) realFinish;

GLenum GLAPIENTRY clientWaitSync(GLsync sync, GLbitfield flags, GLuint64 timeout) {
    ++calls.waits;
    calls.longestWait = std::max(calls.longestWait, timeout);
    return calls.isSlow ? GL_TIMEOUT_EXPIRED : realClientWaitSync(sync, flags, timeout);
}

void GLAPIENTRY readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                           GLenum type, void* pixels) {
    if (format == GL_DEPTH_COMPONENT) {
        GLint buffer = 0;
        realGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
        ++calls.depthReads;
        calls.depthReadsAtOnce += buffer == 0 ? 1 : 0;
    }
    realReadPixels(x, y, width, height, format, type, pixels);
}

void GLAPIENTRY finish() {
    ++calls.finishes;
    realFinish();
}

} // namespace

/// Before that of the headless library, which it asks.
extern "C" __attribute__((visibility("default"))) AnyFunction
glXGetProcAddressARB(const unsigned char* name) {
    using GetProcAddress = AnyFunction (*)(const unsigned char*);
    static const auto next =
        reinterpret_cast<GetProcAddress>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));
    const std::string_view wanted(reinterpret_cast<const char*>(name));
    const AnyFunction real = next(name);
    const auto instead = [&](auto& keptReal, auto* own) {
        keptReal = reinterpret_cast<std::remove_reference_t<decltype(keptReal)>>(real);
        return reinterpret_cast<AnyFunction>(own);
    };
    if (real == nullptr) return real;
    if (wanted == "glClientWaitSync") return instead(realClientWaitSync, &clientWaitSync);
    if (wanted == "glReadPixels") {
        realGetIntegerv = reinterpret_cast<decltype(realGetIntegerv)>(
            next(reinterpret_cast<const unsigned char*>("glGetIntegerv")));
        return instead(realReadPixels, &readPixels);
    }
    if (wanted == "glFinish") return instead(realFinish, &finish);
    return real;
}

namespace Lixel::Tests {
namespace {

class SeenStage : public BoxOnGround {
public:
    SeenStage() {
        const auto setup = XPSMShadowCameraSetup::create();
        setup->setFeedback(true);
        stage.setShadowSetup(setup);
        calls = {};
    }
    FeedbackStatistics draw(int frames = 1) {
        for (int i = 0; i < frames; ++i) {
            // On and on, so that every reading is news.
            stage.camera().getParentSceneNode()->translate(0.01F, 0, 0);
            stage.drawFrame();
        }
        return feedbackStatistics(stage.camera());
    }
};

TEST(FeedbackWaits, ForNothing) {
    SeenStage scene;
    EXPECT_EQ(scene.draw(8).state, FeedbackState::Used);
    EXPECT_GT(calls.waits, 8);
    EXPECT_EQ(calls.longestWait, 0U);
    EXPECT_GE(calls.depthReads, 4);
    EXPECT_EQ(calls.depthReadsAtOnce, 0);
    EXPECT_EQ(calls.finishes, 0);
}

TEST(FeedbackWaits, NotForASlowGpuEither) {
    SeenStage scene;
    calls.isSlow = true;
    FeedbackStatistics statistics = scene.draw(10);
    EXPECT_EQ(statistics.state, FeedbackState::NotReady);
    EXPECT_EQ(statistics.begun, 3U) << "there are three buffers";
    EXPECT_EQ(statistics.leftOut, 7U);
    EXPECT_EQ(statistics.arrived, 0U);
    EXPECT_EQ(calls.depthReads, 0) << "copying would wait for what is copied";
    EXPECT_EQ(calls.longestWait, 0U);
    // It catches up.
    calls.isSlow = false;
    statistics = scene.draw(3);
    EXPECT_EQ(statistics.state, FeedbackState::Used);
    EXPECT_EQ(statistics.leftOut, 7U);
    // What it has shown is too old after a while.
    calls.isSlow = true;
    statistics = scene.draw(3);
    EXPECT_EQ(statistics.state, FeedbackState::Used);
    statistics = scene.draw(20);
    EXPECT_EQ(statistics.state, FeedbackState::NotReady);
    EXPECT_LT(scene.nextFrameError().error, 0.5);
}

} // namespace
} // namespace Lixel::Tests
