#pragma once

#include "fit/problem/ShadowProblem.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Ogre {
class Camera;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/// What a viewer's frame was given of what an earlier frame showed, or why it was not.
enum class FeedbackState {
    Used,         ///< fits judged by what was seen, where that is known
    NotAsked,     ///< no setup with CommonOptions::feedback has drawn a map for this viewer
    NotReady,     ///< nothing has arrived yet, or nothing of the last frames
    CameraCut,    ///< nothing of what was seen is in view any more
    NotSupported, ///< the render system is none of OpenGL's, or the viewport has no depth buffer
};

/// For logs, titles and statistics: "used", "camera cut", …
LIXEL_API const char* toString(FeedbackState state);

/// What feedback did in a viewer's last frame.
struct FeedbackStatistics {
    FeedbackState state = FeedbackState::NotAsked;
    /// How many frames ago the depths were drawn that were used, of those in which maps were fitted.
    unsigned age = 0;
    /// The grid of pixels that is read, and how many of them showed a surface whose normal is
    /// certain.
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::size_t points = 0;
    /// Part of the picture, 0 to 1, about which the earlier frame says something; view rays see the
    /// rest.
    double known = 0.0;
    /// CPU time of it all on the thread that draws, in microseconds.
    double microseconds = 0.0;
    /// Since the viewer was first asked for: readings that were begun and that have arrived, and
    /// frames whose reading was left out because too many were under way.
    std::uint64_t begun = 0;
    std::uint64_t arrived = 0;
    std::uint64_t leftOut = 0;
};

/** What setups with CommonOptions::feedback were given in a viewer's last frame.

    Feedback reads a few pixels of each frame's depth buffer back, as soon as the GPU has drawn them
    and without waiting for it, a frame or two later. Setups that judge maps by samples (XPSM,
    Optimal, cascades) judge by these points, where the viewer still sees them; by view rays, as
    without feedback, where he sees what was hidden or out of view. What a map shows, the focus
    region, is never made smaller for it: a few pixels do not tell what lies between them. So
    feedback never costs a visible point its shadow, whatever has moved. */
LIXEL_API FeedbackStatistics feedbackStatistics(const Ogre::Camera& viewer);

/// The points of the latest reading of a viewer that has arrived, in the world; none without.
LIXEL_API std::vector<VisiblePoint> feedbackPoints(const Ogre::Camera& viewer);

/** The grid of pixels that is read, of all viewers: about as many columns and rows, at odd
    distances. 60 x 27 at first.
    @throws Ogre::InvalidParametersException unless both are from 8 to 512. */
LIXEL_API void setFeedbackSize(std::size_t columns, std::size_t rows);

/// @}
} // namespace Lixel
