#include "material/DrawnPass.h"

#include "scene/CasterPass.h"

#include <OgreEntity.h>
#include <OgreGpuProgram.h>
#include <OgreInstanceBatch.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreRenderSystem.h>
#include <OgreRenderSystemCapabilities.h>
#include <OgreRenderable.h>
#include <OgreRoot.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <algorithm>

namespace Lixel {
namespace {

/// Whether OGRE made the pass out of one of the technique's own, for an illumination stage.
bool isSplitOff(const Ogre::Pass& pass) {
    const auto& own = pass.getParent()->getPasses();
    return std::find(own.begin(), own.end(), &pass) == own.end();
}

} // namespace

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

std::string materialOf(const Ogre::Pass& pass) {
    return pass.getParent()->getParent()->getName();
}

std::string wornBy(const Ogre::Renderable& renderable) {
    const Ogre::MaterialPtr& material = renderable.getMaterial();
    return material ? material->getName() : "none";
}

bool isStandIn(const Ogre::Pass& pass) {
    const Ogre::Material* const material = pass.getParent()->getParent();
    auto& materials = Ogre::MaterialManager::getSingleton();
    return material == materials.getDefaultMaterial(true).get() ||
           material == materials.getDefaultMaterial(false).get();
}

bool bends(const Ogre::Pass& pass) {
    if (!pass.hasVertexProgram()) return false;
    const Ogre::GpuProgramPtr& program = pass.getVertexProgram();
    return program->isSkeletalAnimationIncluded() || program->isMorphAnimationIncluded() ||
           program->isPoseAnimationIncluded();
}

bool isBentByProgram(Ogre::Renderable& renderable) {
    auto* const part = dynamic_cast<Ogre::SubEntity*>(&renderable);
    return part != nullptr && part->getParent()->isHardwareAnimationEnabled();
}

bool isOfTerrain(const Ogre::Pass& pass) {
    return Ogre::StringUtil::startsWith(materialOf(pass), "OgreTerrain/", false);
}

bool isLeftUnplaced(const Ogre::Pass& pass, Ogre::Renderable& renderable) {
    return dynamic_cast<Ogre::InstanceBatch*>(&renderable) != nullptr && pass.hasVertexProgram() &&
           isOwnProgram(pass.getVertexProgramName());
}

bool lacksPrograms(const Ogre::Pass& pass) {
    return (!pass.hasVertexProgram() || !pass.hasFragmentProgram()) &&
           !Ogre::Root::getSingleton().getRenderSystem()->getCapabilities()->hasCapability(
               Ogre::RSC_FIXED_FUNCTION);
}

std::string whatLacksPrograms(const Ogre::Pass& pass) {
    const std::string name = quoted(materialOf(pass));
    if (isStandIn(pass))
        return "OGRE's own material " + name +
               " is drawn, which has no programs, and this render system draws nothing without: it "
               "stands in for a material whose name is not known or whose programs do not compile "
               "(see OGRE's lines in this log)";
    if (isSplitOff(pass) && pass.getParent()->getPass(0)->hasFragmentProgram())
        return "material " + name +
               " loses its fragment program where OGRE splits its pass for additive shadows, and "
               "cannot be drawn: give it one pass of illumination_stage ambient and one of "
               "per_light, as Lixel/Surface has; where the shader system makes its programs, have "
               "SGTechniqueResolverListener of OgreBites give them to what is split";
    return "material " + name +
           " has no programs, and this render system draws nothing without: inherit Lixel/Surface "
           "(if it does, its group may not find General: see OGRE's errors in this log), or let "
           "OGRE's shader system make some";
}

} // namespace Lixel
