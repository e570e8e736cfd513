#include "setup/VisiblePointFeedback.h"

#include "scene/Log.h"
#include "scene/ViewerOf.h"
#include "setup/DepthReader.h"
#include "setup/ViewerFeedback.h"

#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <memory>
#include <utility>

namespace Lixel {
namespace {

constexpr std::size_t LeastSide = 8;
constexpr std::size_t MostSide = 512;

/// A reading of a frame that was drawn so many frames ago says little.
constexpr std::uint64_t OldestReading = 8;

std::size_t wantedColumns = 60;
std::size_t wantedRows = 27;

/// Adds this thread's CPU time to a sum, in microseconds. A software renderer draws the picture
/// when its depths are gathered, by other threads.
class Stopwatch {
public:
    explicit Stopwatch(double& sum) : mSum(sum) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { mSum += now() - mBegin; }

private:
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
    }

    double& mSum;
    double mBegin = now();
};

/// A viewer as he was when a frame was drawn.
struct Moment {
    ShadowViewer viewer;
    Vec3 wsOrigin = Vec3::Zero();
    /// Of those that asked.
    std::uint64_t frame = 0;

    /// Whether he saw the same.
    bool operator==(const Moment& other) const {
        return viewer.viewFromWorld == other.viewer.viewFromWorld &&
               viewer.clipFromView == other.viewer.clipFromView && wsOrigin == other.wsOrigin;
    }
};

/*  In a frame: cameraPreRenderScene fetches what has arrived, setups ask for it while shadow
    textures are prepared, cameraPostRenderScene has the frame read if any did. */
class ViewerListener final : public Ogre::Camera::Listener {
public:
    explicit ViewerListener(Ogre::Camera& camera) : mCamera(camera) { camera.addListener(this); }
    ViewerListener(const ViewerListener&) = delete;
    ViewerListener& operator=(const ViewerListener&) = delete;
    ~ViewerListener() override { mCamera.removeListener(this); }

    Feedback ask(const ShadowViewer& now, const Vec3& wsOrigin);
    std::uint64_t version() const { return mVersion; }
    FeedbackStatistics statistics() const { return mStatistics; }
    std::vector<VisiblePoint> points() const {
        std::vector<VisiblePoint> result = mSurfaces.points;
        for (VisiblePoint& point : result)
            point.ws += mThen.wsOrigin;
        return result;
    }

    void cameraPreRenderScene(Ogre::Camera*) override;
    void cameraPostRenderScene(Ogre::Camera*) override;
    void cameraDestroyed(Ogre::Camera* camera) override;

private:
    /// Takes what has arrived.
    void fetch();
    FeedbackState use(const Moment& now);

    Ogre::Camera& mCamera;
    DepthReader mReader;
    std::uint64_t mBegun = 0;
    /// Frames that asked for it.
    std::uint64_t mFramesAsked = 0;
    /// The viewer for whom it was last asked.
    Moment mAsked;
    /// The viewer of each reading under way, by its number.
    std::array<Moment, DepthReader::Buffers> mMoments;
    /// The frame that was last asked for, and the last one read.
    unsigned long mFrame = 0;
    bool mIsAsked = false;
    bool mIsRead = false;

    // The latest that has arrived.
    DepthReading mReading;
    DepthReading mArriving;
    Moment mThen;
    SeenSurfaces mSurfaces;
    std::uint64_t mVersion = 0;

