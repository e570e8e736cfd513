#pragma once

#include "fit/problem/SeenPicture.h"

#include <cstdint>

namespace Ogre {
class Camera;
} // namespace Ogre

namespace Lixel {

/// What a viewer's frame is told of earlier ones.
struct Feedback {
    /// Null where nothing is known.
    const SeenPicture* seen = nullptr;
    /// Changes with each reading that is not as the one before.
    std::uint64_t version = 0;
};

/** What a viewer's earlier frames showed, for the frame that is being prepared; has his next frames
    read.
    @param now the viewer as he is, relative to wsOrigin */
Feedback feedbackFor(const Ogre::Camera& viewer, const ShadowViewer& now, const Vec3& wsOrigin);

/// Feedback::version, of what arrived by now.
std::uint64_t feedbackVersion(const Ogre::Camera& viewer);

/// Leaves all viewers.
void forgetFeedback();

} // namespace Lixel
