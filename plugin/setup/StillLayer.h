#pragma once

#include "scene/Fingerprint.h"

#include <OgreSceneManager.h>
#include <OgreTexture.h>

#include <unordered_set>

namespace Ogre {
class Camera;
class MovableObject;
} // namespace Ogre

namespace Lixel {

class CasterFingerprint;
class CasterVolume;
struct MapContent;
struct ShadowTarget;

/// How a map that has to be drawn is drawn.
enum class MapDrawing {
    Whole,  ///< all casters into the cleared map
    Fill,   ///< what stands still, which is copied into the layer, and what moves over it
    Moving, ///< what moves, over a copy of the layer
};

/** What stands still of a map's casters, drawn by itself and kept in a texture of the map's size
    and format, where only some of its casters move.

    Which casters stand still is decided when the layer is filled, by how often their fingerprints
    were read and were the same (CasterFingerprint.h). The layer serves for as long as none of these
    changes. Everything else moves: what casts and is not held, whatever it may be.

    Where each texel holds the nearest depth of all that is drawn, in whatever order
    (NearestDepth.h), the map is the same to the last bit. Who draws it finds out whether something
    drawn depends on the order after all, and refuses the layer.
*/
class StillLayer {
public:
    /// So many maps are drawn whole for their casters before there is a layer: what moves once
    /// costs no texture.
    static constexpr unsigned LeastWait = 4;

    StillLayer() = default;
    ~StillLayer();
    StillLayer(const StillLayer&) = delete;
    StillLayer& operator=(const StillLayer&) = delete;

    // When the map is planned.

    /** The map has to be drawn because its casters changed, or may have: decides how.
        @param casters as read for this map now, each of them
        @param volume of the map's casters
        @param wanted what the map is to show: its matrices and settings */
    MapDrawing plan(const CasterFingerprint& casters, const CasterVolume& volume,
                    const MapContent& wanted);
    /// The map is kept or skipped, or drawn for another reason. After a while the texture goes.
    void rest();

    // When the map is drawn.

    /// Whether the object is one of those that stand still.
    bool holds(const Ogre::MovableObject& object) const { return mHeld.contains(&object); }
    /// Whether it shows what it holds, from where the camera is.
    bool isFilledFor(const Ogre::Camera& shadowCamera) const;
    /** What is held has been drawn into the map: copies it into the layer.
        @param seen what OGRE found of it
        @return whether there is a texture to copy it to */
    bool fill(const Ogre::Texture& map, const Ogre::Camera& shadowCamera,
              const Ogre::VisibleObjectsBoundsInfo& seen);
    /// Copies the layer into the map. isFilledFor() has to be true.
    void copyTo(const Ogre::Texture& map) const;
    /// What OGRE found of what is held, when it was drawn.
    const Ogre::VisibleObjectsBoundsInfo& seen() const { return mSeen; }
    /// The map cannot be drawn in layers as it is now; it is not tried again soon.
    void refuse();

private:
    bool serves(const CasterFingerprint& casters, const MapContent& wanted);
    bool pays(const CasterFingerprint& casters, const CasterVolume& volume,
              const MapContent& wanted) const;
    void hold(const CasterFingerprint& casters, const MapContent& wanted);
    void forget();
    void removeTexture();
    /// Whether its texture is as the map's.
    bool isLike(const Ogre::Texture& map) const;
    bool makeTexture(const Ogre::Texture& map);

    Ogre::TexturePtr mTexture;
    bool mIsFilled = false;
    Fingerprint mCamera;
    Ogre::VisibleObjectsBoundsInfo mSeen;

    // What it holds, and shows once it is filled.
    std::unordered_set<const Ogre::MovableObject*> mHeld;
    /// Whose casters they are. Those with the same fingerprint since this reading, or an earlier
    /// one.
    const CasterFingerprint* mSource = nullptr;
    unsigned long mUnchangedSince = 0;
    Fingerprint mMatrices;
    Fingerprint mSettings;
    unsigned long mGeneration = 0;

    // What decides whether it is of use.
    /// Maps drawn whole since there was a layer, and how many have to be before there is another.
    unsigned mDrawn = 0;
    unsigned mWait = LeastWait;
    /// Maps drawn with it since it was filled.
    unsigned mUses = 0;
    /// Casters that stood still and were drawn over the layer nevertheless, in all those maps.
    std::size_t mDrawnAnyway = 0;
    unsigned mRested = 0;
};

/// Whether a scene manager draws maps in layers where it can: whether it is LixelSceneManager.
bool drawsLayers(const Ogre::SceneManager& manager);
/// Whether such a map can be drawn in layers: whether it holds the nearest depths as colours.
bool canDrawInLayers(Ogre::SceneManager& manager, const ShadowTarget& target);

} // namespace Lixel
