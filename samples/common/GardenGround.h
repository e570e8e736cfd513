#pragma once

#include <Ogre.h>

#include <span>
#include <vector>

namespace Lixel::Samples {

/// Height of the garden's ground, in metres: level around the origin, hills in the distance.
float gardenHeight(float x, float z);

/// A point of the ground, or that far above it.
Ogre::Vector3 onGarden(float x, float z, float above = 0.0F);

/// A smooth curve through points of x and z, in steps of about this length.
std::vector<Ogre::Vector2> curveThrough(std::span<const Ogre::Vector2> points, float step);

/// Distance of a place, x and z, from a line of such points.
float distanceFrom(std::span<const Ogre::Vector2> line, const Ogre::Vector2& place);

/// The ground, with hills all around.
Ogre::MeshPtr gardenGround(const Ogre::String& name);

/// A ribbon of this width on the ground, along a line of points; its texture's columns go across.
Ogre::MeshPtr gardenPath(const Ogre::String& name, std::span<const Ogre::Vector2> line,
                         float width);

} // namespace Lixel::Samples
