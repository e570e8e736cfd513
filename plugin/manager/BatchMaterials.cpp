#include "manager/BatchMaterials.h"

#include "scene/CasterPass.h"
#include "scene/Log.h"
#include "scene/OgreVersions.h"

#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreRoot.h>
#include <OgreTechnique.h>

namespace Lixel {
namespace {

const char* const SingleProgram = "Lixel/CasterVP";
const char* const InstancesProgram = "Lixel/CasterVP/Instances";

Ogre::GpuProgramPtr instancesProgram() {
    return std::static_pointer_cast<Ogre::GpuProgram>(
        programManager().getResourceByName(InstancesProgram, Ogre::RGN_AUTODETECT));
}

/// Of a caster pass, what OGRE does not set for each surface that it draws.
Fingerprint stateOf(const Ogre::Pass& pass, const CasterPrograms& programs) {
    Fingerprint state;
    state.add(&pass);
    state.add(std::string_view(programs.fragment));
    state.add(programs.fragmentParameters.get());
    for (const Ogre::Real number :
         {pass.getDepthBiasConstant(), pass.getDepthBiasSlopeScale(), pass.getIterationDepthBias(),
          pass.getLineWidth(), pass.getFogStart(), pass.getFogEnd(), pass.getFogDensity()})
        state.add(static_cast<double>(number));
    for (const unsigned number :
         {unsigned{pass.getDepthCheckEnabled()}, unsigned{pass.getDepthWriteEnabled()},
          static_cast<unsigned>(pass.getDepthFunction()),
          static_cast<unsigned>(pass.getPolygonMode()), unsigned{pass.getFogOverride()},
          static_cast<unsigned>(pass.getFogMode()), static_cast<unsigned>(pass.getShadingMode())})
        state.add(std::uint64_t{number});
    const Ogre::ColourBlendState& blend = pass.getBlendState();
    state.add(std::uint64_t{blend.writeR} | std::uint64_t{blend.writeG} << 1U |
              std::uint64_t{blend.writeB} << 2U | std::uint64_t{blend.writeA} << 3U);
    return state;
}

/// Whether it is drawn once, whatever lights there are.
bool drawsOnce(const Ogre::Pass& pass) {
    return pass.getPassIterationCount() == 1 && !pass.getIteratePerLight() &&
           !pass.getRunOnlyForOneLightType() && !pass.getLightScissoringEnabled() &&
           !pass.getLightClipPlanesEnabled() && !pass.isAlphaToCoverageEnabled() &&
           pass.getPolygonMode() == Ogre::PM_SOLID && !pass.hasGeometryProgram() &&
           !pass.hasTessellationHullProgram() && !pass.hasTessellationDomainProgram();
}

void removeMaterial(Ogre::MaterialPtr& material) {
    if (material && Ogre::MaterialManager::getSingletonPtr() != nullptr)
        Ogre::MaterialManager::getSingleton().remove(material);
    material.reset();
}

} // namespace

BatchMaterials::~BatchMaterials() {
    clear();
}

void BatchMaterials::clear() {
    for (Worn& worn : mWorn) {
        removeMaterial(worn.surface);
        removeMaterial(worn.caster);
    }
    mProgram.reset();
    mState = {};
}

bool BatchMaterials::follow(Ogre::SceneManager& manager) {
    mManager = &manager;
    const Ogre::Pass* const pass = shadowCasterPassOf(manager);
    const CasterPrograms programs = casterProgramsOf(manager);
    // Another fragment program may store what depends on the order, or on texture coordinates.
    if (pass == nullptr || programs.vertex != SingleProgram || !isOwnProgram(programs.fragment) ||
        !drawsOnce(*pass))
        return false;
    // OGRE sets the one's culling, and draws the other.
    const Ogre::Technique* const technique = pass->getParent()->getParent()->getBestTechnique();
    if (technique == nullptr || technique->getPass(0) != pass) return false;
    const Fingerprint state = stateOf(*pass, programs);
    // In place: passes that were drawn in this frame may be asked about at its end.
    if (state != mState)
        for (std::size_t culling = 0; culling < mWorn.size(); ++culling)
            for (const Ogre::MaterialPtr& material :
                 {mWorn[culling].surface, mWorn[culling].caster})
                if (material) copyCaster(*material, static_cast<Ogre::CullingMode>(culling));
    mState = state;
    return !mSaid && canDrawInstances();
}

bool BatchMaterials::sayCannot(const std::string& reason) {
    mSaid = true;
    logWarning("scene manager '" + mManager->getName() +
               "' draws shadow casters one by one, and not in batches: " + reason);
    return false;
}

bool BatchMaterials::canDrawInstances() {
    const Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
    if (!system.getCapabilities()->hasCapability(Ogre::RSC_VERTEX_BUFFER_INSTANCE_DATA))
        return sayCannot("the render system has no instanced arrays");
    if (!mProgram) mProgram = instancesProgram();
    if (!mProgram)
        return sayCannot(std::string("there is no program ") + InstancesProgram +
                         "; the materials are another Lixel's");
    if (!mProgram->isLoaded()) mProgram->load();
    if (!mProgram->isSupported() || mProgram->hasCompileError())
        return sayCannot(std::string("the render system does not support the program ") +
                         InstancesProgram);
    return true;
}

const Ogre::MaterialPtr& BatchMaterials::of(Ogre::CullingMode culling) {
    Worn& worn = mWorn.at(static_cast<std::size_t>(culling));
    if (!worn.surface) {
        worn.caster = makeMaterial("Caster", culling);
        worn.surface = makeMaterial("Surface", culling);
        worn.surface->getTechnique(0)->setShadowCasterMaterial(worn.caster);
        worn.surface->load();
    }
    return worn.surface;
}

Ogre::MaterialPtr BatchMaterials::makeMaterial(const char* kind, Ogre::CullingMode culling) const {
    const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(
        "Lixel/Batch/" + mManager->getName() + "/" + kind +
            std::to_string(static_cast<int>(culling)),
        Ogre::RGN_INTERNAL);
    copyCaster(*material, culling);
    return material;
}

void BatchMaterials::copyCaster(Ogre::Material& material, Ogre::CullingMode culling) const {
    const CasterPrograms programs = casterProgramsOf(*mManager);
    Ogre::Pass& pass = *material.getTechnique(0)->getPass(0);
    pass = *shadowCasterPassOf(*mManager);
    // OGRE lends the original what the last surface cut holes with.
    pass.removeAllTextureUnitStates();
    pass.setSceneBlending(Ogre::SBT_REPLACE);
    pass.setAlphaRejectFunction(Ogre::CMPF_ALWAYS_PASS);
    pass.setCullingMode(culling);
    pass.setVertexProgram(InstancesProgram);
    pass.setFragmentProgram(programs.fragment);
    if (programs.fragmentParameters) pass.setFragmentProgramParameters(programs.fragmentParameters);
    // The one in which OGRE looks for what casts, where it divides passes by their light.
    pass.setIlluminationStage(Ogre::IS_AMBIENT);
    // OGRE's queue sorts passes by it, and keeps them when it is emptied.
    pass._recalculateHash();
    material.load();
}

} // namespace Lixel
