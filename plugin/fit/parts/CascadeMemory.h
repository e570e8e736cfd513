#pragma once

#include "fit/core/FitState.h"
#include "fit/problem/ShadowPart.h"

#include <array>
#include <utility>
#include <vector>

namespace Lixel {

/// What tells how much may have changed in what is seen since the frame before.
struct CascadeView {
    FrameFingerprint fingerprint;
    /// In the world.
    Vec3 wsEye = Vec3::Zero();
    /// The depth from which on there are receivers, hidden ones too.
    double vsReceiverNear = 0.0;
};

/// Room for dividing what is seen. Nobody else reads it.
struct CascadeScratch {
    FocusScratch focusing;
    FocusRegion region;
    SampleScratch sampling;
    /// What is seen of all slices together.
    std::vector<ViewSample> samples;
    /// Of samples: where they are along a direction of the light image, and how much they ask for.
    std::vector<std::pair<double, double>> demands;
    /// Of maps that are fitted to be judged.
    FitState judged;
};

/// Strips of the light image in place of slices by depth: what outlives a frame.
struct StripMemory {
    /// Direction across the strips, in the world; zero: slices by depth.
    Vec3 wsDirection = Vec3::Zero();
    /// Where strips meet, as shares of the focus region's extent along it. They stay as they are
    /// until others gain enough, so strips move only as the region does, and rest when it rests.
    std::array<double, ShadowPart::MostBounds> shares{};
    /// Strips or slices, and 0 before.
    std::size_t count = 0;
    /// How much has changed since another division was last judged, and which one is next.
    double change = 0.0;
    std::size_t next = 0;
    /// How often strips have begun, ended or been cut anew, other than by a camera cut.
    std::size_t jumps = 0;
};

/// How the view is divided: what outlives a frame.
struct CascadeMemory {
    /// Nearest and farthest depth, settled so far, in world units; 0 before.
    double nearest = 0.0;
    double farthest = 0.0;
    CascadeView view;
    /// How much has changed since the frame before; infinite after a camera cut.
    double change = 0.0;
    StripMemory strips;
};

} // namespace Lixel
