#include "rtss/TransformedCasters.h"

#include "rtss/ShadowUnits.h"
#include "rtss/VertexTransform.h"

#include <Lixel/scene/CasterPass.h>
#include <Lixel/scene/OgreVersions.h>

#include <OgreGpuProgramManager.h>
#include <OgreGpuProgramParams.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
#include <OgreTextureUnitState.h>

namespace Lixel {

namespace {

const char* const PlainCaster = "Lixel/Caster";
/// Programs that begin with Lixel/ count as ones that place no instances.
const char* const ProgramPrefix = "LixelPlaced/";

/// What passes have in common that can share a caster, beside how they are transformed.
std::string surfaceNameOf(const Ogre::Pass& pass) {
    const std::string culling = "/Culling" + std::to_string(pass.getCullingMode());
    if (!cutsHoles(pass)) return culling;
    const Ogre::Technique& technique = *pass.getParent();
    const Ogre::Material& material = *technique.getParent();
    return culling + "/" + technique.getSchemeName() + "/" + material.getGroup() + "/" +
           material.getName();
}

/// As OGRE does it for Lixel/Caster, object by object: a clone has what the last one left there.
void copySurface(const Ogre::Pass& surface, Ogre::Pass& caster) {
    caster.removeAllTextureUnitStates();
    caster.setSceneBlending(Ogre::SBT_REPLACE);
    caster.setCullingMode(surface.getCullingMode());
    caster.setManualCullingMode(surface.getManualCullingMode());
    caster.setAlphaRejectSettings(surface.getAlphaRejectFunction(), surface.getAlphaRejectValue());
    if (!cutsHoles(surface) || surface.getNumTextureUnitStates() == 0) return;
    const Ogre::TextureUnitState& texture = *surface.getTextureUnitState(0);
    if (texture.getContentType() == Ogre::TextureUnitState::CONTENT_NAMED)
        *caster.createTextureUnitState() = texture;
}

/// The vertex program, of this name and in this group.
void makeProgram(const std::string& name, const Ogre::String& group,
                 const VertexTransform& transform) {
    const Ogre::GpuProgramPtr program =
        createProgram(name, group, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    program->setSourceFile("LixelCasterPlaced.vert");
    program->setParameter("preprocessor_defines", definesOf(transform));
    program->setSkeletalAnimationIncluded(transform.isSkinned());
    const Ogre::GpuProgramParametersSharedPtr& parameters = program->getDefaultParameters();
    bind(transform, *parameters);
    parameters->setNamedAutoConstant("diffuseMapMatrix",
                                     Ogre::GpuProgramParameters::ACT_TEXTURE_MATRIX, 0);
    parameters->addSharedParameters(PlainCaster);
}

/// A clone of Lixel/Caster with a program of its own.
Ogre::MaterialPtr makeCaster(const Ogre::Material& plain, const std::string& name,
                             const VertexTransform& transform) {
    const std::string program = ProgramPrefix + (PlainCaster + nameOf(transform));
    if (!Ogre::GpuProgramManager::getSingleton().getByName(program, plain.getGroup()))
        makeProgram(program, plain.getGroup(), transform);
    const Ogre::MaterialPtr caster = plain.clone(name);
    // The others are what the shader system makes of it for schemes.
    while (caster->getNumTechniques() > 1)
        caster->removeTechnique(static_cast<unsigned short>(caster->getNumTechniques() - 1));
    caster->getTechnique(0)->getPass(0)->setVertexProgram(program);
    return caster;
}

/// A clone of Lixel/Caster with the same skinning or instancing. Null if it is not loaded.
Ogre::MaterialPtr casterFor(const VertexTransform& transform, const Ogre::Pass& surface) {
    auto& materials = Ogre::MaterialManager::getSingleton();
    const Ogre::MaterialPtr plain = materials.getByName(PlainCaster);
    if (!plain) return {};
    const std::string name = PlainCaster + nameOf(transform) + surfaceNameOf(surface);
    Ogre::MaterialPtr caster = materials.getByName(name, plain->getGroup());
    // The texture of a material may be another since its last program was made.
    if (caster && !cutsHoles(surface)) return caster;
    if (!caster) caster = makeCaster(*plain, name, transform);
    copySurface(surface, *caster->getTechnique(0)->getPass(0));
    caster->load();
    return caster;
}

/// Whether the shader system draws a caster: it has no programs of its own, and so writes what the
/// shader system's own receivers read, which is not what Lixel's do.
bool isOfShaderSystem(const Ogre::Material& caster) {
    if (caster.getNumTechniques() == 0) return false;
    const Ogre::Technique* const technique = caster.getTechnique(0);
    return technique->getNumPasses() > 0 && !technique->getPass(0)->hasVertexProgram();
}

} // namespace

bool pluginIsLoaded() {
    return Ogre::GpuProgramManager::getSingleton().getAvailableSharedParameters().count(
               PlainCaster) > 0;
}

std::string setCaster(Ogre::Pass& pass, Ogre::RTShader::Program& vertexProgram) {
    // Set 0 has the coordinates of the alpha texture, and a matrix takes three of the eight sets.
    constexpr int FirstSet = 1, LastSet = 5;
    Ogre::Technique& technique = *pass.getParent();
    if (!pluginIsLoaded()) return {};
    const Ogre::MaterialPtr own = technique.getShadowCasterMaterial();
    if (own && (!isOfShaderSystem(*own) || hasShadowUnits(pass))) return {};
    const VertexTransform transform = transformOf(vertexProgram);
    // Neither needs no caster, and OGRE does not draw both.
    if (transform.isSkinned() == transform.matrixSet.has_value()) {
        technique.setShadowCasterMaterial(Ogre::MaterialPtr());
        return {};
    }
    if (transform.matrixSet && (*transform.matrixSet < FirstSet || *transform.matrixSet > LastSet))
        return "instances of material '" + technique.getParent()->getName() +
               "' cast wrong shadows: their matrices begin at texture coordinate set " +
               std::to_string(*transform.matrixSet) + ", and Lixel's caster reads those at " +
               std::to_string(FirstSet) + " to " + std::to_string(LastSet) +
               "; give its technique a shadow_caster_material with programs";
    if (const Ogre::MaterialPtr caster = casterFor(transform, pass))
        technique.setShadowCasterMaterial(caster);
    return {};
}

} // namespace Lixel
