#pragma once

#include "common/Scenes.h"

namespace Lixel::Samples {

/// Many things standing on a wide plane, as in Gusev 2007, figure 1.
SampleScene fieldScene();
/// Dueling frusta: the viewer looks into a low sun behind a row of trees, columns and a fence.
SampleScene duelScene();
/// A pillared hall lit by a lamp beside the viewer's head only.
SampleScene minersLampScene();
/// Houses along a street when the sun is low.
SampleScene streetScene();
/// A garden whose casters have holes, are bent by bones or are many of one mesh, all in materials
/// without programs.
SampleScene gardenScene();

} // namespace Lixel::Samples
