#pragma once

#include "HeadlessOgre.h"
#include "SkipDrawing.h"

#include "scene/OgreVersions.h"

#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreRenderTexture.h>
#include <OgreShadowCameraSetup.h>
#include <OgreTexture.h>

#include <array>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// Where the viewer stands and looks to.
enum class BenchView {
    Inside,  ///< from the middle of the field across it: a quarter of it is seen
    Outwards ///< from its rim, out of it: next to nothing is seen
};

inline constexpr std::array BenchViews{BenchView::Inside, BenchView::Outwards};

const char* toString(BenchView view);

/** A field of entities on the ground, in one scene manager, with a viewer for each view and one sun
    with one map of 1024². The field's side grows with the root of the number of entities, so that
    the viewer sees as many in a street of any town. */
class BenchScene {
public:
    BenchScene(HeadlessOgre& ogre, const std::string& managerType, std::size_t objects);
    BenchScene(const BenchScene&) = delete;
    BenchScene& operator=(const BenchScene&) = delete;
    ~BenchScene();

    Ogre::SceneManager& manager() { return mManager; }
    /// Whether LixelSceneManager is promised that changes of objects will be announced; others are
    /// promised nothing.
    void setChangesAnnounced(bool announced);
    std::size_t objects() const { return mNodes.size(); }

    /// From the next frame on.
    /// @param setup null for no shadows
    void use(BenchView view, const Ogre::ShadowCameraSetupPtr& setup);
    /// Whether what is found is drawn, too.
    void setDrawing(bool draws);
    /// Turns the viewer a little, as from one frame to the next.
    void turn(int frame);
    /// Moves that many of the entities, spread over the field, to and fro.
    void move(std::size_t count, int frame);
    /// Draws the view.
    void draw();
    /// Destroys the entities and all else but the viewers.
    void clear();

    const Ogre::Camera& camera() const { return *viewer().camera; }
    const Ogre::Light& sun() const { return *mSun; }
    static double shadowDistance();
    /// The texture of the sun's map, made at once.
    const Ogre::TexturePtr& shadowMap() { return mManager.getShadowTexture(0); }
    /// Of the last frame that was drawn.
    std::size_t viewDrawCalls() const;
    std::size_t mapDrawCalls();

private:
    struct Viewer {
        Ogre::Camera* camera;
        Ogre::SceneNode* node;
        Ogre::TexturePtr texture;
        float heading; ///< in degrees to the left of -z
        Ogre::RenderTarget& target() const { return *texture->getBuffer()->getRenderTarget(); }
    };

    void addViewer(BenchView view);
    void addSun();
    void addEntities(std::size_t objects);
    const Viewer& viewer() const { return mViewers.at(static_cast<std::size_t>(mView)); }

    Ogre::Root& mRoot;
    Ogre::SceneManager& mManager;
    float mReach;
    SkipDrawing mSkip;
    std::vector<Viewer> mViewers;
    BenchView mView = BenchView::Inside;
    Ogre::Light* mSun = nullptr;
    std::vector<Ogre::SceneNode*> mNodes;
};

/// Names of ten meshes, convex solids of 8 to 26 corners and a size of 1 on the ground, made on
/// first use. `manager` lends a hand.
const std::vector<std::string>& benchMeshes(Ogre::SceneManager& manager);

} // namespace Lixel::Tests
