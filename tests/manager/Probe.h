#pragma once

#include <OgreMovableObject.h>
#include <OgreSimpleRenderable.h>
#include <OgreVertexIndexData.h>

#include <memory>

namespace Lixel::Tests {

inline const std::string ProbeType = "Probe";

/// An object of an application's own class: its bounds are what one likes, and what it queues has
/// no vertices.
class Probe : public Ogre::SimpleRenderable {
public:
    explicit Probe(const Ogre::String& name);

    /// The scene is told, as by OGRE's own objects.
    void setBox(const Ogre::AxisAlignedBox& box);

    const Ogre::String& getMovableType() const override { return ProbeType; }
    Ogre::Real getBoundingRadius() const override;
    Ogre::Real getSquaredViewDepth(const Ogre::Camera* camera) const override;

private:
    std::unique_ptr<Ogre::VertexData> mNoVertices;
};

/// For SceneManager::createMovableObject(name, ProbeType).
std::unique_ptr<Ogre::MovableObjectFactory> makeProbeFactory();

} // namespace Lixel::Tests
