#include "rtss/PlacedCasters.h"

#include <OgreGpuProgramManager.h>
#include <OgreGpuProgramParams.h>
#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderFunctionAtom.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>

#include <set>
#include <string>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

namespace {

const char* const PlainCaster = "Lixel/Caster";
/// Programs that begin with Lixel/ count as ones that place no instances.
const char* const ProgramPrefix = "LixelPlaced/";

/// How many of a vertex's weights a program reads: it takes them one by one.
std::size_t weightsReadBy(Function& main) {
    std::set<int> components;
    for (FunctionAtom* call : main.getAtomInstances())
        for (const Operand& operand : call->getOperandList())
            if (operand.getParameter()->getContent() == Parameter::SPC_BLEND_WEIGHTS)
                components.insert(operand.getMask());
    return components.size();
}

bool takesMatrixOfInstance(Function& main) {
    for (const ParameterPtr& input : main.getInputParameters())
        if (input->getType() == Ogre::GCT_MATRIX_3X4 &&
            input->getContent() == Parameter::SPC_TEXTURE_COORDINATE1)
            return true;
    return false;
}

/// The vertex program, of this name and in this group.
void makeProgram(const std::string& name, const Ogre::String& group, const Placing& placing) {
    const auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(
        name, group, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    program->setSourceFile("LixelCasterPlaced.vert");
    if (placing.bones > 0) {
        program->setParameter("preprocessor_defines",
                              "LIXEL_BONES=" + std::to_string(placing.bones) +
                                  ",LIXEL_WEIGHTS=" + std::to_string(placing.weights));
        program->setSkeletalAnimationIncluded(true);
    }
    const Ogre::GpuProgramParametersSharedPtr& parameters = program->getDefaultParameters();
    parameters->setNamedAutoConstant("viewProj", GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
    if (placing.bones > 0)
        parameters->setNamedAutoConstant("bones", GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    parameters->addSharedParameters(PlainCaster);
}

} // namespace

bool tellsCastersTheirDepth() {
    return Ogre::GpuProgramManager::getSingleton().getAvailableSharedParameters().count(
               PlainCaster) > 0;
}

Placing placingOf(Program& vertexProgram) {
    Function& main = *vertexProgram.getMain();
    Placing placing;
    const UniformParameterPtr bones =
        vertexProgram.getParameterByAutoType(GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    if (bones) {
        placing.bones = bones->getSize();
        placing.weights = weightsReadBy(main);
    }
    placing.isInstanced = takesMatrixOfInstance(main);
    return placing;
}

Ogre::MaterialPtr casterFor(const Placing& placing) {
    const bool isBent = placing.bones > 0 && placing.weights > 0;
    if (isBent == placing.isInstanced) return {}; // neither, or both, which OGRE does not draw
    auto& materials = Ogre::MaterialManager::getSingleton();
    const std::string name =
        PlainCaster + (isBent ? "/Bones" + std::to_string(placing.bones) + "/Weights" +
                                    std::to_string(placing.weights)
                              : std::string("/Instances"));
    const Ogre::MaterialPtr plain = materials.getByName(PlainCaster);
    if (!plain || !tellsCastersTheirDepth()) return {};
    if (Ogre::MaterialPtr made = materials.getByName(name, plain->getGroup())) return made;
    const std::string program = ProgramPrefix + name;
    makeProgram(program, plain->getGroup(), placing);
    const Ogre::MaterialPtr caster = plain->clone(name);
    // The others are what the shader system makes of it for schemes.
    while (caster->getNumTechniques() > 1)
        caster->removeTechnique(static_cast<unsigned short>(caster->getNumTechniques() - 1));
    caster->getTechnique(0)->getPass(0)->setVertexProgram(program);
    caster->load();
    return caster;
}

} // namespace Lixel
