#pragma once

#include "fit/problem/Option.h"
#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowPart.h"
#include "fit/problem/ShadowProblem.h"

// OgreShadowCameraSetup.h of 1.12 needs it and does not include it.
#include <OgreSharedPtr.h>

#include <OgreShadowCameraSetup.h>
#include <OgreStringInterface.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Lixel {
/// @addtogroup LixelSetups
/// @{

struct DivisionMemory;
struct FitState;
struct LastingMap;
struct LightMemory;
class CasterFingerprint;
class Fingerprint;
class LightNews;
struct LightPartition;
struct MapDecision;
struct PlannedMap;
class SetupMemory;
struct ShadowTarget;
struct ShownMap;
class StillLayer;
class Survey;

/// Options of all of Lixel's setups.
struct CommonOptions {
    /// How far receivers filter, in texels: the map keeps this and one texel more free around what
    /// matters. 0 for one nearest tap, 1 for bilinear comparison.
    double filterRadius = 1.0;
    /** How near a caster must be to a receiver, along the light's axis, to be taken for the
        receiver itself, in world units (Gusev 2007, §3.10). Receivers already correct for the slope
        of their own surface within a texel, so this is for surfaces that are not planar at the
        scale of a texel. */
    double depthBias = 0.0;
    /** Whether maps are fitted to convex hulls of meshes, where these fill their boxes badly, such
        as what is long and turned, and leave out what a large convex mesh shadows of itself, or a
        ground of hills (Relief.h) where no slope is before it: the side that faces away
        from the light, which materials must leave unlit by their normals, as they do unless light
        shines through. Hulls are made of a mesh's vertices as they were first read: turn it off
        where static buffers are rewritten in place. No hull is used for meshes whose vertices may
        move in another way: with vertex programs other than Lixel's and the shader generator's,
        bounds larger than those of the vertices, buffers that are not static, skeletons, vertex
        animations or manual levels of detail. A large mesh has no hull for some frames, until it is
        read.
        @see prepareMesh */
    bool meshHulls = true;
    /** Whether a map is kept where it shows just what it would show if it were drawn again: same
        light, same region, and every caster as it was. Casters that may look different each time,
        such as skeletons, particles and what has holes, have it drawn.
        @see redrawShadowMaps */
    bool reuseMaps = true;
    /** Whether what stands still of a map's casters is kept in a texture of its own, of the map's
        size and format, where some of them move and the map itself stands still: then only what
        moves is drawn, over a copy of that. Each texel is that of a map drawn at once. Under
        LixelSceneManager, for maps that hold Lixel's depths as colours, without multisampling, and
        with reuseMaps alone. Drawn at once is what has no share in it: where too few casters stand
        still for their number and the map's size, where a caster blends with others, and where an
        application listens to render queues or single draws, or draws queues in ways of its own. */
    bool movingApart = true;
    /** For how long a map may be kept although the viewer moves, as the share by which its texels
        may be coarser than those of a map fitted in each frame; 0: none is kept.

        Half of it is a margin around what is seen, so that a map lasts while the viewer turns and
        goes on; the map is fitted anew when the margin is used up, or its texels are too coarse.
        Shadows' edges do not crawl meanwhile. */
    double lastingMaps = 0.0;
    /** Whether setups that judge maps by samples (XPSM, Optimal, cascades) judge by what the
        viewer's frame before showed: the depths of a few of its pixels, read back without waiting
        for the GPU, instead of by view rays against boxes and meshes. Where he sees what was hidden
        then, rays are used nevertheless. Needs OpenGL and a viewport with a depth buffer;
        setVisiblePoints goes first. @see feedbackStatistics */
    bool feedback = false;
    /** In how many parts, at most, a large mesh is known that reaches out of the view, such as a
        terrain with all that grows on it in one mesh: maps are fitted to the parts in view, and
        view rays meet what is there instead of the mesh's box. 0: each mesh is known as a whole;
        1024 is a good number, and fewer than 256 are taken for 256.

        For meshes that have a hull (meshHulls, without which there are no parts), are not convex,
        and have no levels of detail. Parts are found once for each viewer, for all lights and maps:
        other lights' setups may get them too, or not, as lights come and go that ask for them; so
        set the same number in all setups of a scene. Where buffers are rewritten in place none may
        ask for them. Reading them takes a mesh some frames, and keeps 80 bytes a part.
        @see prepareMesh */
    int meshParts = 0;

