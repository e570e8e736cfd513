#pragma once

#include "HeadlessOgre.h"

#include <OgreCamera.h>
#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreRenderTexture.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTexture.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Lixel::Tests {

using Picture = std::vector<std::uint8_t>;

enum class Shape { Cube, Ball };

/** A ground with boxes and balls on it, a sun and a viewer, in a scene manager, drawn for real with
    Lixel's materials into a texture of its own.

    The viewer stands at (0, 6, 16) and looks at the origin; `origin` moves everything. */
class PictureScene {
public:
    PictureScene(HeadlessOgre& ogre, const std::string& managerType,
                 const Ogre::Vector3& origin = Ogre::Vector3::ZERO);
    PictureScene(const PictureScene&) = delete;
    PictureScene& operator=(const PictureScene&) = delete;
    ~PictureScene();

    Ogre::SceneManager& manager() { return mManager; }
    /// Of the origin; all that is added hangs there.
    Ogre::SceneNode& place() { return *mPlace; }

    /// On a node of its own.
    Ogre::Entity* add(Shape shape, const Ogre::Vector3& position, const Ogre::Vector3& size,
                      const Ogre::ColourValue& colour);
    /// A copy of what the surfaces wear.
    Ogre::MaterialPtr surface(const Ogre::ColourValue& colour);
    /// Has the sun shadow, with Lixel's caster.
    /// @param receiver the scene manager's material; empty for techniques that take none
    void castShadows(Ogre::ShadowTechnique technique, const std::string& receiver);
    /// What all surfaces, so far and from now on, are copies of.
    void wear(const std::string& material);
    /// Another texture of the same size, which is drawn before each picture.
    const Ogre::TexturePtr& addTexture(const std::string& name);

    /// Writes a picture where the environment's LIXEL_PICTURES names a folder, to be looked at.
    static void keep(const Picture& picture, const std::string& name);
    /// The next frame, an even time after the one before: moves what moves, and shows it.
    Picture draw();

    Ogre::Camera* camera = nullptr;
    Ogre::SceneNode* viewer = nullptr;
    Ogre::Light* sun = nullptr;
    /// Those that move between frames.
    std::vector<Ogre::SceneNode*> moving;
    Ogre::RenderTarget* target = nullptr;

private:
    void addView();
    void addSun();
    void addThings();
    void moveAll();

    HeadlessOgre& mOgre;
    Ogre::SceneManager& mManager;
    Ogre::SceneNode* mPlace = nullptr;
    std::string mSurface = "Lixel/Surface";
    std::vector<std::pair<Ogre::Entity*, Ogre::ColourValue>> mThings;
    std::vector<Ogre::TexturePtr> mTextures;
    std::vector<Ogre::MaterialPtr> mMaterials;
};

} // namespace Lixel::Tests
