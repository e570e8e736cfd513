// What can be set of every setup of Lixel's.
#include "setup/FittedShadowCameraSetup.h"

#include "scene/Fingerprint.h"
#include "scene/OgreMath.h"

#include <OgreException.h>

#include <algorithm>
#include <array>

namespace Lixel {
namespace {

constexpr std::array DeclaredCommon{
    option<&CommonOptions::filterRadius>(
        "filter_radius", between(0.0, 64.0), "texels",
        "how far the receiver's filter reaches; the map keeps this and one texel more free at its "
        "border: 0 for one nearest tap, 1 for bilinear"),
    option<&CommonOptions::depthBias>(
        "depth_bias", atLeast(0.0), "world units",
        "how near a caster must be to a receiver along the light's axis to be taken for the "
        "receiver itself, for surfaces that are not planar at the scale of a texel"),
    option<&CommonOptions::meshHulls>(
        "mesh_hulls",
        "whether maps are fitted to convex hulls of meshes that fill their boxes badly, and leave "
        "out what a mesh cannot shadow of itself: a convex one, such as a flat ground, and of a "
        "ground of hills all but what is behind slopes that face away from the light; and "
        "the sides of boxes and blocks of ground that face away from it; off where static buffers "
        "are rewritten in place"),
    option<&CommonOptions::reuseMaps>(
        "reuse_maps", "whether a map is kept while it shows just what it would show if it were "
                      "drawn again"),
    option<&CommonOptions::movingApart>(
        "moving_apart",
        "whether under LixelSceneManager what stands still of a map's casters is "
        "kept in a second texture, and only what moves is drawn, over a copy of it"),
    option<&CommonOptions::lastingMaps>("lasting_maps", between(0.0, 1.0), "share",
                                        "how much coarser a map's texels may become before it is "
                                        "fitted anew while the viewer moves; "
                                        "0: fitted in each frame"),
    option<&CommonOptions::feedback>(
        "feedback", "whether maps are judged by what the frame before showed, whose depths are "
                    "read back without waiting for the GPU, instead of by a few view rays: XPSM, "
                    "Optimal and cascades, with OpenGL"),
    option<&CommonOptions::meshParts>(
        "mesh_parts", between(0.0, 65536.0), "",
        "parts in which a large mesh is known that reaches out of the view, at most, such as a "
        "terrain with all that grows on it; 0: as a whole, which takes less time"),
};

void addOptions(std::span<const Option> declared, void* options, Fingerprint& settings) {
    for (const Option& option : declared) {
        switch (option.type) {
        case OptionType::Plane:
            for (const double number : *static_cast<const Vec4*>(option.member(options)))
                settings.add(number);
            break;
        case OptionType::Ascending: {
            const auto& numbers = *static_cast<const std::vector<double>*>(option.member(options));
            settings.add(std::uint64_t{numbers.size()});
            for (const double number : numbers)
                settings.add(number);
            break;
        }
        default:
            settings.add(optionNumber(option, options));
        }
    }
}

} // namespace

std::span<const Option> CommonOptions::declared() {
    return DeclaredCommon;
}

void FittedShadowCameraSetup::checkOptions(std::span<const Option> declared, const void* options) {
    const std::string wrong = wrongOption(declared, options);
    if (!wrong.empty())
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, wrong, "Lixel's setOptions");
}

void FittedShadowCameraSetup::addSettings(Fingerprint& settings) const {
    settings.add(std::string_view(mName));
    addOptions(mDeclared, mOptions, settings);
    // What is read alone is not changed.
    addOptions(CommonOptions::declared(), const_cast<CommonOptions*>(&mCommon), settings);
    if (const FittedShadowCameraSetup* const other = technique()) other->addSettings(settings);
}

void FittedShadowCameraSetup::setCommon(double CommonOptions::*member, Ogre::Real value) {
    CommonOptions options = mCommon;
    options.*member = static_cast<double>(value);
    checkOptions(CommonOptions::declared(), &options);
    mCommon = options;
}

void FittedShadowCameraSetup::setFilterRadius(Ogre::Real texels) {
    setCommon(&CommonOptions::filterRadius, texels);
}

void FittedShadowCameraSetup::setDepthBias(Ogre::Real worldUnits) {
    setCommon(&CommonOptions::depthBias, worldUnits);
}

void FittedShadowCameraSetup::setLastingMaps(Ogre::Real share) {
    setCommon(&CommonOptions::lastingMaps, share);
}

void FittedShadowCameraSetup::setMeshParts(int parts) {
    CommonOptions options = mCommon;
    options.meshParts = parts;
    checkOptions(CommonOptions::declared(), &options);
    mCommon = options;
}

void FittedShadowCameraSetup::setVisiblePoints(const std::vector<VisiblePoint>& wsPoints) {
    for (const VisiblePoint& point : wsPoints)
        if (!point.ws.allFinite() || !point.wsNormal.allFinite() || point.wsNormal.isZero(0.0))
            OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                        "wsPoints: points must be finite, and normals not zero",
                        "FittedShadowCameraSetup::setVisiblePoints");
    // As many as there can be samples; of more, every so many.
    constexpr std::size_t Most = 4096;
    const std::size_t kept = std::min(wsPoints.size(), Most);
    ++mVisiblePointsSet;
    mWsVisiblePoints.clear();
    for (std::size_t i = 0; i < kept; ++i)
        mWsVisiblePoints.push_back(wsPoints[i * wsPoints.size() / kept]);
    for (VisiblePoint& point : mWsVisiblePoints)
        point.wsNormal.stableNormalize();
}

void FittedShadowCameraSetup::setVisiblePoints(const std::vector<Ogre::Vector3>& wsPositions,
                                               const std::vector<Ogre::Vector3>& wsNormals) {
    if (wsPositions.size() != wsNormals.size())
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "wsNormals: there must be one for each of wsPositions",
                    "FittedShadowCameraSetup::setVisiblePoints");
    std::vector<VisiblePoint> points;
    for (std::size_t i = 0; i < wsPositions.size(); ++i)
        points.push_back({toDouble(wsPositions[i]), toDouble(wsNormals[i])});
    setVisiblePoints(points);
}

} // namespace Lixel