    LIXEL_API static std::span<const Option> declared();
};

/** Base of all setups that fit a shadow map: survey, fit, shadow camera, caster volume, observers.

    Enable one with Light::setCustomShadowCameraSetup or SceneManager::setShadowCameraSetup. One
    instance serves any number of lights, cameras and scene managers: what it remembers from frame
    to frame is kept per light, viewer and map.

    The far end of shadows is the light's (or scene manager's) shadow far distance, where one is
    set, else the viewer's far plane. The near end of a local light is its shadow near clip
    distance, else the viewer's.

    A light has as many maps as SceneManager::setShadowTextureCountPerLightType says for its type,
    as far as there are textures left, under the integrated shadow techniques; elsewhere OGRE draws
    one map a light, and the log says so where there are more. A point light, and a spot wider than
    179°, takes six, one for each face of a cube around it. With fewer it gets the narrowest spot
    around what it can shadow. Where that would be wider than 160°, four and five maps are those
    faces that have something to show, as many as there are maps; with fewer, one map is a cone of
    160° around what is seen. The rest is lit, and the log says so.

    Maps of one light are asked for in order, from the first one on, as OGRE does.

    Where there is no map to draw (a light that shadows nothing in view, or bad input) no caster is
    drawn and everything is lit. Bad input is logged: one line for each light and reason, whatever
    map or viewer. The same reason is logged again only after the light had nothing wrong for 600
    frames, so input that is bad in every other frame does not flood the log.

    Options can be set and read as text too, those of CommonOptions among them, here or by
    Ogre::StringInterface. OGRE's dictionary goes with Root; what is declared here works without.

    A setup may outlive the lights, cameras and scene managers that it was used with, and Root; a
    new light or camera is another one, even at the address and by the name of an old one.
*/
class LIXEL_API FittedShadowCameraSetup : public Ogre::ShadowCameraSetup,
                                          public Ogre::StringInterface {
public:
    ~FittedShadowCameraSetup() override;
    FittedShadowCameraSetup(const FittedShadowCameraSetup&) = delete;
    FittedShadowCameraSetup& operator=(const FittedShadowCameraSetup&) = delete;

    /// Sets an option from text.
    /// @return true
    /// @throws Ogre::InvalidParametersException for an unknown option or an invalid value; the
    /// message lists the valid ones. (Ogre::StringInterface::setParameter returns false for an
    /// unknown option.)
    bool setParameter(const Ogre::String& keyword, const Ogre::String& value);
    /// An option's value, as setParameter reads it; empty where there is no such option.
    Ogre::String getParameter(const Ogre::String& keyword) const;
    /// All options, by name and type. (OGRE 1.12 keeps no descriptions.)
    const Ogre::ParameterList& getParameters() const;

    /// @see CommonOptions::filterRadius
    /// @throws Ogre::InvalidParametersException unless 0 <= texels <= 64.
    void setFilterRadius(Ogre::Real texels);
    Ogre::Real getFilterRadius() const { return static_cast<Ogre::Real>(mCommon.filterRadius); }

    /// @see CommonOptions::depthBias
    /// @throws Ogre::InvalidParametersException unless finite and >= 0.
    void setDepthBias(Ogre::Real worldUnits);
    Ogre::Real getDepthBias() const { return static_cast<Ogre::Real>(mCommon.depthBias); }

    /// @see CommonOptions::meshHulls
    void setMeshHulls(bool use) { mCommon.meshHulls = use; }
    bool getMeshHulls() const { return mCommon.meshHulls; }

    /// @see CommonOptions::reuseMaps
    void setReuseMaps(bool reuse) { mCommon.reuseMaps = reuse; }
    bool getReuseMaps() const { return mCommon.reuseMaps; }

    /// @see CommonOptions::movingApart
    void setMovingApart(bool apart) { mCommon.movingApart = apart; }
    bool getMovingApart() const { return mCommon.movingApart; }

    /// @see CommonOptions::lastingMaps
    /// @throws Ogre::InvalidParametersException unless 0 <= share <= 1.
    void setLastingMaps(Ogre::Real share);
    Ogre::Real getLastingMaps() const { return static_cast<Ogre::Real>(mCommon.lastingMaps); }

    /// @see CommonOptions::feedback
    void setFeedback(bool use) { mCommon.feedback = use; }
    bool getFeedback() const { return mCommon.feedback; }

    /// @see CommonOptions::meshParts
    /// @throws Ogre::InvalidParametersException unless 0 <= parts <= 65536.
    void setMeshParts(int parts);
    int getMeshParts() const { return mCommon.meshParts; }

    /** What the viewer sees of the receivers, where the application knows it better than a few view
        rays against boxes and meshes do: points spread evenly over the picture, in world
        coordinates, such as a depth buffer read back, with the normals of the sides that are seen.
        Setups that judge maps by samples (XPSM, Optimal, cascades) take these, for every viewer,
        until others are set; none, the default, for their own. Of more than 4096, as many are kept.
        @throws Ogre::InvalidParametersException unless all are finite, and normals not zero. */
    void setVisiblePoints(const std::vector<VisiblePoint>& wsPoints);
    /// The same in OGRE's vectors, a normal for each position.
    /// @throws Ogre::InvalidParametersException as above, and unless there are as many of both.
    void setVisiblePoints(const std::vector<Ogre::Vector3>& wsPositions,
                          const std::vector<Ogre::Vector3>& wsNormals);
    const std::vector<VisiblePoint>& getVisiblePoints() const { return mWsVisiblePoints; }

    void getShadowCamera(const Ogre::SceneManager* sceneManager, const Ogre::Camera* viewer,
                         const Ogre::Viewport* viewport, const Ogre::Light* light,
                         Ogre::Camera* shadowCamera, std::size_t iteration) const final;

protected:
    /// Without options of its own.
    FittedShadowCameraSetup();
    /// @param name of the setup in lists and scripts; unique among setups
    /// @param declared options of this setup, members of the structure that `options` points to
    /// @param options that structure; it and `declared` must outlive the setup
    FittedShadowCameraSetup(std::string_view name, std::span<const Option> declared, void* options);

    /// @throws Ogre::InvalidParametersException if an option's value is not valid.
    static void checkOptions(std::span<const Option> declared, const void* options);

    /// The technique: one map of the problem. @see fit/problem/ShadowFit.h
    virtual ShadowFit fit(const ShadowProblem& problem, FitState& state) const noexcept = 0;

    /// Divides the light into parts, one map each. Where there are more parts than maps, parts with
    /// nothing to draw get none.
    /// @param maps how many maps the light has, at least 1
    /// @return an empty partition where that many maps are too few
    virtual LightPartition divide(const ShadowProblem& problem, std::size_t maps,
                                  DivisionMemory& memory) const noexcept;

    /// What divide() is given, for one light and viewer.
    virtual std::unique_ptr<DivisionMemory> makeDivisionMemory() const;

    /// How many of so many available maps the setup fills at most, for a directional light. (How
    /// many a lamp needs depends on what stands around it.)
    virtual std::size_t mapsOfSun(std::size_t) const noexcept { return 1; }

    /** Whether fit() and divide() do the same again for the same problem and memory, as long as no
        option is set; it has maps that have come to rest kept where an application announces
        changes (LixelSceneManager::setChangesAnnounced). False here, since fit() may ask whatever
        it likes; true for Lixel's techniques: say false where yours is derived from one of them and
        asks more.
    */
    virtual bool dependsOnlyOnOptions() const noexcept { return false; }
    /// Another setup that fit() asks, whose options count too; null for none.
    virtual const FittedShadowCameraSetup* technique() const noexcept { return nullptr; }

    /// Another setup's technique, for setups that are made of others.
    static ShadowFit fitAs(const FittedShadowCameraSetup& technique, const ShadowProblem& problem,
                           FitState& state) noexcept {
        return technique.fit(problem, state);
    }

private:
    class OptionCommand;
    struct Request;
    struct MapCasters;
    struct FitTimes;

    /// Sets one of the common options, where its value is valid.
    void setCommon(double CommonOptions::*member, Ogre::Real value);
    /// Names its options to OGRE's StringInterface.
    void declareParameters();
    struct OwnedOption;
    /// An option by its keyword, of its own or of CommonOptions; null where there is none.
    OwnedOption find(std::string_view keyword) const;
    /// The problem of all maps of a light.
    ShadowProblem describe(const Request& request, const Survey& survey,
                           const LightMemory& memory) const;
    /// Finds what the light's maps share.
    void findCasters(const ShadowProblem& problem, const Survey& survey, LightMemory& memory) const;
    /// Fits the next part that one of the light's remaining maps is for.
    ShadowFit fitNext(const ShadowProblem& problem, const Ogre::Light& light, std::size_t mapsLeft,
                      LightMemory& memory, LightNews& news, const ShadowPart*& part) const;
    /// The map that lasts in place of a fresh fit: the one that is kept, or a new one.
    LastingMap& lastingMap(const Request& request, const ShadowProblem& problem,
                           const ShadowPart& part, const ShadowFit& fresh,
                           LightMemory& memory) const;
    /// Fits the light's next map, and has it drawn, kept or skipped.
    /// @param target null where the application asks for matrices alone
    void prepareMap(const Request& request, const ShadowTarget* target, LightMemory& memory,
                    LightNews& news) const;
    /// The same for a map that is known to be as it was fitted last.
    void repeatMap(const Request& request, const ShadowTarget& target, LightMemory& memory) const;
    void publish(const Request& request, const ShadowProblem& problem, const ShownMap& shown,
                 const MapDecision& decision, const FitTimes& times) const;
    /// What a light's maps depend on, except what scene nodes tell or the application announces.
    /// None where that cannot be said.
    std::optional<Fingerprint> situationOf(const Request& request,
                                           const std::vector<ShadowTarget>& targets,
                                           const LightMemory& memory) const;
    /// Whether a map that is fitted nevertheless would have been kept. @see StillLight
    bool isBelieved(const Request& request, const ShadowTarget& target,
                    const LightMemory& memory) const;
    /// Adds all options.
    void addSettings(Fingerprint& settings) const;
    /// Has a placed map drawn, kept, or skipped where there is none.
    /// @param believed whether the texture ought to show just this: proof mode compares
    /// @param shown the map placed; where the budget has an older one kept, that
    MapDecision draw(const Request& request, const ShadowProblem& problem,
                     const ShadowTarget& target, LightMemory& memory, const MapCasters& casters,
                     bool believed, ShownMap& shown) const;
    /// Plans a map that may be drawn in layers, and has to be drawn for its casters.
    /// @return its layer where it is drawn in layers
    StillLayer* planLayer(const Request& request, const ShadowTarget& target, PlannedMap& planned,
                          LightMemory& memory, const MapCasters& casters) const;
    /// Whether the budget has a map that ought to be drawn kept as it was drawn before.
    bool postpones(const Request& request, const ShadowProblem& problem, const ShadowTarget& target,
                   const PlannedMap& planned, LightMemory& memory, const ShownMap& wanted) const;

    std::unique_ptr<SetupMemory> mMemory;
    std::string mName;
    CommonOptions mCommon;
    std::span<const Option> mDeclared;
    void* mOptions;
    std::vector<VisiblePoint> mWsVisiblePoints;
    /// How often they were set.
    std::uint64_t mVisiblePointsSet = 0;
};

/// @}
} // namespace Lixel
