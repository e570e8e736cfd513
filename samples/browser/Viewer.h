#pragma once

#include "browser/Options.h"
#include "common/Stage.h"

namespace Lixel::Samples {

/// Runs the window until it is closed: fly, switch setups and views, save pictures.
void runViewer(Stage& stage, const SampleScene& scene, const BrowserOptions& options);

} // namespace Lixel::Samples
