#pragma once

#include "fit/core/FitState.h"

namespace Lixel {

/// What tells how much may have changed in what is seen since the frame before.
struct CascadeView {
    FrameFingerprint fingerprint;
    /// In the world.
    Vec3 wsEye = Vec3::Zero();
    /// The depth from which on there are receivers, hidden ones too.
    double vsReceiverNear = 0.0;
};

/// Room for finding the depths that are seen. Nobody else reads it.
struct CascadeScratch {
    FocusScratch focusing;
    FocusRegion region;
    SampleScratch sampling;
    std::vector<ViewSample> samples;
};

/// The depths between which slices lie: what outlives a frame.
struct CascadeMemory {
    /// Nearest and farthest depth, settled so far, in world units; 0 before.
    double nearest = 0.0;
    double farthest = 0.0;
    CascadeView view;
};

} // namespace Lixel
