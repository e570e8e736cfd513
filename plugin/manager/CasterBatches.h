#pragma once

#include "manager/BatchMaterials.h"
#include "manager/CasterBatch.h"

#include <OgreAutoParamDataSource.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Ogre {
class Camera;
class Entity;
class RenderQueue;
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Gathers the casters of a shadow map that are drawn alike, and queues one renderable a kind.

    Taken are parts of plain entities (PlainEntity.h) that OGRE would draw in the scene manager's
    own caster material: opaque, whole, not mirrored. All else is left to OGRE.
*/
class CasterBatches {
public:
    /// Fewer casters of a kind are drawn one by one.
    static constexpr std::size_t FewestCasters = 4;

    /// Begins a map. @return whether any caster may be taken
    bool begin(Ogre::SceneManager& manager, const Ogre::Camera& camera, Ogre::RenderQueue& queue);
    /// Whether parts of an entity may be taken.
    static bool takes(const Ogre::Entity& entity);
    /// Takes a part into a batch. @return false where OGRE has to draw it
    bool take(Ogre::SubEntity& part, Ogre::uint8 group, Ogre::ushort priority);
    /// Queues what was taken.
    void queue();

    /// How many batches were queued since it was last asked.
    std::size_t takeCount() { return std::exchange(mCount, 0); }
    /// Drops buffers and materials.
    void clear();

private:
    struct Hash {
        std::size_t operator()(const CasterBatchKey& key) const;
    };
    /// How a material's casters are drawn, in a map.
    struct Known {
        std::uint64_t map = 0;
        std::optional<Ogre::CullingMode> culling;
    };

    std::optional<Ogre::CullingMode> cullingOf(const Ogre::SubEntity& part);
    std::optional<Ogre::CullingMode> readCulling(const Ogre::SubEntity& part) const;
    void forgetUnused();

    BatchMaterials mMaterials;
    Ogre::AutoParamDataSource mSource;
    Ogre::RenderQueue* mQueue = nullptr;
    std::uint64_t mMap = 0;
    std::size_t mCount = 0;
    std::unordered_map<const Ogre::Material*, Known> mKnown;
    std::unordered_map<CasterBatchKey, std::unique_ptr<CasterBatch>, Hash> mBatches;
    /// Of this map, in the order in which their first casters came.
    std::vector<CasterBatch*> mBegun;
};

} // namespace Lixel
