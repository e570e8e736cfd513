#include "setup/MeshPreparation.h"

#include "scene/MeshShapes.h"

#include <OgreException.h>
#include <OgreMesh.h>

namespace Lixel {

void prepareMesh(const Ogre::MeshPtr& mesh, std::size_t parts) {
    if (!mesh)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "mesh: there is none", "prepareMesh");
    mesh->load();
    MeshShapes::shared().prepare(mesh, parts);
}

void setMeshReadingTime(Ogre::Real microseconds) {
    if (!(microseconds >= 0))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "microseconds: the time to read meshes in must not be negative",
                    "setMeshReadingTime");
    MeshShapes::shared().setFrameTime(static_cast<double>(microseconds));
}

Ogre::Real getMeshReadingTime() {
    return static_cast<Ogre::Real>(MeshShapes::shared().frameTime());
}

} // namespace Lixel
