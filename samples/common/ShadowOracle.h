#pragma once

#include "common/Triangles.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace Lixel::Samples {

/// Below this cosine between normal and light a pixel counts as grazing and is reported apart.
constexpr double GrazingCosine = 0.05;

/// What one pixel shows.
enum class PixelClass : std::uint8_t {
    Background,           ///< no triangle
    NotReceiver,          ///< a triangle that receives no shadows
    BeyondShadowDistance, ///< deeper in the view than shadows reach
    Unlit,                ///< n.l <= 0, outside a spot's outer cone, or beyond the light's range
    GrazingLit,           ///< 0 < n.l < GrazingCosine and the light is seen
    GrazingShadowed,      ///< 0 < n.l < GrazingCosine and the light is not seen
    Lit,                  ///< n.l >= GrazingCosine and the light is seen
    Shadowed,             ///< n.l >= GrazingCosine and the light is not seen
};

/// What a viewer sees. Matrices act on column vectors.
struct OracleView {
    /// View space (looking along -z) from positions relative to TriangleScene::wsOrigin.
    Eigen::Matrix4d vsFromWs = Eigen::Matrix4d::Identity();
    /// Clip space in OpenGL's convention: -w <= z <= w. An infinite far plane is fine.
    Eigen::Matrix4d clipFromVs = Eigen::Matrix4d::Identity();
    int width = 0;               ///< pixels
    int height = 0;              ///< pixels
    double shadowDistance = 0.0; ///< largest view-space depth with shadows, world units; 0: any
};

/// A light without extent.
struct OracleLight {
    enum class Kind : std::uint8_t { Directional, Spot, Point };
    Kind kind = Kind::Directional;
    /// Spot and point: relative to TriangleScene::wsOrigin.
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    /// Directional and spot: unit vector along which light travels.
    Eigen::Vector3d direction = -Eigen::Vector3d::UnitY();
    double outerAngle = 0.0; ///< spot: full angle of the outer cone, radians
    /// Spot and point: world units that light reaches.
    double range = std::numeric_limits<double>::infinity();
};

/// A visible point of the scene.
struct SurfacePoint {
    Eigen::Vector3d position; ///< relative to TriangleScene::wsOrigin, on the triangle's plane
    Eigen::Vector3d normal;   ///< geometric normal of unit length, turned towards the viewer
    std::uint32_t triangle;   ///< index into TriangleScene::triangles
};

/// A value per pixel, row 0 at the top of the picture, sampled at pixel centres.
template <typename T>
struct Raster {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;
    const T& at(int column, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};
using ShadowTruth = Raster<PixelClass>;
/// What each pixel shows, if anything.
using VisiblePoints = Raster<std::optional<SurfacePoint>>;

/// Which faces of solid bodies are drawn; of triangles with Triangle::drawnFromBack both are.
enum class CasterFaces : std::uint8_t { Fronts, Backs };

/// A piece of a ray on which a triangle is looked for.
struct CasterRay {
    Eigen::Vector3d origin;    ///< relative to TriangleScene::wsOrigin
    Eigen::Vector3d direction; ///< unit vector
    double length;             ///< world units; nothing is met where it is not above 0
};

/** Exact hard shadows, by tracing rays against the scene's own triangles.

    A viewer sees only the fronts of triangles, as OGRE's culling draws them (both sides where
    Triangle::drawnFromBack); between the near and the far plane. Light is blocked by both sides of
    casting triangles, at any distance. Rays of all kinds go through the holes of masks, which are
    found where the ray meets the triangle: alpha is not averaged over a pixel or a map's texel. All
    methods are const and may run in parallel.
*/
class ShadowOracle {
public:
    /** Copies the scene.
        @exception std::invalid_argument for an index beyond the vertices or the masks, a position
        that is not finite, a mask without an alpha per texel, or a masked triangle without finite
        texture coordinates; std::runtime_error when Embree gives no device.
    */
    explicit ShadowOracle(TriangleScene scene);
    ~ShadowOracle();
    ShadowOracle(ShadowOracle&&) noexcept;
    ShadowOracle& operator=(ShadowOracle&&) noexcept;

    const TriangleScene& scene() const;

    /** The class of every pixel, on all processors.
        @exception std::invalid_argument for a size below 1 x 1, matrices that cannot be inverted or
        are not finite, or a directional or spot light without a direction.
    */
    ShadowTruth classify(const OracleView& view, const OracleLight& light) const;

    /// The same for points that are known already: visiblePoints(view).
    ShadowTruth classify(const VisiblePoints& points, const OracleView& view,
                         const OracleLight& light) const;

    /// What every pixel shows. Exceptions as classify.
    VisiblePoints visiblePoints(const OracleView& view) const;

    /// The class of one visible point; of the view only its depth and shadow distance matter.
    PixelClass classifyPoint(const SurfacePoint& point, const OracleView& view,
                             const OracleLight& light) const;

    /// Whether a casting triangle lies between the point and the light.
    bool occluded(const SurfacePoint& point, const OracleLight& light) const;

    /** How far along each ray the first casting triangle is that shows it one of these faces.

        On the calling thread; fastest where neighbouring rays are near one another.
        @param[out] distances world units, as many as rays; infinite where there is none
        @exception std::invalid_argument unless there are as many distances as rays
    */
    void firstCasters(std::span<const CasterRay> rays, CasterFaces faces,
                      std::span<double> distances) const;

    /// How far in front of its surface a shadow ray starts, in world units: what Embree's floats
    /// may be wrong by in this scene, eight times over.
    double rayOffset() const;

private:
    struct Impl;
    std::unique_ptr<Impl> mImpl;
};

} // namespace Lixel::Samples
