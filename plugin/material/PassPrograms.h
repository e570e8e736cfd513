#pragma once

#include <OgrePass.h>

namespace Lixel {

/// Calls `visit` with the parameters of each program that a pass has.
template <typename Visit>
void forPrograms(const Ogre::Pass& pass, const Visit& visit) {
    if (pass.hasVertexProgram()) visit(*pass.getVertexProgramParameters());
    if (pass.hasFragmentProgram()) visit(*pass.getFragmentProgramParameters());
}

} // namespace Lixel
