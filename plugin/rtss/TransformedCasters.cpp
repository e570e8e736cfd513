#include "rtss/TransformedCasters.h"

#include <Lixel/scene/OgreVersions.h>

#include <OgreGpuProgramManager.h>
#include <OgreGpuProgramParams.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
#include <OgreTextureUnitState.h>
#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderFunctionAtom.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>

#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

namespace {

const char* const PlainCaster = "Lixel/Caster";
/// Programs that begin with Lixel/ count as ones that place no instances.
const char* const ProgramPrefix = "LixelPlaced/";

/// How a vertex program of the shader system transforms vertices, where a world matrix does not do
/// it alone.
struct VertexTransform {
    /// Bones that bend a mesh, and how many of them each vertex; 0 for none.
    std::size_t bones = 0;
    std::size_t weights = 0;
    /// Whether bones are given in the object's space; otherwise in the world's.
    bool bonesAreInObject = false;
    /// The first of the three texture coordinates with each instance's matrix; none: no instances.
    std::optional<int> matrixSet;

    bool isSkinned() const { return bones > 0 && weights > 0; }
};

/// How many of a vertex's weights a program reads: since OGRE 13.5 all at once, and a macro says
/// how many count; before, one by one.
std::size_t weightsReadBy(Program& program) {
    constexpr std::string_view Macro = "WEIGHT_COUNT=";
    const Ogre::String& defines = program.getPreprocessorDefines();
    if (const std::size_t at = defines.find(Macro); at != Ogre::String::npos)
        return std::strtoul(defines.c_str() + at + Macro.size(), nullptr, 10);
    std::set<int> components;
    for (FunctionAtom* call : program.getMain()->getAtomInstances())
        for (const Operand& operand : call->getOperandList())
            if (operand.getParameter()->getContent() == Parameter::SPC_BLEND_WEIGHTS)
                components.insert(operand.getMask());
    return components.size();
}

bool bonesAreInObject() {
#if OGRE_MIN_VERSION(13, 5, 0) // and it is the default since 14
    return Ogre::MeshManager::getBonesUseObjectSpace();
#else
    return false;
#endif
}

std::optional<int> matrixSetOf(Function& main) {
    for (const ParameterPtr& input : main.getInputParameters())
        if (input->getType() == Ogre::GCT_MATRIX_3X4)
            return input->getContent() - Parameter::SPC_TEXTURE_COORDINATE0;
    return {};
}

VertexTransform transformOf(Program& vertexProgram) {
    VertexTransform transform;
    const UniformParameterPtr bones =
        vertexProgram.getParameterByAutoType(GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    if (bones) {
        transform.bones = bones->getSize();
        transform.weights = weightsReadBy(vertexProgram);
        transform.bonesAreInObject = bonesAreInObject();
    }
    transform.matrixSet = matrixSetOf(*vertexProgram.getMain());
    return transform;
}

std::string nameOf(const VertexTransform& transform) {
    if (!transform.isSkinned()) return "/Instances" + std::to_string(*transform.matrixSet);
    return "/Bones" + std::to_string(transform.bones) + "/Weights" +
           std::to_string(transform.weights) + (transform.bonesAreInObject ? "/InObject" : "");
}

/// Whether OGRE has a pass's texture cut holes into the pass's shadow.
bool cutsHoles(const Ogre::Pass& pass) {
    return pass.getAlphaRejectFunction() != Ogre::CMPF_ALWAYS_PASS ||
           (pass.getSourceBlendFactor() == Ogre::SBF_SOURCE_ALPHA &&
            pass.getDestBlendFactor() == Ogre::SBF_ONE_MINUS_SOURCE_ALPHA);
}

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
    if (transform.isSkinned()) {
        program->setParameter("preprocessor_defines",
                              "LIXEL_BONES=" + std::to_string(transform.bones) +
                                  ",LIXEL_WEIGHTS=" + std::to_string(transform.weights));
        program->setSkeletalAnimationIncluded(true);
    } else {
        program->setParameter("preprocessor_defines",
                              "LIXEL_MATRIX=uv" + std::to_string(*transform.matrixSet));
    }
    const Ogre::GpuProgramParametersSharedPtr& parameters = program->getDefaultParameters();
    parameters->setNamedAutoConstant("clipFromPlaced",
                                     transform.bonesAreInObject
                                         ? GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX
                                         : GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
    parameters->setNamedAutoConstant("diffuseMapMatrix", GpuProgramParameters::ACT_TEXTURE_MATRIX,
                                     0);
    if (transform.isSkinned())
        parameters->setNamedAutoConstant("bones", GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
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
    if (!plain || !pluginIsLoaded()) return {};
    const std::string name = PlainCaster + nameOf(transform) + surfaceNameOf(surface);
    Ogre::MaterialPtr caster = materials.getByName(name, plain->getGroup());
    // The texture of a material may be another since its last program was made.
    if (caster && !cutsHoles(surface)) return caster;
    if (!caster) caster = makeCaster(*plain, name, transform);
    copySurface(surface, *caster->getTechnique(0)->getPass(0));
    caster->load();
    return caster;
}

} // namespace

bool pluginIsLoaded() {
    return Ogre::GpuProgramManager::getSingleton().getAvailableSharedParameters().count(
               PlainCaster) > 0;
}

std::string setCaster(Ogre::Pass& pass, Program& vertexProgram) {
    // Set 0 has the coordinates of the alpha texture, and a matrix takes three of the eight sets.
    constexpr int FirstSet = 1, LastSet = 5;
    Ogre::Technique& technique = *pass.getParent();
    if (technique.getShadowCasterMaterial()) return {};
    const VertexTransform transform = transformOf(vertexProgram);
    // Neither needs no caster, and OGRE does not draw both.
    if (transform.isSkinned() == transform.matrixSet.has_value()) return {};
    if (transform.matrixSet && (*transform.matrixSet < FirstSet || *transform.matrixSet > LastSet))
        return "instances of material '" + technique.getParent()->getName() +
               "' cast wrong shadows: their matrices begin at texture coordinate set " +
               std::to_string(*transform.matrixSet) + ", and Lixel's caster reads those at " +
               std::to_string(FirstSet) + " to " + std::to_string(LastSet) +
               "; name a shadow_caster_material in its technique";
    if (const Ogre::MaterialPtr caster = casterFor(transform, pass))
        technique.setShadowCasterMaterial(caster);
    return {};
}

} // namespace Lixel
