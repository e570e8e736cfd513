#pragma once

namespace Lixel::Cg {

/// The GLSL version that programs are translated to for OGRE's render system: 330 for GL3+, 120 for
/// GL. 0 if it is another, or has no GLSL.
unsigned glslVersionOfRenderSystem();

} // namespace Lixel::Cg
