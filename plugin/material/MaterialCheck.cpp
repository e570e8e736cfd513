#include "material/MaterialCheck.h"

#include "material/DrawnPass.h"
#include "material/MapReads.h"
#include "material/MissingMaterials.h"
#include "material/OwnShadowMaterials.h"
#include "material/ProgramCheck.h"
#include "material/QueuedPasses.h"
#include "material/UnitCheck.h"
#include "scene/CasterPass.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"

#include <OgreLight.h>
#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgrePixelFormat.h>
#include <OgreRenderable.h>
#include <OgreSceneManager.h>
#include <OgreTechnique.h>
#include <OgreTexture.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Lixel {
namespace {

const char* const Manual = " (materials/README.md)";

/// Which material reads as many maps, as the beginning of what to do. Empty where none does.
std::string materialReading(std::size_t maps) {
    const std::size_t parent = mapsOfParentFor(maps);
    if (parent < maps) return {};
    return "take Lixel/Surface/Integrated/Maps" + std::to_string(parent) +
           ", or a program that reads as many, or ";
}

/// Whether a pass of any of the material's techniques does: one for far away may lack the unit.
bool readsShadowMap(const Ogre::Material& material) {
    for (const Ogre::Technique* technique : material.getTechniques())
        for (const Ogre::Pass* pass : technique->getPasses())
            if (!shadowUnitsOf(*pass).empty()) return true;
    return false;
}

} // namespace

MaterialCheck::~MaterialCheck() {
    endView();
}

void MaterialCheck::listen(bool toObjects) {
    if (toObjects == mListens) return;
    mListens = toObjects;
    if (toObjects)
        mManager.addRenderObjectListener(this);
    else
        mManager.removeRenderObjectListener(this);
}

void MaterialCheck::endView() {
    mLooks = false;
    listen(false);
}

void MaterialCheck::beginView(const std::string& scheme) {
    const Shadows shadows{mManager.getShadowTechnique(),
                          shadowCasterPassOf(mManager),
                          shadowReceiverPassOf(mManager),
                          {mManager.getShadowTextureCountPerLightType(Ogre::Light::LT_POINT),
                           mManager.getShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL),
                           mManager.getShadowTextureCountPerLightType(Ogre::Light::LT_SPOTLIGHT)}};
    if (shadows != mShadows) mViews = 0;
    mShadows = shadows;
    mLooks = mViews < FirstLooks || mViews % Interval == 0;
    ++mViews;
    mCasters.clear();
    mDrawn.clear();
    mCounted.clear();
    mUnitsSeen.clear();
    mMaps.clear();
    mWrongFormats.clear();
    listen(mLooks);
    if (!mLooks) return;
    for (const std::string& missing : findMissingMaterials(mManager, scheme))
        say(missing + Manual);
}

void MaterialCheck::dropUnusable() {
    for (const std::string& dropped : dropUnusableShadowMaterials(mManager))
        say(dropped);
}

void MaterialCheck::checkMap(const Ogre::Texture& texture, const ShadowMap& map) {
    if (!mLooks) return;
    LightMaps& maps = mMaps[&map.light];
    maps.all = std::max(maps.all, map.iteration + 1);
    if (map.fit.hasMap()) maps.used = std::max(maps.used, map.iteration + 1);
    // The first slice ends somewhere.
    if (map.iteration == 0) maps.apart = map.part.boundCount > 0 && !std::isfinite(map.part.vsEnd);
    // Not at once: much of a scene may come after its first frame.
    if (map.fit.reason == FitReason::NoReceivers && mViews > FirstLooks &&
        !mManager.getShadowTextureSelfShadow() && !mManager.isShadowTechniqueIntegrated())
        say("nothing in view receives shadows in scene manager " + quoted(mManager.getName()) +
            ": what casts shadows receives none until SceneManager::setShadowTextureSelfShadow("
            "true)");
    const Ogre::PixelFormat format = texture.getFormat();
    constexpr int EnoughBits = 24; // as many as a float's depth in [0, 1] has
    int bits[4];
    Ogre::PixelUtil::getBitDepths(format, bits);
    if (Ogre::PixelUtil::isDepth(format) || bits[0] < EnoughBits)
        mWrongFormats.insert(Ogre::PixelUtil::getFormatName(format));
}

void MaterialCheck::checkQueue(const std::set<const Ogre::Light*>& lightsWithMaps) {
    if (!mLooks) return;
    checkCasters();
    checkLights(lightsWithMaps);
    forQueuedPasses(mManager, [this](const Ogre::Pass& pass, bool groupReceives) {
        checkSurface(pass, groupReceives);
    });
}

