#include "material/MapReads.h"

#include "material/LightUniforms.h"
#include "material/PassPrograms.h"
#include "material/ShadowParameters.h"
#include "material/SharedParameters.h"

#include <OgreTextureUnitState.h>

#include <algorithm>

namespace Lixel {

bool writesCasterDepth(const Ogre::Pass& pass) {
    if (!pass.hasVertexProgram()) return false;
    const Ogre::GpuProgramParameters& parameters = *pass.getVertexProgramParameters();
    if (parameters.hasNamedParameters() &&
        parameters._findNamedConstantDefinition("lixelCasterDepth") != nullptr)
        return true;
    const auto isDepth = [](const AutomaticUniform& automatic) {
        return isLightCustom(&automatic) && boundParameter(automatic) == LP_CASTER_DEPTH;
    };
    const auto& automatics = parameters.getAutoConstants();
    return std::any_of(automatics.begin(), automatics.end(), isDepth);
}

std::size_t mapsRead(const Ogre::Pass& pass, std::size_t light) {
    std::size_t maps = 0;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        for (const AutomaticUniform& automatic : parameters.getAutoConstants()) {
            if (!isLightCustom(&automatic) || (automatic.data & LightMask) != light) continue;
            const int parameter = boundParameter(automatic);
            if (isInRange(parameter) && isMapParameter(parameter))
                maps = std::max(maps, static_cast<std::size_t>(mapOf(parameter)) + 1);
        }
    });
    return maps;
}

bool readsSplitDepths(const Ogre::Pass& pass, std::size_t light) {
    bool reads = false;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        reads |= std::ranges::any_of(
            parameters.getAutoConstants(), [&](const AutomaticUniform& automatic) {
                return isLightCustom(&automatic) && (automatic.data & LightMask) == light &&
                       boundParameter(automatic) == LP_SPLIT_DEPTHS;
            });
    });
    return reads;
}

std::vector<std::size_t> shadowUnitsOf(const Ogre::Pass& pass) {
    std::vector<std::size_t> units;
    for (std::size_t i = 0; i < pass.getTextureUnitStates().size(); ++i)
        if (pass.getTextureUnitStates()[i]->getContentType() ==
            Ogre::TextureUnitState::CONTENT_SHADOW)
            units.push_back(i);
    return units;
}

bool readsMaps(const Ogre::Pass& pass) {
    return mapsRead(pass, 0) > 0 || readsModulativeMap(pass);
}

bool readsModulativeMap(const Ogre::Pass& pass) {
    bool reads = false;
    forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
        reads |= parameters.isUsingSharedParameters(SharedParameters::setOf("lixelLight"));
    });
    return reads;
}

} // namespace Lixel
