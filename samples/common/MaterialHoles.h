#pragma once

#include "common/AlphaMask.h"

#include <Eigen/Geometry>

#include <optional>

namespace Ogre {
class Material;
} // namespace Ogre

namespace Lixel::Samples {

/// The holes that a material has, and how a mesh's texture coordinates find them.
struct MaterialHoles {
    AlphaMask mask;
    unsigned uvSet = 0; ///< which of the mesh's sets of texture coordinates
    /// The texture unit's scale, scroll and rotation.
    Eigen::Affine3f uvFromMesh = Eigen::Affine3f::Identity();
};

/** The holes in surfaces that wear a material, and in their shadows; nothing where there are none.

    They are where the alpha of a texture is less than the first pass' alpha_rejection says, with
    greater_equal or greater. Without one, an alpha-blended material that has
    transparency_casts_shadows has them where alpha is less than a half, as Lixel/Caster takes it.
    The texture is the first of this pass that is two-dimensional and has more than one texel, as it
    is now: read back from the GPU. It is read between texels, unless the unit magnifies with
    FO_POINT.
    @exception Ogre::InvalidParametersException for other comparisons of alpha_rejection
*/
std::optional<MaterialHoles> findHoles(const Ogre::Material& material);

} // namespace Lixel::Samples
