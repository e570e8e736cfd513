#pragma once

#include "common/Measurement.h"
#include "common/Setups.h"
#include "common/Stage.h"

#include <Ogre.h>
#include <gtest/gtest.h>

#include <limits>

namespace Lixel::Tests {

inline constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
inline constexpr float Infinity = std::numeric_limits<float>::infinity();

/// Collects lines of OGRE's log.
class LogCollector : public Ogre::LogListener {
public:
    /// @param only what the lines contain
    explicit LogCollector(std::string only = "Lixel:");
    ~LogCollector() override;
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool maskDebug,
                       const Ogre::String& logName, bool& skipThisMessage) override;
    /// How many lines contained the text.
    std::size_t count(const std::string& text) const;
    /// All of them.
    std::string all() const;

private:
    std::string mOnly;
    std::vector<std::string> mMessages;
};

/** A stage with a ground and one box on it: small enough to reason about.

    The ground is 200 x 200 at y = 0 and casts nothing; the box is a cube of side 2 on it, at the
    origin. The viewer stands at (0, 8, 16) and looks at the origin; the sun shines from the right,
    45 degrees high. Shadows reach 100 units.
*/
class BoxOnGround {
public:
    explicit BoxOnGround(const std::string& sceneManagerType = "",
                         const std::string& setup = "XPSM");

    Samples::Stage stage;
    Ogre::SceneNode* box = nullptr;
    Ogre::SceneNode* ground = nullptr;

    /// A cube of this side, whose material is Lixel/Surface, on a node of its own.
    Ogre::SceneNode* addCube(const Ogre::Vector3& position, const Ogre::Vector3& size);
    /// Error of the next frame in percent, against the oracle on the scene as it is now.
    Samples::ClassificationError nextFrameError();
    /// The pixel that shows a world point, counted row by row from the top.
    std::size_t pixelOf(const Ogre::Vector3& ws);
    /// The pixel's visibility, 0 to 255, in the next frame, at a world point.
    int visibilityAt(const Ogre::Vector3& world);

private:
    /// Column and row of a world point in the picture, maybe outside of it.
    Ogre::Vector2 pictureOf(const Ogre::Vector3& ws);

    int mCubes = 0;
};

/// Points of its ground.
inline const Ogre::Vector3 InShadow(-2, 0, 0);
inline const Ogre::Vector3 InTheSun(4, 0, 0);

/// Keeps what was published last.
class LastMap : public ShadowMapObserver {
public:
    LastMap() { addShadowMapObserver(*this); }
    void shadowMapFitted(const ShadowMap& map) override {
        fit = map.fit;
        ++count;
    }
    ShadowFit fit;
    int count = 0;
};

} // namespace Lixel::Tests
