#pragma once

#include <OgreLog.h>
#include <OgreMaterial.h>
#include <OgrePixelFormat.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

namespace Lixel::Tests {

/// One of the ways in which OGRE draws programs.
struct RenderPath {
    const char* name;
    const char* plugin;
    bool separateShaders;
};

inline std::ostream& operator<<(std::ostream& stream, const RenderPath& path) {
    return stream << path.name;
}

inline constexpr RenderPath GL3Plus = {"GL3Plus", "RenderSystem_GL3Plus", false};
inline constexpr RenderPath GL3PlusSeparate = {"GL3PlusSeparate", "RenderSystem_GL3Plus", true};
inline constexpr RenderPath LegacyGL = {"GL", "RenderSystem_GL", false};

struct Pixel {
    int red, green, blue;
    bool operator==(const Pixel&) const = default;
};

inline std::ostream& operator<<(std::ostream& stream, const Pixel& pixel) {
    return stream << pixel.red << ' ' << pixel.green << ' ' << pixel.blue;
}

/// OGRE without a display, with Plugin_LixelCg and nothing else of Lixel's, a folder for scripts
/// and programs, and one rectangle that fills the window.
class DrawingOgre : public Ogre::LogListener {
public:
    explicit DrawingOgre(const RenderPath& path);
    ~DrawingOgre() override;

    /// Puts a file into the folder, to be read by readScripts.
    void write(const std::string& file, const std::string& text) const;
    void readScripts() const;
    const std::filesystem::path& folder() const { return mFolder; }

    /// The rectangle in that material, in the middle of the window. It has the corners ±1 and 0.5
    /// as z, the normal (0, 0, 1), the colour (0.2, 0.4, 0.6), and 0 to 1 as texture coordinates.
    Pixel draw(const std::string& material);
    const std::vector<std::uint8_t>& picture(const std::string& material);

    /// What was logged since it was last asked and holds that text, a line each.
    std::string logged(const std::string& text) const;
    /// What a test that fails should show: all that was logged of programs.
    std::string problems() const { return logged("Program ") + logged("rror:"); }
    void clearLog();

    /// A pixel of the last picture; row 0 is the upper one.
    Pixel pixel(unsigned column, unsigned row) const;

    /// One more rectangle, which is drawn too, below a node of its own.
    Ogre::SceneNode& addRectangle(const std::string& material);

    Ogre::Root& root() { return *mRoot; }
    Ogre::SceneManager& scene() { return *mScene; }

    static constexpr unsigned Side = 16; ///< of the window, in pixels

private:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool maskDebug,
                       const Ogre::String& logName, bool& skip) override;
    void makeScene();
    Ogre::ManualObject* makeRectangle(const std::string& material);

    std::filesystem::path mFolder;
    /// OGRE's worker threads log too.
    mutable std::mutex mLogging;
    std::vector<std::string> mLines;
    std::unique_ptr<Ogre::LogManager> mLogs;
    std::unique_ptr<Ogre::Root> mRoot;
    Ogre::RenderWindow* mWindow = nullptr;
    Ogre::SceneManager* mScene = nullptr;
    Ogre::ManualObject* mRectangle = nullptr;
    std::vector<std::uint8_t> mPicture;
};

} // namespace Lixel::Tests
