#pragma once

#include <memory>

namespace Ogre {
class Entity;
class SubEntity;
class VertexData;
} // namespace Ogre

namespace Lixel::Samples {

/** The pose that an entity has now, also where a GPU blends it: as long as this lives, OGRE blends
    it too.

    Bones and morph animation can be had so. Pose animation cannot: beside hardware, OGRE adds its
    poses to what the buffers happen to hold.
*/
class BlendedPose {
public:
    /** @param entity has to outlive this; one that is not animated stays as it is
        @exception Ogre::InvalidParametersException for pose animation in hardware
    */
    explicit BlendedPose(Ogre::Entity& entity);

    /// The vertices of one of the entity's visible parts, in the space of the entity's node.
    /// @param drawn what OGRE draws the part with
    Ogre::VertexData* verticesOf(Ogre::SubEntity& part, Ogre::VertexData* drawn) const;

private:
    struct TakeRequestBack {
        void operator()(Ogre::Entity* entity) const;
    };
    /// The entity while OGRE is asked to blend it beside a GPU, else null.
    std::unique_ptr<Ogre::Entity, TakeRequestBack> mRequested;
};

} // namespace Lixel::Samples
