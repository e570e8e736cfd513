#include "setup/StillLayer.h"

#include "scene/CasterFingerprint.h"
#include "scene/CasterVolume.h"
#include "scene/Log.h"
#include "scene/NodeStore.h"
#include "scene/OgreVersions.h"
#include "setup/MapContent.h"
#include "setup/ShadowPass.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreTextureManager.h>

#include <algorithm>

namespace Lixel {
namespace {

/// A caster stands still when it was the same in this many more readings than one. It has to be
/// more than a few, so that what moves in every second or third frame does not count as still, and
/// has the layer drawn anew each time.
constexpr unsigned long ReadingsStill = 8;

/// A layer that served for fewer maps than LeastWait was of no use, and each time the next one
/// waits twice as long, up to this: filling one costs a copy and a second search, so that then at
/// most 2 % is lost where something always begins to move.
constexpr unsigned LongestWait = 64;

/// Plans without use after which the texture goes: two seconds at 60 frames a second.
constexpr unsigned PlansUnused = 120;

/// Copying so many texels takes as long as drawing one caster, and less: 6 µs to 20 µs of software
/// rendering (1024² take 0.1 ms, 2048² 1.2 ms), beside 10 µs and more of drawing.
constexpr std::size_t TexelsOfACaster = 65536;
/// Where fewer of a map's casters than one in so many stand still, there is not much to save.
constexpr std::size_t LeastStillShare = 4;

Fingerprint placeOf(const Ogre::Camera& shadowCamera) {
    Fingerprint place;
    addMatrices(shadowCamera, place);
    return place;
}

void copyTexels(const Ogre::Texture& from, const Ogre::Texture& to) {
    const Ogre::Box all(0, 0, from.getWidth(), from.getHeight());
    // Both are read or written by the render system; OGRE's buffers know no constness.
    const_cast<Ogre::Texture&>(to).getBuffer()->blit(const_cast<Ogre::Texture&>(from).getBuffer(),
                                                     all, all);
    // It may have left another target bound than the active viewport's.
    Ogre::Root::getSingleton().getRenderSystem()->_setViewport(nullptr);
}

} // namespace

StillLayer::~StillLayer() {
    removeTexture();
}

MapDrawing StillLayer::plan(const CasterFingerprint& casters, const CasterVolume& volume,
                            const MapContent& wanted) {
    mRested = 0;
    if (mIsFilled && !serves(casters, wanted)) forget();
    if (mIsFilled) {
        const std::size_t drawnAnyway = static_cast<std::size_t>(
            std::ranges::count_if(casters.each(), [&](const CasterFingerprint::Caster* caster) {
                return caster->since > mUnchangedSince && casters.isStill(*caster, ReadingsStill);
            }));
        mDrawnAnyway += drawnAnyway;
        // Drawing all of them anew, to hold more, pays when as many were drawn that stand still.
        if (mDrawnAnyway < mHeld.size() + drawnAnyway) {
            ++mUses;
            return MapDrawing::Moving;
        }
    } else {
        if (++mDrawn <= mWait) return MapDrawing::Whole;
        if (!pays(casters, volume, wanted)) {
            mDrawn = 0;
            return MapDrawing::Whole;
        }
    }
    hold(casters, wanted);
    return MapDrawing::Fill;
}

bool StillLayer::serves(const CasterFingerprint& casters, const MapContent& wanted) {
    if (mSource != &casters || mGeneration != contentGeneration() || mMatrices != wanted.matrices ||
        mSettings != wanted.settings || !isLike(*wanted.texture.lock()))
        return false;
    // Only casters that it holds can be unchanged for as long: it serves if none is missing.
    const auto unchanged = [&](const CasterFingerprint::Caster* caster) {
        return caster->since <= mUnchangedSince;
    };
    return static_cast<std::size_t>(std::ranges::count_if(casters.each(), unchanged)) ==
           mHeld.size();
}

bool StillLayer::pays(const CasterFingerprint& casters, const CasterVolume& volume,
                      const MapContent& wanted) const {
    std::size_t still = 0;
    std::size_t all = 0;
    for (const CasterFingerprint::Caster* caster : casters.each()) {
        if (!volume.isVisible(caster->object->getWorldBoundingBox())) continue;
        ++all;
        still += casters.isStill(*caster, ReadingsStill) ? 1U : 0U;
    }
    const Ogre::TexturePtr map = wanted.texture.lock();
    const std::size_t texels = std::size_t{map->getWidth()} * map->getHeight();
    return still * TexelsOfACaster >= texels && still * LeastStillShare >= all;
}

void StillLayer::hold(const CasterFingerprint& casters, const MapContent& wanted) {
    mIsFilled = false;
    mSource = &casters;
    mUnchangedSince = casters.reading() - ReadingsStill;
    mHeld.clear();
    for (const CasterFingerprint::Caster* caster : casters.each())
        if (casters.isStill(*caster, ReadingsStill)) mHeld.insert(caster->object);
    mMatrices = wanted.matrices;
    mSettings = wanted.settings;
    mGeneration = contentGeneration();
}

void StillLayer::forget() {
    mIsFilled = false;
    mDrawn = 0;
    mWait = mUses >= LeastWait ? 0 : std::clamp(2 * mWait, LeastWait, LongestWait);
    mUses = 0;
}

void StillLayer::rest() {
    if (++mRested < PlansUnused) return;
    removeTexture();
    mHeld.clear();
    mIsFilled = false;
    mDrawn = 0;
    mWait = LeastWait;
}

bool StillLayer::isFilledFor(const Ogre::Camera& shadowCamera) const {
    return mIsFilled && mCamera == placeOf(shadowCamera);
}

bool StillLayer::fill(const Ogre::Texture& map, const Ogre::Camera& shadowCamera,
                      const Ogre::VisibleObjectsBoundsInfo& seen) {
    if (!makeTexture(map)) return false;
    copyTexels(map, *mTexture);
    mCamera = placeOf(shadowCamera);
    mSeen = seen;
    mIsFilled = true;
    mUses = 0;
    mDrawnAnyway = 0;
    return true;
}

void StillLayer::copyTo(const Ogre::Texture& map) const {
    copyTexels(*mTexture, map);
}

void StillLayer::refuse() {
    mIsFilled = false;
    mDrawn = 0;
    mUses = 0;
    mWait = LongestWait;
}

void StillLayer::removeTexture() {
    if (mTexture && Ogre::TextureManager::getSingletonPtr() != nullptr)
        Ogre::TextureManager::getSingleton().remove(mTexture);
    mTexture.reset();
}

bool StillLayer::isLike(const Ogre::Texture& map) const {
    return mTexture->getWidth() == map.getWidth() && mTexture->getHeight() == map.getHeight() &&
           mTexture->getFormat() == map.getFormat();
}

bool StillLayer::makeTexture(const Ogre::Texture& map) {
    if (mTexture && !isLike(map)) removeTexture();
    if (!mTexture) {
        static unsigned long made = 0;
        try {
            mTexture = Ogre::TextureManager::getSingleton().createManual(
                "Lixel/StillLayer/" + std::to_string(made++), Ogre::RGN_INTERNAL, Ogre::TEX_TYPE_2D,
                map.getWidth(), map.getHeight(), 0, map.getFormat(), Ogre::TU_STATIC_WRITE_ONLY);
        } catch (const Ogre::Exception& exception) {
            // The map can be drawn without.
            logWarning("shadow map '" + map.getName() +
                       "' is always drawn whole: " + exception.getDescription());
            return false;
        }
    }
    // A render system may have put another format in its place.
    return isLike(map);
}

bool drawsLayers(const Ogre::SceneManager& manager) {
    return findStore(manager) != nullptr;
}

bool canDrawInLayers(Ogre::SceneManager& manager, const ShadowTarget& target) {
    return drawsLayers(manager) && storesDepthAsColour(manager, *target.target) &&
           target.texture->getTextureType() == Ogre::TEX_TYPE_2D &&
           // Copies of what is resolved are none of its samples.
           target.target->getFSAA() == 0;
}

} // namespace Lixel
