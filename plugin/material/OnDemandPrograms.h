#pragma once

#include "fit/geometry/Types.h"

#include <OgrePrerequisites.h>

#include <memory>

namespace Lixel {
/// @addtogroup LixelMaterials
/// @{

/** While it lives, programs of the language `lixel_glsl` are GLSL programs that are compiled when a
    material that uses them is first loaded, and not when a script names their parameters. The
    plugin makes one.

    A program that names two languages, `lixel_glsl glsl`, is plain GLSL where there is none, and in
    OGRE 13 and newer: these have OpenGL lay parameters out, which takes a compiled program.
*/
class LIXEL_API OnDemandPrograms {
public:
    OnDemandPrograms();
    ~OnDemandPrograms();
    OnDemandPrograms(const OnDemandPrograms&) = delete;
    OnDemandPrograms& operator=(const OnDemandPrograms&) = delete;

private:
    struct Registration;
    std::unique_ptr<Registration> mRegistration;
};

/// Whether a program of any language has been compiled, without an error. One that a script has
/// made may not have been.
LIXEL_API bool isCompiled(const Ogre::GpuProgram& program);

/// @}
} // namespace Lixel
