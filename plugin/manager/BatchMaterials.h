#pragma once

#include "scene/Fingerprint.h"

#include <OgreBlendMode.h>
#include <OgreCommon.h>
#include <OgreGpuProgram.h>
#include <OgreMaterial.h>

#include <array>
#include <string>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** What batches of casters wear: a scene manager's shadow caster material, with the vertex program
    for instances.

    A material whose shadow caster is its own keeps the culling that this one has, so there is one
    for each culling mode.
*/
class BatchMaterials {
public:
    BatchMaterials() = default;
    ~BatchMaterials();
    BatchMaterials(const BatchMaterials&) = delete;
    BatchMaterials& operator=(const BatchMaterials&) = delete;

    /** Follows the scene manager's caster material.
        @return whether there is one that can be drawn as instances; where there is one of Lixel's
        but the render system or its programs cannot, the log says why, once */
    bool follow(Ogre::SceneManager& manager);
    /// After follow().
    const Ogre::MaterialPtr& of(Ogre::CullingMode culling);
    /// Drops the materials.
    void clear();

private:
    struct Worn {
        Ogre::MaterialPtr surface;
        Ogre::MaterialPtr caster;
    };

    bool sayCannot(const std::string& reason);
    bool canDrawInstances();
    Ogre::MaterialPtr makeMaterial(const char* kind, Ogre::CullingMode culling) const;
    /// Makes a material's pass the scene manager's caster, for instances.
    void copyCaster(Ogre::Material& material, Ogre::CullingMode culling) const;

    Ogre::SceneManager* mManager = nullptr;
    /// By culling mode, whose numbers begin at 1.
    std::array<Worn, 4> mWorn;
    Fingerprint mState;
    Ogre::GpuProgramPtr mProgram;
    bool mSaid = false;
};

} // namespace Lixel
