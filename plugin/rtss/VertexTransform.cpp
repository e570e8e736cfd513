#include "rtss/VertexTransform.h"

#include <Lixel/scene/OgreVersions.h>

#include <RTShaderSystem/OgreShaderFunction.h>
#include <RTShaderSystem/OgreShaderFunctionAtom.h>
#include <RTShaderSystem/OgreShaderParameter.h>
#include <RTShaderSystem/OgreShaderProgram.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string_view>

namespace Lixel {

using namespace Ogre::RTShader;
using Ogre::GpuProgramParameters;

namespace {

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

/// By a macro since OGRE 13.5, too.
bool isAntipodal(Program& program) {
    if (program.getPreprocessorDefines().find("CORRECT_ANTIPODALITY") != Ogre::String::npos)
        return true;
    return std::ranges::any_of(program.getMain()->getAtomInstances(), [](FunctionAtom* call) {
        const auto* const function = dynamic_cast<FunctionInvocation*>(call);
        return function != nullptr && function->getFunctionName() == "SGX_AntipodalityAdjustment";
    });
}

std::optional<int> matrixSetOf(Function& main) {
    for (const ParameterPtr& input : main.getInputParameters())
        if (input->getType() == Ogre::GCT_MATRIX_3X4)
            return input->getContent() - Parameter::SPC_TEXTURE_COORDINATE0;
    return {};
}

} // namespace

VertexTransform transformOf(Program& vertexProgram) {
    VertexTransform transform;
    transform.matrixSet = matrixSetOf(*vertexProgram.getMain());
    const auto find = [&](GpuProgramParameters::AutoConstantType type) {
        return vertexProgram.getParameterByAutoType(type);
    };
    UniformParameterPtr bones = find(GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    if (!bones) {
        bones = find(GpuProgramParameters::ACT_WORLD_DUALQUATERNION_ARRAY_2x4);
        if (!bones) return transform;
        transform.hasQuaternions = true;
        transform.hasScales =
            find(GpuProgramParameters::ACT_WORLD_SCALE_SHEAR_MATRIX_ARRAY_3x4) != nullptr;
        transform.isAntipodal = isAntipodal(vertexProgram);
    }
    transform.bones = bones->getSize();
    transform.weights = weightsReadBy(vertexProgram);
    transform.bonesAreInObject = bonesAreInObject();
    return transform;
}

std::string nameOf(const VertexTransform& transform) {
    if (!transform.isSkinned()) return "/Instances" + std::to_string(*transform.matrixSet);
    std::string name =
        "/Bones" + std::to_string(transform.bones) + "/Weights" + std::to_string(transform.weights);
    if (transform.bonesAreInObject) name += "/InObject";
    if (transform.hasQuaternions) name += "/Quaternions";
    if (transform.hasScales) name += "/Scales";
    if (transform.isAntipodal) name += "/Antipodal";
    return name;
}

std::string definesOf(const VertexTransform& transform) {
    if (!transform.isSkinned()) return "LIXEL_MATRIX=uv" + std::to_string(*transform.matrixSet);
    std::string defines = "LIXEL_BONES=" + std::to_string(transform.bones) +
                          ",LIXEL_WEIGHTS=" + std::to_string(transform.weights);
    if (transform.hasQuaternions) defines += ",LIXEL_QUATERNIONS=1";
    if (transform.hasScales) defines += ",LIXEL_SCALES=1";
    if (transform.isAntipodal) defines += ",LIXEL_ANTIPODAL=1";
    return defines;
}

void bind(const VertexTransform& transform, GpuProgramParameters& parameters) {
    parameters.setNamedAutoConstant("clipFromPlaced",
                                    transform.bonesAreInObject
                                        ? GpuProgramParameters::ACT_WORLDVIEWPROJ_MATRIX
                                        : GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
    if (!transform.isSkinned()) return;
    parameters.setNamedAutoConstant(
        "bones", transform.hasQuaternions ? GpuProgramParameters::ACT_WORLD_DUALQUATERNION_ARRAY_2x4
                                          : GpuProgramParameters::ACT_WORLD_MATRIX_ARRAY_3x4);
    if (transform.hasScales)
        parameters.setNamedAutoConstant(
            "scales", GpuProgramParameters::ACT_WORLD_SCALE_SHEAR_MATRIX_ARRAY_3x4);
}

} // namespace Lixel
