#pragma once

#include <OgreMaterial.h>
#include <OgreRenderOperation.h>
#include <OgreRenderable.h>

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

namespace Ogre {
class AutoParamDataSource;
class SubEntity;
class SubMesh;
} // namespace Ogre

namespace Lixel {

/// What casters of one batch have in common.
struct CasterBatchKey {
    const Ogre::SubMesh* mesh;
    Ogre::CullingMode culling;
    Ogre::uint8 group;
    Ogre::ushort priority;

    friend bool operator==(const CasterBatchKey&, const CasterBatchKey&) = default;
};

/** Casters of one part of a mesh that are drawn by one call, as instances.

    An instance is the matrix to clip space by which it would be drawn alone: multiplied on the CPU,
    since its product with a vertex has to be that of single draws to the last bit. Vertices are
    positions only, so that the matrix's texture coordinates clash with none of the mesh's.
*/
class CasterBatch : public Ogre::Renderable {
public:
    explicit CasterBatch(const CasterBatchKey& key) : mKey(key) {}

    const CasterBatchKey& key() const { return mKey; }
    std::vector<Ogre::SubEntity*>& casters() { return mCasters; }
    /// The number of the map that it was last begun for.
    std::uint64_t map = 0;

    /// Whether the mesh's buffers can be drawn as instances.
    static bool canDraw(const Ogre::SubMesh& mesh);
    /// Writes its instances, for the camera that `source` has.
    void fill(Ogre::AutoParamDataSource& source, const Ogre::MaterialPtr& material);

    const Ogre::MaterialPtr& getMaterial() const override { return mMaterial; }
    void getRenderOperation(Ogre::RenderOperation& operation) override;
    void getWorldTransforms(Ogre::Matrix4* transforms) const override;
    Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }
    const Ogre::LightList& getLights() const override;
    bool getCastsShadows() const override { return true; }

private:
    void bindMesh();
    void reserveInstances();

    CasterBatchKey mKey;
    std::vector<Ogre::SubEntity*> mCasters;
    Ogre::MaterialPtr mMaterial;
    std::unique_ptr<Ogre::VertexData> mVertices;
    Ogre::HardwareVertexBufferSharedPtr mInstances;
};

} // namespace Lixel