void MaterialCheck::checkLights(const std::set<const Ogre::Light*>& withMaps) {
    const std::size_t textures = mManager.getShadowTextureConfigList().size();
    std::size_t needed = 0;
    for (const Ogre::Light* light : mManager._getLightsAffectingFrustum()) {
        if (!light->getCastShadows()) continue;
        const bool hasTexture = needed < textures;
        needed += mManager.getShadowTextureCountPerLightType(light->getType());
        if (hasTexture && mDrawsLixelsCasters && withMaps.count(light) == 0)
            say("light " + quoted(light->getName()) +
                " has no setup of Lixel's, so Lixel's materials show no shadows from it: give it "
                "one, "
                "or put its own inside an ObservedShadowCameraSetup");
    }
    // Numbers of lights come and go; once is enough.
    if (needed > textures && !std::exchange(mSaidTooFewTextures, true))
        say("scene manager " + quoted(mManager.getName()) + " has " + std::to_string(textures) +
            " shadow textures, and the lights that cast shadows here take " +
            std::to_string(needed) +
            ": the last ones get fewer than they need, or none "
            "(SceneManager::setShadowTextureCount)");
}

void MaterialCheck::checkSurface(const Ogre::Pass& pass, bool groupReceives) {
    const Ogre::Technique& technique = *pass.getParent();
    if (lacksPrograms(pass)) {
        say(whatLacksPrograms(pass) + Manual);
        return;
    }
    if (!mManager.isShadowTechniqueIntegrated() || !groupReceives || !pass.getLightingEnabled() ||
        !technique.getParent()->getReceiveShadows() || readsShadowMap(*technique.getParent()) ||
        isStandIn(pass) || pass.getUserObjectBindings().getUserAny(ShaderSystemMark).has_value())
        return;
    if (isOfTerrain(pass))
        return say("OGRE's terrain, material " + quoted(materialOf(pass)) +
                   ", makes programs of its own, which read no map as Lixel's casters write it: "
                   "keep OGRE's casters and receivers in its scene manager, and give the light "
                   "cascades with their split points (README.md, \"If your scene has texture "
                   "shadows already\")");
    say("material " + quoted(materialOf(pass)) +
        " reads no shadow map, so nothing casts shadows on it: under an integrated shadow "
        "technique use Lixel/Surface/Integrated, or give it texture units of content_type "
        "shadow and LixelShadow.glsl; where OGRE's shader system makes its programs, "
        "Lixel::ShaderSystem::enable; or say receive_shadows off" +
        Manual);
}

void MaterialCheck::checkPrograms(const Ogre::Pass& pass) {
    const auto check = [&](const std::string& program,
                           const Ogre::GpuProgramParametersSharedPtr& parameters) {
        const std::vector<std::string> wrongs = findWrongBindings(*parameters);
        if (!wrongs.empty() && isOwnProgram(program))
            return say("Lixel's own programs lack what the plugin makes: its scripts were read "
                       "before it was loaded (Root::loadPlugin comes before "
                       "initialiseAllResourceGroups), or are not this version's");
        for (const std::string& wrong : wrongs)
            say("program " + quoted(program) + " of material " + quoted(materialOf(pass)) + ": " +
                wrong + Manual);
    };
    if (pass.hasVertexProgram())
        check(pass.getVertexProgramName(), pass.getVertexProgramParameters());
    if (pass.hasFragmentProgram())
        check(pass.getFragmentProgramName(), pass.getFragmentProgramParameters());
}

void MaterialCheck::checkUnits(const Ogre::Pass& pass, Ogre::Renderable& renderable) {
    // OGRE lends a surface's units to the scene manager's receiver.
    const Ogre::Material* const worn = renderable.getMaterial().get();
    if (worn == nullptr || !mUnitsSeen.emplace(&pass, worn).second) return;
    for (const std::string& wrong : findWrongUnits(pass, mManager.isShadowTechniqueIntegrated()))
        say("material " + quoted(worn->getName()) + ": " + wrong + Manual);
}

void MaterialCheck::checkInstances(const Ogre::Pass& pass, Ogre::Renderable& renderable) {
    if (!isLeftUnplaced(pass, renderable)) return;
    say("instances that wear material " + quoted(wornBy(renderable)) +
        " are drawn by the vertex program of " + quoted(materialOf(pass)) +
        ", which does not place them: all are at the world's origin. Give them programs of their "
        "own, in the surface, its receiver and its caster, or draw entities" +
        Manual);
}

void MaterialCheck::checkBending(const Ogre::Pass& pass, Ogre::Renderable& renderable,
                                 bool isCaster) {
    if (bends(pass) || !isBentByProgram(renderable)) return;
    const std::string kind = isCaster ? "caster" : "receiver";
    say("what wears material " + quoted(wornBy(renderable)) +
        " is bent by its vertex program, and shadow " + kind + " material " +
        quoted(materialOf(pass)) + " does not bend it: " +
        (isCaster ? "its shadow is that of the mesh at rest"
                  : "its light falls on the mesh at rest, beside it") +
        "; give its technique a shadow_" + kind + "_material of its own, or have OGRE bend it " +
        "(a material whose vertex program includes no animation)" + Manual);
}

void MaterialCheck::checkHoles(const Ogre::Pass& caster, Ogre::Renderable& renderable) {
    const Ogre::CompareFunction kept = caster.getAlphaRejectFunction();
    if (kept == Ogre::CMPF_ALWAYS_PASS || kept == Ogre::CMPF_GREATER_EQUAL ||
        kept == Ogre::CMPF_GREATER || !writesCasterDepth(caster))
        return;
    say("material " + quoted(wornBy(renderable)) +
        " has an alpha_rejection that Lixel's casters and surfaces take for greater_equal: write "
        "greater_equal, and turn the texture's alpha around where it was meant to be less" +
        Manual);
}

