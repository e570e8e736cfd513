#include "Probe.h"

#include "Materials.h"

#include <OgreMaterialManager.h>
#include <OgreNode.h>

namespace Lixel::Tests {
namespace {

class ProbeFactory : public Ogre::MovableObjectFactory {
public:
    const Ogre::String& getType() const override { return ProbeType; }
    bool requestTypeFlags() const override { return true; }

protected:
    Ogre::MovableObject* createInstanceImpl(const Ogre::String& name,
                                            const Ogre::NameValuePairList*) override {
        return new Probe(name);
    }
};

} // namespace

Probe::Probe(const Ogre::String& name)
    : SimpleRenderable(name), mNoVertices(std::make_unique<Ogre::VertexData>()) {
    mRenderOp.vertexData = mNoVertices.get();
    mRenderOp.useIndexes = false;
    mMaterial = Ogre::MaterialManager::getSingleton().getByName(materials().front());
    mBox.setNull();
}

void Probe::setBox(const Ogre::AxisAlignedBox& box) {
    mBox = box;
    if (mParentNode != nullptr) mParentNode->needUpdate();
}

Ogre::Real Probe::getBoundingRadius() const {
    return mBox.isFinite() ? mBox.getHalfSize().length() + mBox.getCenter().length() : 0;
}

Ogre::Real Probe::getSquaredViewDepth(const Ogre::Camera* camera) const {
    return mParentNode != nullptr ? mParentNode->getSquaredViewDepth(camera) : 0;
}

std::unique_ptr<Ogre::MovableObjectFactory> makeProbeFactory() {
    return std::make_unique<ProbeFactory>();
}

} // namespace Lixel::Tests
