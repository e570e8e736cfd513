#pragma once

#include "fit/geometry/Types.h"

// OgrePrerequisites.h of 1.12 declares MeshPtr and needs it.
#include <OgreSharedPtr.h>

#include <OgrePrerequisites.h>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

/** Reads a mesh's shape now, for all setups, scene managers and lights.

    Setups fit maps to the hulls of meshes (FittedShadowCameraSetup::setMeshHulls) and look at the
    surfaces of those that the viewer stands in or near. They read these from the mesh's buffers
    when they first need them, a little each frame (setMeshReadingTime). A mesh of a million
    vertices takes seconds, and until then its box has to do, which may make its map larger. Call
    this while a scene is loaded, for large meshes that should have their best map in the first
    frame: it takes about 0.1 s for a million vertices.

    @param parts that setups want of it, @see CommonOptions::meshParts; 0 for none

    The mesh is loaded if it is not yet. A mesh whose vertices move has no shape, and nothing is
    read. What is loaded anew later, or gets other bounds, has to be prepared anew.
    @throws Ogre::InvalidParametersException for a null pointer; what loading throws
*/
LIXEL_API void prepareMesh(const Ogre::MeshPtr& mesh, std::size_t parts = 0);

/** How long setups may read meshes in each frame, in microseconds, from the next frame on.

    Default 500. It is counted by what is read, not by a clock, so that the same frames always draw
    the same. 0 for none but what is prepared, infinity for all that is asked for at once.
    @throws Ogre::InvalidParametersException unless >= 0 */
LIXEL_API void setMeshReadingTime(Ogre::Real microseconds);
LIXEL_API Ogre::Real getMeshReadingTime();

/// @}
} // namespace Lixel
