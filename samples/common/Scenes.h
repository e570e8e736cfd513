#pragma once

#include <Ogre.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// A light of a sample. Lengths in the scene's units.
struct SampleLight {
    enum class Kind { Directional, Spot, Point };
    std::string name; ///< for menus and reports: lower case, dashes
    Kind kind = Kind::Directional;
    /// Directional and spot: unit vector along which light travels.
    Ogre::Vector3 direction = Ogre::Vector3::NEGATIVE_UNIT_Y;
    Ogre::Vector3 position = Ogre::Vector3::ZERO; ///< spot and point
    float innerDegrees = 0.0F;                    ///< spot: full angle of the inner cone
    float outerDegrees = 0.0F;                    ///< spot: full angle of the outer cone
    float range = 0.0F;                           ///< spot and point: how far light reaches
    Ogre::ColourValue colour = Ogre::ColourValue(1.0F, 0.97F, 0.9F);
    /// In scenes of OGRE's shader system: the `shadow_camera_setup` of a script that goes with it.
    std::string shadowPreset{};
    /// Directional: `direction` is meant for a view along -z, and turns about y with each view.
    bool turnsWithView = false;
};

/// What is not lit by a scene's light.
struct SampleSky {
    Ogre::ColourValue ambient = Ogre::ColourValue(0.36F, 0.39F, 0.45F);
    Ogre::ColourValue background = Ogre::ColourValue(0.66F, 0.76F, 0.85F);
};

/// Where a sample is seen from. y is up.
struct SampleView {
    std::string name; ///< for menus and reports: lower case, dashes
    Ogre::Vector3 position = Ogre::Vector3::ZERO;
    Ogre::Vector3 target = Ogre::Vector3::NEGATIVE_UNIT_Z;
    float nearDistance = 1.0F;
    float farDistance = 1000.0F;
    float fovYDegrees = 50.0F;
    std::optional<SampleLight> light; ///< a light that belongs to this view, instead of lights[0]
    std::optional<SampleSky> sky{};   ///< a sky that belongs to this view, instead of the scene's
};

/// A scene with the views and lights under which it is shown and measured.
struct SampleScene {
    std::string name;  ///< for the command line: lower case, dashes
    std::string title; ///< one line for people
    /** Adds everything but camera and lights below the root scene node.
        @exception Ogre::ItemIdentityException without the materials that it wears
    */
    std::function<void(Ogre::SceneManager&)> build;
    std::vector<SampleView> views;   ///< the default one first; at least two
    std::vector<SampleLight> lights; ///< the default one first
    float shadowDistance = 0.0F;     ///< view-space depth that shadows reach, scene units; 0: any
    SampleSky sky{};
    bool bySeed = false; ///< whether views and lights are where random numbers have put them
    /// Whether its materials have no programs, so that OGRE's shader system draws them, and are
    /// those of media/. Others wear Lixel/Surface.
    bool shaderSystem = false;
};

/// The scenes that are made by code, always the same; garden among them where programs are built
/// with OGRE's shader system.
const std::vector<SampleScene>& sampleScenes();

/// Those on which setups are compared: all that wear Lixel/Surface.
const std::vector<SampleScene>& measuredScenes();

/// The scene of that name; null when there is none.
const SampleScene* findSampleScene(const std::string& name);

/** Any model file as a scene, with views and lights from its bounding box.

    When it is built, OGRE's log gets a warning for each thing that could not be read.
    @exception Ogre::Exception as ModelFile
*/
SampleScene modelScene(const std::string& path);

/** A sun by where it stands, warmer the lower it is, and brighter, so that level ground shows.
    @param azimuthDegrees around y: 0 over +z, 90 over +x, 180 over -z, where most views look
    @param elevationDegrees above the horizon
*/
SampleLight sunlight(const std::string& name, float azimuthDegrees, float elevationDegrees);

/// How far a view is turned about y from one along -z.
Ogre::Radian headingOf(const SampleView& view);

/** One of a scene's lights as it stands for one of its views, by index into SampleScene::lights.

    A view's own light stands for the first. A light that turns with views is turned.
    @exception std::out_of_range without such a light
*/
SampleLight lightOf(const SampleScene& scene, const SampleView& view, std::size_t index);
/// The same by its name; null when there is none.
std::optional<SampleLight> findLight(const SampleScene& scene, const SampleView& view,
                                     const std::string& name);
/// The light under which a view is shown unless another is asked for: the first.
SampleLight defaultLight(const SampleScene& scene, const SampleView& view);

/// Puts a camera, which a scene node of its own carries, where the view is. Leaves its aspect
/// ratio.
void applyView(const SampleView& view, Ogre::Camera& camera);

/// Makes a light, which a scene node of its own carries, into the sample's light.
void applyLight(const SampleLight& light, Ogre::Light& ogreLight);

} // namespace Lixel::Samples