void MaterialCheck::checkReceiver(const Ogre::Pass& pass) {
    // By its programs: OGRE sets the blending to that of the technique.
    const bool isAdditive = mapsRead(pass, 0) > 0;
    const bool isModulative = readsModulativeMap(pass);
    if (isAdditive && isModulative)
        say("shadow receiver material " + quoted(materialOf(pass)) +
            " has one program for additive shadows and one for modulative ones: inherit "
            "Lixel/Receiver for the former, Lixel/Receiver/Modulative for the latter" +
            Manual);
    if (isAdditive == isModulative || isAdditive == mManager.isShadowTechniqueAdditive()) return;
    say("shadow receiver material " + quoted(materialOf(pass)) + " is for " +
        (isAdditive ? "additive shadows, and this scene manager's are modulative: take "
                      "'Lixel/Receiver/Modulative/Bilinear', or SHADOWTYPE_TEXTURE_ADDITIVE"
                    : "modulative shadows, and this scene manager's are additive: take "
                      "'Lixel/Receiver/Bilinear', or SHADOWTYPE_TEXTURE_MODULATIVE") +
        Manual);
}

void MaterialCheck::checkReads(const Ogre::Pass& pass, const Ogre::LightList& lights) {
    if (!pass.getParent()->getParent()->getReceiveShadows()) return;
    for (std::size_t place = 0; place < lights.size(); ++place) {
        const auto found = mMaps.find(lights[place]);
        if (found == mMaps.end() || !mCounted.emplace(&pass, found->first).second) continue;
        const LightMaps& maps = found->second;
        if (maps.apart && readsSplitDepths(pass, place))
            say("material " + quoted(materialOf(pass)) +
                " finds its map by `lixelSplitDepths`, and "
                "the maps of light " +
                quoted(found->first->getName()) + " are not slices by depth: " +
                (found->first->getType() == Ogre::Light::LT_DIRECTIONAL
                     ? "set the option strip_light of its cascades off, or "
                     : "") +
                "find the map as LixelShadow.glsl does" + Manual);
        const std::size_t read = mapsRead(pass, place);
        if (read == 0 || read >= maps.used || shadowUnitsOf(pass).empty()) continue;
        say("material " + quoted(materialOf(pass)) + " reads " + std::to_string(read) +
            (read == 1 ? " shadow map" : " shadow maps") + " of light " +
            quoted(found->first->getName()) + ", which has " + std::to_string(maps.all) +
            ": shadows in the others are missing; " + materialReading(maps.all) +
            "give the light fewer textures (SceneManager::setShadowTextureCountPerLightType)" +
            Manual);
    }
}

void MaterialCheck::checkCasters() {
    mDrawsLixelsCasters = std::any_of(mCasters.begin(), mCasters.end(), [](const auto& caster) {
        return writesCasterDepth(*caster.first);
    });
    // Other casters go with other receivers: nothing of Lixel's to say.
    if (!mDrawsLixelsCasters && !drawsLixelsReceivers(mManager)) return;
    for (const std::string& format : mWrongFormats)
        say("shadow textures of format " + format +
            " do not hold what Lixel/Caster stores: use SceneManager::setShadowTextureSettings "
            "with PF_FLOAT32_R; or casters and receivers of your own");
    for (const auto& [pass, material] : mCasters) {
        checkPrograms(*pass);
        if (!writesCasterDepth(*pass))
            say("what wears material " + quoted(material) + " casts by the caster material " +
                quoted(materialOf(*pass)) +
                ", which takes the place of Lixel/Caster and does not write the depth that Lixel's "
                "receivers compare with: write it by LixelCaster.glsl" +
                Manual);
    }
}

void MaterialCheck::notifyRenderSingleObject(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                             const Ogre::AutoParamDataSource*,
                                             const Ogre::LightList* lights, bool) {
    const auto stage = mManager._getCurrentRenderStage();
    checkInstances(*pass, *renderable);
    if (stage == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) {
        if (mCasters.count(pass) == 0) mCasters[pass] = wornBy(*renderable);
        checkBending(*pass, *renderable, true);
        checkHoles(*pass, *renderable);
        return;
    }
    if (mDrawn.insert(pass).second) {
        checkPrograms(*pass);
        if (stage == Ogre::SceneManager::IRS_RENDER_RECEIVER_PASS) checkReceiver(*pass);
    }
    checkUnits(*pass, *renderable);
    if (stage == Ogre::SceneManager::IRS_RENDER_RECEIVER_PASS)
        checkBending(*pass, *renderable, false);
    if (lights != nullptr && mManager.isShadowTechniqueIntegrated()) checkReads(*pass, *lights);
}

void MaterialCheck::say(const std::string& message) {
    if (mSaid.insert(message).second) logWarning(message);
}

} // namespace Lixel
