#pragma once

#include <Ogre.h>

#include <memory>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// What an import added to a scene.
struct ImportedModel {
    Ogre::SceneNode* node = nullptr; ///< carries everything, ground included
    Ogre::AxisAlignedBox box;        ///< of the model alone, in the node's coordinates
    std::size_t triangles = 0;       ///< of all instances, without back sides and ground
    bool groundAdded = false;
    std::vector<std::string> notes; ///< what was left out, such as a texture nobody can read
};

/** A model file of any format that Assimp reads: glTF, OBJ, PLY, FBX, IFC, COLLADA and more.

    Keeps the file's units, its node hierarchy and, per material, base colour and diffuse texture
    (from a file or embedded) where OGRE has a codec for it; otherwise the plain colour. Missing
    normals are made, smooth up to 50 degrees. Meshes under a node that OGRE cannot hold (shear,
    mirroring, unequal scales) are baked to the model's root. Two-sided materials get back sides of
    their own, so that back-face culling and lighting stay right. Everything is opaque and unmoving:
    transparency, skinning and animation are not shown.
*/
class ModelFile {
public:
    /** Reads and checks a file; needs no OGRE root.
        @exception Ogre::FileNotFoundException when there is no such file;
        Ogre::InvalidParametersException, with the file's name and what is wrong with it, when
        Assimp cannot read it, or when it holds no triangles, a position or node transform that is
        not finite (or beyond 1e15), or nothing of any extent
    */
    explicit ModelFile(const std::string& path);
    ~ModelFile();
    ModelFile(ModelFile&&) noexcept;
    ModelFile& operator=(ModelFile&&) noexcept;

    /// Box of all triangles, in the file's units.
    const Ogre::AxisAlignedBox& box() const;
    /// Of all instances, without back sides and ground.
    std::size_t triangles() const;
    /** Whether the model stands on a ground of its own.

        It does when the triangles in the lowest twentieth of its height that face up (within 25
        degrees) cover at least 60 % of its footprint's rectangle, seen from above.
    */
    bool hasGround() const;

    /** Adds the model on a new node below `parent`, on a plain ground at its lowest point unless it
        has its own. Meshes and materials of an earlier import of the same file are replaced.
        @exception Ogre::ItemIdentityException without the material Lixel/Surface
    */
    ImportedModel addTo(Ogre::SceneManager& sceneManager, Ogre::SceneNode& parent) const;

private:
    struct Impl;
    std::unique_ptr<Impl> mImpl;
};

/// Reads a file and adds it: ModelFile(path).addTo(sceneManager, parent).
ImportedModel importModel(Ogre::SceneManager& sceneManager, Ogre::SceneNode& parent,
                          const std::string& path);

} // namespace Lixel::Samples
