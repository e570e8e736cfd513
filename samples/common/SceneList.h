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

// Scenes by seed, with views and suns by seed: nobody has tuned a technique to them. What they have
// as ground casts, as everything of OGRE's does by default.

/// Rolling grassland with bushes, stones and fences.
SampleScene meadowScene();
/// An arched bridge over a wooded valley.
SampleScene bridgeScene();
/// A furnished hall with windows all around, which the sun shines through.
SampleScene interiorScene();
/// A bare forest in winter; ground and trees are one mesh.
SampleScene forestScene();
/// A city from the air.
SampleScene cityScene();
/// A weapon right before the camera, and a yard that goes on for hundreds of metres.
SampleScene weaponScene();
/// A furnished room without windows, lit by one lamp.
SampleScene lampRoomScene();
/// A plane of 100 000 units with few things on it, and no shadow distance.
SampleScene vastScene();
/// Rows of tilted solar panels.
SampleScene solarScene();
/// A car park, seen steeply from more than a kilometre away in a narrow field of view.
SampleScene telephotoScene();

/// A garden whose casters have holes, are bent by bones or are many of one mesh, all in materials
/// without programs.
SampleScene gardenScene();

} // namespace Lixel::Samples