    // What is seen of it by now.
    SeenPicture mSeen;
    Moment mNow;
    std::uint64_t mSeenVersion = 0;
    FeedbackStatistics mStatistics;
};

using Viewers = std::map<const Ogre::Camera*, std::unique_ptr<ViewerListener>>;

/// Never destroyed: at the end of the process OpenGL may be gone before a Root that nobody deleted.
Viewers& viewers() {
    static Viewers& all = *new Viewers;
    return all;
}

ViewerListener* findViewer(const Ogre::Camera& camera) {
    const auto found = viewers().find(&camera);
    return found == viewers().end() ? nullptr : found->second.get();
}

void ViewerListener::cameraDestroyed(Ogre::Camera* camera) {
    viewers().erase(camera); // destroys this
}

void ViewerListener::cameraPreRenderScene(Ogre::Camera*) {
    const unsigned long frame = Ogre::Root::getSingleton().getNextFrameNumber();
    if (frame != std::exchange(mFrame, frame)) {
        mIsAsked = mIsRead = false;
        mStatistics.microseconds = 0.0;
        mStatistics.state = FeedbackState::NotAsked;
    }
    fetch();
}

void ViewerListener::fetch() {
    const Stopwatch watch(mStatistics.microseconds);
    if (!mReader.fetch(mArriving)) return;
    ++mStatistics.arrived;
    const Moment& then = mMoments[mArriving.number % DepthReader::Buffers];
    const bool isSame = mVersion > 0 && mArriving.depths == mReading.depths && then == mThen;
    std::swap(mReading, mArriving);
    mThen = then;
    if (isSame) return;
    surfacesOf(mReading.grid, mThen.viewer.clipFromView * mThen.viewer.viewFromWorld, mSurfaces);
    mStatistics.columns = mReading.grid.columns;
    mStatistics.rows = mReading.grid.rows;
    mStatistics.points = mSurfaces.points.size();
    ++mVersion;
}

FeedbackState ViewerListener::use(const Moment& now) {
    if (!DepthReader::isSupported() || mReader.isBroken()) return FeedbackState::NotSupported;
    if (mVersion == 0 || mFramesAsked - mThen.frame > OldestReading) return FeedbackState::NotReady;
    if (mSeenVersion != mVersion || !(mNow == now)) {
        mSeen.take(mSurfaces, now.viewer, mThen.wsOrigin - now.wsOrigin);
        mSeenVersion = mVersion;
        mNow = now;
    }
    return mSeen.known() > 0 ? FeedbackState::Used : FeedbackState::CameraCut;
}

Feedback ViewerListener::ask(const ShadowViewer& now, const Vec3& wsOrigin) {
    if (!std::exchange(mIsAsked, true)) ++mFramesAsked;
    const Stopwatch watch(mStatistics.microseconds);
    mAsked = {now, wsOrigin, mFramesAsked};
    mStatistics.state = use(mAsked);
    const bool isUsed = mStatistics.state == FeedbackState::Used;
    mStatistics.known =
        isUsed ? static_cast<double>(mSeen.known()) / static_cast<double>(PictureCells::Count)
               : 0.0;
    mStatistics.age = isUsed ? static_cast<unsigned>(mFramesAsked - mThen.frame) : 0;
    return {isUsed ? &mSeen : nullptr, mVersion};
}

void ViewerListener::cameraPostRenderScene(Ogre::Camera*) {
    // A frame may show a viewer several times: the first one with shadows is read.
    if (!mIsAsked || mIsRead || !DepthReader::isSupported()) return;
    // A camera's own viewport is the one that was made or resized last.
    const Ogre::Viewport* const viewport = mCamera.getSceneManager()->getCurrentViewport();
    Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    if (viewport == nullptr || viewport != system._getViewport()) return;
    const Stopwatch watch(mStatistics.microseconds);
    mIsRead = true;
    const bool wasBroken = mReader.isBroken();
    if (mReader.begin(*viewport, wantedColumns, wantedRows, mBegun + 1)) {
        ++mBegun;
        // Not as the camera is by now: another listener may have put it back already.
        mMoments[mBegun % DepthReader::Buffers] = mAsked;
        ++mStatistics.begun;
    } else if (!mReader.isBroken()) {
        ++mStatistics.leftOut;
    } else if (!wasBroken) {
        logWarning("there is no feedback for camera '" + mCamera.getName() +
                   "': the depth buffer of its viewport cannot be read");
    }
}

} // namespace

const char* toString(FeedbackState state) {
    switch (state) {
    case FeedbackState::Used:
        return "used";
    case FeedbackState::NotAsked:
        return "not asked for";
    case FeedbackState::NotReady:
        return "not ready yet";
    case FeedbackState::CameraCut:
        return "camera cut";
    case FeedbackState::NotSupported:
        return "not supported";
    }
    return "?";
}

Feedback feedbackFor(const Ogre::Camera& viewer, const ShadowViewer& now, const Vec3& wsOrigin) {
    std::unique_ptr<ViewerListener>& listener = viewers()[&viewer];
    if (listener == nullptr) {
        // OGRE hands out its own, mutable camera as const.
        listener = std::make_unique<ViewerListener>(const_cast<Ogre::Camera&>(viewer));
        static bool isTold = false;
        if (!DepthReader::isSupported() && !std::exchange(isTold, true))
            logWarning("there is no feedback with this render system, only with OpenGL");
    }
    return listener->ask(now, wsOrigin);
}

std::uint64_t feedbackVersion(const Ogre::Camera& viewer) {
    const ViewerListener* const listener = findViewer(viewer);
    return listener != nullptr ? listener->version() : 0;
}

void forgetFeedback() {
    viewers().clear();
    DepthReader::forgetDiscarded();
}

FeedbackStatistics feedbackStatistics(const Ogre::Camera& viewer) {
    const ViewerListener* const listener = findViewer(viewer);
    return listener != nullptr ? listener->statistics() : FeedbackStatistics();
}

std::vector<VisiblePoint> feedbackPoints(const Ogre::Camera& viewer) {
    const ViewerListener* const listener = findViewer(viewer);
    return listener != nullptr ? listener->points() : std::vector<VisiblePoint>();
}

void setFeedbackSize(std::size_t columns, std::size_t rows) {
    if (std::min(columns, rows) < LeastSide || std::max(columns, rows) > MostSide)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "columns and rows must be from 8 to 512",
                    "Lixel::setFeedbackSize");
    wantedColumns = columns;
    wantedRows = rows;
}

} // namespace Lixel
