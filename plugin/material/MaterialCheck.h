#pragma once

#include "setup/ShadowMapObserver.h"

#include <OgreCommon.h>
#include <OgreRenderObjectListener.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace Ogre {
class Light;
class Material;
class Pass;
class SceneManager;
class Texture;
} // namespace Ogre

namespace Lixel {

/** Looks at the materials that a scene manager draws with, and says in the log what cannot work.

    Each line names the material and what to do, and is logged once. Reported are:
    - surfaces that OGRE will refuse to draw, or that read no shadow map, or fewer than a light has;
    - receivers of another shadow technique;
    - receivers that find their map by depths which a light's maps do not have;
    - programs whose parameters are bound wrongly, or that look for maps in the wrong units;
    - casters that write another depth than Lixel's receivers compare with;
    - casters and receivers that do not bend what the surface's own program bends, and instances that
      no program places;
    - holes that casters take for others, or that another pass of the technique fills;
    - shadow textures that cannot hold Lixel's depth, or that are too few;
    - lights without a setup.

    Looking costs time, so it is done in the first views of a scene manager, and after its shadow
    technique, materials or numbers of maps changed; and then every Interval views. Only shadow
    materials that cannot be drawn are looked for in every view.
*/
class MaterialCheck : public Ogre::RenderObjectListener {
public:
    /// Views from one look to the next: about a second. A prime number, so that each of several
    /// views that are drawn in turn is looked at.
    static constexpr unsigned Interval = 61;
    /// Looks in a row, to begin with: applications often complete a scene after its first frame.
    static constexpr unsigned FirstLooks = 3;

    explicit MaterialCheck(Ogre::SceneManager& manager) : mManager(manager) {}
    ~MaterialCheck() override;

    /// A view begins, in which this scene manager has shadow maps.
    /// @param scheme of materials, that of the viewport
    void beginView(const std::string& scheme);
    /// It was drawn; the next may have no maps.
    void endView();
    /// Whether this view is looked at.
    bool looks() const { return mLooks; }
    /// What is queued is about to be drawn, by a viewer or into a map: takes those of its own shadow
    /// materials away that cannot be drawn.
    void dropUnusable();
    /// A map is about to be drawn into a shadow texture.
    void checkMap(const Ogre::Texture& texture, const ShadowMap& map);
    /// What is queued is about to be drawn.
    /// @param lightsWithMaps those that setups were asked for
    void checkQueue(const std::set<const Ogre::Light*>& lightsWithMaps);

    /// Collects passes as they are drawn: which one a caster or receiver gets, OGRE decides then.
    void notifyRenderSingleObject(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                  const Ogre::AutoParamDataSource* source,
                                  const Ogre::LightList* lights,
                                  bool suppressRenderStateChanges) override;

private:
    void listen(bool toObjects);
    void checkReceiver(const Ogre::Pass& pass);
    void checkReads(const Ogre::Pass& pass, const Ogre::LightList& lights);
    void checkSurface(const Ogre::Pass& pass, bool groupReceives);
    void checkPrograms(const Ogre::Pass& pass);
    void checkUnits(const Ogre::Pass& pass, Ogre::Renderable& renderable);
    void checkInstances(const Ogre::Pass& pass, Ogre::Renderable& renderable);
    void checkBending(const Ogre::Pass& pass, Ogre::Renderable& renderable, bool isCaster);
    void checkHoles(const Ogre::Pass& caster, Ogre::Renderable& renderable);
    void checkCasters();
    void checkLights(const std::set<const Ogre::Light*>& withMaps);
    void say(const std::string& message);

    Ogre::SceneManager& mManager;
    /// What decides which materials go together.
    struct Shadows {
        Ogre::ShadowTechnique technique = Ogre::SHADOWTYPE_NONE;
        const Ogre::Pass* caster = nullptr;
        const Ogre::Pass* receiver = nullptr;
        std::array<std::size_t, 3> mapsOfTypes{};
        bool operator==(const Shadows&) const = default;
    };
    Shadows mShadows; ///< when it looked last
    unsigned mViews = 0;
    bool mLooks = false;
    bool mListens = false;
    std::set<std::string> mSaid;
    bool mSaidTooFewTextures = false;
    /// This frame's caster passes, each with the name of a material whose shadow it draws.
    std::map<const Ogre::Pass*, std::string> mCasters;
    /// This frame's other passes, receivers among them.
    std::set<const Ogre::Pass*> mDrawn;
    /// Of those, with each light that they were drawn with: whose maps were counted.
    std::set<std::pair<const Ogre::Pass*, const Ogre::Light*>> mCounted;
    /// Of this frame's passes, with each material that they were drawn for: whose units were looked
    /// at.
    std::set<std::pair<const Ogre::Pass*, const Ogre::Material*>> mUnitsSeen;
    struct LightMaps {
        std::size_t all = 0;  ///< that it has textures for
        std::size_t used = 0; ///< up to the last one that shows anything
        bool apart = false;   ///< whether they are parts of another kind than slices by depth
    };
    std::map<const Ogre::Light*, LightMaps> mMaps; ///< this frame's
    /// Formats of this frame's shadow textures that Lixel's casters cannot store their depth in.
    std::set<std::string> mWrongFormats;
    bool mDrawsLixelsCasters = false;
};

} // namespace Lixel
