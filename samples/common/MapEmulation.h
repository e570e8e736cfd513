#pragma once

#include "common/ShadowOracle.h"
#include "common/TruthComparison.h"

#include <limits>
#include <span>

namespace Lixel::Samples {

/// One shadow map, as a GPU has it.
struct EmulatedMap {
    /// OpenGL clip space from positions relative to TriangleScene::wsOrigin, with the rounding of
    /// what hands it to the GPU. Zero where there is no map: everything is lit.
    Eigen::Matrix4d clipFromWs = Eigen::Matrix4d::Zero();
    int width = 0;  ///< texels
    int height = 0; ///< texels
    /// Casters outside the depth range are clamped onto its ends instead of clipped.
    bool clampsDepth = false;
    /// View-space depths whose receivers read this map, in world units, the end excluded.
    double beginDepth = 0.0;
    double endDepth = std::numeric_limits<double>::infinity();
    /// Of the maps whose depths hold a point, the map with the largest wsShare . point is read.
    /// The point is relative to TriangleScene::wsOrigin.
    Eigen::RowVector4d wsShare = Eigen::RowVector4d::Zero();
    /// How much nearer than its receiver a caster must be beyond MapEmulation's own bias, in world
    /// units along the light ray.
    double extraBias = 0.0;
    /// Change of the depth that is really stored for one world unit along the light's axis; 0 where
    /// it is not known. For those who compare with what is drawn.
    double depthPerWorldUnit = 0.0;
};

/** What shadow maps would show, from their matrices alone: nothing is drawn.

    For each visible point the texel that it falls into is found, and what that texel would hold, by
    tracing the light ray through the texel's centre against the casters. The point is in shadow
    where that is nearer to the light than the point's tangent plane is on the same ray, by more
    than a bias that depends on the scene alone. So the only differences between maps are where
    their texels are and which casters their depth range clips. One nearest tap decides; a point
    outside the map, or with w <= 0, is lit.

    Left out are the rounding of depths to a texture's format, the culling of casters, and the
    smaller mip levels of textures that cut holes.
*/
class MapEmulation {
public:
    /// How much nearer than its receiver a caster must be, as a multiple of the oracle's ray
    /// offset: a two-sided receiver meets its own plane, and the distance to that is known to
    /// offset / 8 / n.l, which is 2.5 offsets at n.l = GrazingCosine.
    static constexpr double BiasInRayOffsets = 4.0;

    /// @param faces of the casters that are drawn into the maps
    MapEmulation(const ShadowOracle& oracle, CasterFaces faces);

    /// Looks from there; what is seen is kept for all lights. Exceptions as ShadowOracle::classify.
    void setView(const OracleView& view);
    /// Lights it so; the truth is kept for all maps. Call setView first. Exceptions as setView.
    void setLight(const OracleLight& light);

    const ShadowTruth& truth() const { return mTruth; }

    /** What the picture would show: a byte per pixel, row 0 at the top, 0 in shadow and 255 lit.
        Pixels that are neither Lit nor Shadowed in truth are 255.
        @param maps of the light; where several serve a point alike, the first counts
    */
    std::vector<std::uint8_t> visibility(std::span<const EmulatedMap> maps);
    /// The same where the maps are read for another view than the one that was set: the points stay,
    /// and their depths are that view's.
    std::vector<std::uint8_t> visibility(std::span<const EmulatedMap> maps,
                                         const OracleView& reader);

    const VisiblePoints& points() const { return mPoints; }

    /// How many pixels are in shadow and in no map: the map that serves them has no texel for them.
    std::size_t shadowedOutside(std::span<const EmulatedMap> maps);

    /// How wrong that is.
    ClassificationError error(std::span<const EmulatedMap> maps);

private:
    /// A pixel that counts.
    struct Receiver {
        std::size_t pixel;
        SurfacePoint point;
    };
    /// The light ray through a texel's centre, as far as a caster on it is drawn.
    struct TexelRay {
        Eigen::Vector3d origin;    ///< near the receiver for which it was made
        Eigen::Vector3d direction; ///< unit vector, away from the light
        double begin;              ///< along the direction, from the origin
        double end;
        double caster; ///< the first caster; infinite without
        double bias;   ///< world units
    };

    std::size_t numberTexels(std::span<const EmulatedMap> maps);
    void findTexels(std::span<const EmulatedMap> maps, const OracleView& reader);
    void shareRays(std::size_t texelCount);
    void traceRays(std::span<const EmulatedMap> maps);
    TexelRay rayThrough(const EmulatedMap& map, std::size_t texel,
                        const Eigen::Vector3d& anchor) const;
    bool inShadow(const Receiver& receiver, const TexelRay& ray) const;

    const ShadowOracle& mOracle;
    CasterFaces mFaces;
    Eigen::Vector3d mCentre = Eigen::Vector3d::Zero(); ///< of the scene's bounding sphere
    double mRadius = 0.0;
    OracleView mView;
    OracleLight mLight;
    VisiblePoints mPoints;
    ShadowTruth mTruth;
    std::vector<Receiver> mReceivers;

    // Scratch of visibility(). Texels of all maps are numbered through.
    std::vector<std::size_t> mFirstTexel;      ///< of each map
    std::vector<std::uint32_t> mTexelOf;       ///< per receiver
    std::vector<std::uint32_t> mRayOfTexel;    ///< per texel
    std::vector<std::uint32_t> mRayOf;         ///< per receiver
    std::vector<std::uint32_t> mReceiverOfRay; ///< the first that needs it
    std::vector<TexelRay> mRays;
};

} // namespace Lixel::Samples
