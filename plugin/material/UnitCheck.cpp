#include "material/UnitCheck.h"

#include "material/MapReads.h"
#include "material/PassPrograms.h"
#include "material/ProgramCheck.h"
#include "scene/OgreVersions.h"

#include <OgrePass.h>
#include <OgreTechnique.h>
#include <OgreTexture.h>
#include <OgreTextureUnitState.h>

#include <algorithm>
#include <optional>

namespace Lixel {
namespace {

const std::string Sampler = "shadowMap";
const char* const DiffuseMap = "DiffuseMap";
const char* const MapIsIn = "OGRE puts that map into";

/// The texture unit that a sampler of this name is set to; none where there is no such sampler.
std::optional<std::size_t> unitOf(const std::string& sampler,
                                  const Ogre::GpuProgramParameters& parameters) {
    const Ogre::GpuConstantDefinition* const definition =
        parameters._findNamedConstantDefinition(sampler);
    if (definition == nullptr || !definition->isSampler()) return std::nullopt;
    return static_cast<std::size_t>(textureUnitOf(parameters, *definition));
}

/// OGRE numbers units that have no name in their script.
bool isUnnamed(const Ogre::TextureUnitState& unit) {
    return unit.getName().find_first_not_of("0123456789") == std::string::npos;
}

bool isOneTexel(const Ogre::TextureUnitState& unit) {
    const Ogre::TexturePtr& texture = unit._getTexturePtr();
    return texture && texture->getWidth() == 1 && texture->getHeight() == 1;
}

bool hasUnit(const Ogre::Pass& pass, const char* name) {
    return std::ranges::count(pass.getTextureUnitStates(), name, &Ogre::TextureUnitState::getName) >
           0;
}

bool rejectsAlpha(const Ogre::Pass& pass) {
    return pass.getAlphaRejectFunction() != Ogre::CMPF_ALWAYS_PASS;
}

/// Finds passes of the same technique whose holes this pass fills.
void addFilledHoles(const Ogre::Pass& pass, std::vector<std::string>& wrong) {
    if (rejectsAlpha(pass)) return;
    for (const Ogre::Pass* other : pass.getParent()->getPasses())
        if (rejectsAlpha(*other) && hasUnit(*other, DiffuseMap))
            wrong.push_back("pass '" + pass.getName() + "' fills the holes of pass '" +
                            other->getName() + "': give it the same alpha_rejection");
}

/// Slips with the unit DiffuseMap, which is the one of that index.
void addSlipsWithDiffuseMap(const Ogre::Pass& pass, std::size_t index,
                            std::vector<std::string>& wrong) {
    const auto& states = pass.getTextureUnitStates();
    const Ogre::TextureUnitState& diffuseMap = *states[index];
    addFilledHoles(pass, wrong);
    if (!diffuseMap.getTextureName().empty()) {
        if (isOneTexel(diffuseMap))
            wrong.push_back("texture '" + diffuseMap.getTextureName() +
                            "' has one texel, and a program cannot tell that from no texture, "
                            "which is white: make it larger, or say diffuse and ambient");
        return;
    }
    for (const Ogre::TextureUnitState* other : states)
        if (isUnnamed(*other) && !other->getTextureName().empty())
            wrong.push_back("texture '" + other->getTextureName() +
                            "' is in a unit without a name, which nothing reads: write "
                            "`texture_unit DiffuseMap`");
}

} // namespace

std::vector<std::string> findWrongUnits(const Ogre::Pass& pass, bool integrated) {
    std::vector<std::string> wrong;
    const auto check = [&](const std::string& sampler, std::size_t expected, const char* what) {
        forPrograms(pass, [&](const Ogre::GpuProgramParameters& parameters) {
            const std::optional<std::size_t> unit = unitOf(sampler, parameters);
            if (unit && *unit != expected)
                wrong.push_back("'" + sampler + "' is texture unit " + std::to_string(*unit) +
                                ", and " + what + " unit " + std::to_string(expected) +
                                ": write units of your own behind Lixel's");
        });
    };
    const auto& states = pass.getTextureUnitStates();
    if (integrated) {
        const std::vector<std::size_t> units = shadowUnitsOf(pass);
        if (!units.empty()) check(Sampler, units.front(), MapIsIn);
        for (std::size_t map = 0; map < units.size(); ++map)
            check(Sampler + std::to_string(map), units[map], MapIsIn);
        const std::size_t read = mapsRead(pass, 0);
        if (!units.empty() && read > units.size())
            wrong.push_back("its program reads " + std::to_string(read) +
                            " shadow maps, and it has " + std::to_string(units.size()) +
                            " texture units of content_type shadow: inherit "
                            "Lixel/Surface/Integrated/Maps" +
                            std::to_string(mapsOfParentFor(read)));
    } else {
        // The first: what OGRE lends a receiver of the surface's comes behind its own.
        const auto own = std::ranges::find(states, "ShadowMap", &Ogre::TextureUnitState::getName);
        if (own != states.end() && mapsRead(pass, 0) > 0)
            check(Sampler, static_cast<std::size_t>(own - states.begin()), "ShadowMap is");
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i]->getName() != DiffuseMap) continue;
        check("diffuseMap", i, "DiffuseMap is");
        addSlipsWithDiffuseMap(pass, i, wrong);
    }
    return wrong;
}

} // namespace Lixel
