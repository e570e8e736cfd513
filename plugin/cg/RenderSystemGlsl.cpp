#include "cg/RenderSystemGlsl.h"

#include <OgreGpuProgramManager.h>
#include <OgreHighLevelGpuProgramManager.h>

namespace Lixel::Cg {

unsigned glslVersionOfRenderSystem() {
    if (!Ogre::HighLevelGpuProgramManager::getSingleton().isLanguageSupported("glsl")) return 0;
    const auto& programs = Ogre::GpuProgramManager::getSingleton();
    // OGRE's older GL names no version beyond 1.20, whatever the driver has.
    if (programs.isSyntaxSupported("glsl330")) return 330;
    if (programs.isSyntaxSupported("glsl120")) return 120;
    return 0;
}

} // namespace Lixel::Cg
