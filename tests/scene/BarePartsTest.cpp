// Objects whose parts have no material.
#include "SceneTest.h"

#include <OgreLogManager.h>
#include <OgreRenderOperation.h>
#include <OgreRenderable.h>
#include <OgreSubEntity.h>

namespace Lixel::Tests {
namespace {

class Log : public Ogre::LogListener {
public:
    Log() { Ogre::LogManager::getSingleton().getDefaultLog()->addListener(this); }
    ~Log() override { Ogre::LogManager::getSingleton().getDefaultLog()->removeListener(this); }
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel, bool,
                       const Ogre::String&, bool&) override {
        if (message.find("Lixel:") != std::string::npos) lines.push_back(message);
    }
    std::vector<std::string> lines;
};

/// As OGRE leaves it where a material lies in another resource group than the mesh.
void takeMaterial(Ogre::Entity& entity) {
    const_cast<Ogre::MaterialPtr&>(entity.getSubEntity(0)->getMaterial()).reset();
}

/// An application's own object, which casts nothing.
class Own : public Ogre::MovableObject, public Ogre::Renderable {
public:
    Own() : MovableObject("own") { setCastShadows(false); }
    const Ogre::String& getMovableType() const override {
        static const Ogre::String type = "Own";
        return type;
    }
    const Ogre::AxisAlignedBox& getBoundingBox() const override { return mBox; }
    Ogre::Real getBoundingRadius() const override { return 2; }
    void _updateRenderQueue(Ogre::RenderQueue*) override {}
    void visitRenderables(Ogre::Renderable::Visitor* visitor, bool) override {
        visitor->visit(this, 0, false);
    }
    const Ogre::MaterialPtr& getMaterial() const override { return mMaterial; }
    void getRenderOperation(Ogre::RenderOperation&) override {}
    void getWorldTransforms(Ogre::Matrix4*) const override {}
    Ogre::Real getSquaredViewDepth(const Ogre::Camera*) const override { return 0; }
    const Ogre::LightList& getLights() const override { return mLights; }

private:
    Ogre::AxisAlignedBox mBox{-1, -1, -1, 1, 1, 1};
    Ogre::MaterialPtr mMaterial;
    Ogre::LightList mLights;
};

class BarePartsTest : public SceneTest {};

INSTANTIATE_TEST_SUITE_P(SceneManager, BarePartsTest,
                         testing::Values(DefaultManager, OctreeManager, FlatManager),
                         [](const auto& test) { return test.param; });

TEST_P(BarePartsTest, AreSurveyedAndToldOfOnce) {
    Ogre::Entity* const bare = addCube(Ogre::Vector3(0, 0, -10));
    Ogre::Entity* const clothed = addCube(Ogre::Vector3(3, 0, -10));
    takeMaterial(*bare);
    const Log log;
    for (int i = 0; i < 3; ++i)
        takeSurvey();
    EXPECT_TRUE(holds(mSurvey.receivers(), mSurvey, *bare)) << "OGRE's default white receives";
    EXPECT_TRUE(holds(mSurvey.receivers(), mSurvey, *clothed));
    EXPECT_TRUE(holds(allCasters(), mSurvey, *bare));
    ASSERT_EQ(log.lines.size(), 1U);
    for (const std::string& part : {"'" + bare->getName() + "'", std::string("part 0 of 1"),
                                    std::string("SubEntity::setMaterialName")})
        EXPECT_NE(log.lines[0].find(part), std::string::npos) << log.lines[0];
}

TEST_P(BarePartsTest, OfAnApplicationsOwn) {
    Own own;
    mRootNode->createChildSceneNode(Ogre::Vector3(0, 0, -10))->attachObject(&own);
    const Log log;
    takeSurvey();
    takeSurvey();
    EXPECT_TRUE(holds(mSurvey.receivers(), mSurvey, own));
    EXPECT_EQ(log.lines.size(), 1U);
}

} // namespace
} // namespace Lixel::Tests
