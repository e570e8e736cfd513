#include "material/ReceiverParameters.h"

#include "fit/parts/LightPartition.h"
#include "material/ShadowParameters.h"
#include "scene/OgreMath.h"

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>

namespace Lixel {
namespace {

/// Depth that interpolation and the slope's screen derivatives may be wrong by: depths are at most
/// 1, with 24 bits; where a texel covers 32 pixels, their difference over one pixel is known to
/// 2^-24, and over half a texel to 2^-20. Twice that.
constexpr double RoundingBias = 0x1p-19;

Ogre::Vector4 toOgreRow(const Eigen::RowVector4d& row) {
    return {static_cast<Ogre::Real>(row[0]), static_cast<Ogre::Real>(row[1]),
            static_cast<Ogre::Real>(row[2]), static_cast<Ogre::Real>(row[3])};
}

} // namespace

ReceiverParameters litParameters() {
    const Ogre::Vector4 zero(0, 0, 0, 0);
    // w is -1 everywhere.
    return {zero,
            zero,
            Ogre::Vector4(0, 0, 0, -1),
            zero,
            Ogre::Vector4(1, 1, 0, 0),
            Ogre::Vector4(0, 0, 0, -EndlessDepth)};
}

ReceiverParameters receiverParameters(const ShadowMap& map) {
    // Programs see world positions relative to the viewer with camera-relative rendering, else
    // absolute ones; the fit's are relative to wsOrigin. Rounded to float only here.
    const Vec3 wsBase = map.sceneManager.getCameraRelativeRendering()
                            ? toDouble(map.viewer.getDerivedPosition())
                            : Vec3(Vec3::Zero());
    Mat4 originFromBase = Mat4::Identity();
    originFromBase.topRightCorner<3, 1>() = wsBase - map.wsOrigin;
    const Ogre::Vector4 share = toOgreRow(map.part.wsRow.transpose() * originFromBase);
    if (!map.fit.hasMap()) {
        ReceiverParameters none = litParameters();
        none.rowShare = share;
        return none;
    }
    const Mat4 clip = map.fit.clipFromWorld * originFromBase;

    const Eigen::RowVector4d w = clip.row(3);
    Eigen::RowVector4d depth = map.fit.depthScale * clip.row(2);
    depth[3] += map.fit.depthOffset;
    // OGRE's render textures have v downwards on every render system.
    return {toOgreRow(0.5 * (w + clip.row(0))),
            toOgreRow(0.5 * (w - clip.row(1))),
            toOgreRow(w),
            toOgreRow(depth),
            Ogre::Vector4(
                static_cast<Ogre::Real>(map.width), static_cast<Ogre::Real>(map.height),
                static_cast<Ogre::Real>(map.depthBias * map.fit.depthPerWorldUnit + RoundingBias),
                static_cast<Ogre::Real>(map.fit.depthPerWorldUnit)),
            share};
}

void bindMap(Ogre::Light& light, std::size_t map, const ReceiverParameters& parameters) {
    const auto set = [&](LightParameter parameter, const Ogre::Vector4& value) {
        light.setCustomParameter(static_cast<Ogre::uint16>(parameter + LP_MAP_STEP * map), value);
    };
    set(LP_MAP_ROW_U, parameters.rowU);
    set(LP_MAP_ROW_V, parameters.rowV);
    set(LP_MAP_ROW_W, parameters.rowW);
    set(LP_MAP_ROW_DEPTH, parameters.rowDepth);
    set(LP_MAP_SIZE_BIAS, parameters.sizeBias);
    set(LP_MAP_ROW_SHARE, parameters.rowShare);
}

void bindNoMaps(Ogre::Light& light) {
    for (std::size_t map = 0; map < LightPartition::Capacity; ++map)
        bindMap(light, map, litParameters());
    light.setCustomParameter(LP_SPLIT_DEPTHS,
                             Ogre::Vector4(EndlessDepth, EndlessDepth, EndlessDepth, EndlessDepth));
}

} // namespace Lixel
