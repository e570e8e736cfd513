#pragma once

#include "common/ShadowOracle.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace Lixel::Samples {

/** The triangles of a scene, for rays of all kinds. Positions are relative to
    TriangleScene::wsOrigin. All methods are const and may run in parallel.

    Embree calls back at the hits that may not count: of shadow rays at those on triangles with a
    mask alone, so that scenes without masks pay nothing for them.
*/
class EmbreeScene {
public:
    struct Hit {
        std::uint32_t triangle; ///< index into TriangleScene::triangles
        double distance;        ///< world units, in single precision
    };

    /** @param scene with valid indices; it has to outlive this, unchanged
        @exception std::runtime_error when Embree gives no device, or cannot build the scene
    */
    explicit EmbreeScene(const TriangleScene& scene);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// The first triangle that shows a ray its front, or either side where both are drawn.
    std::optional<Hit> firstVisible(const CasterRay& ray) const;

    /// Whether a casting triangle is on the ray.
    bool isBlocked(const CasterRay& ray) const;

    static constexpr std::size_t PacketSize = 8;
    /// ShadowOracle::firstCasters for `count` rays, at most PacketSize.
    void firstCasters(const CasterRay* rays, double* distances, std::size_t count,
                      CasterFaces faces) const;

    /// See ShadowOracle::rayOffset.
    double rayOffset() const { return mRayOffset; }

private:
    /// The triangles of one Embree geometry, by its primitive number.
    struct Group {
        const TriangleScene* scene = nullptr;
        std::vector<std::uint32_t> members;
    };
    struct Filters;
    struct DeviceRelease {
        void operator()(RTCDeviceTy* device) const;
    };
    struct SceneRelease {
        void operator()(RTCSceneTy* scene) const;
    };

    void attach(unsigned group);

    const TriangleScene& mScene;
    /// Embree sees positions relative to this, so that its floats round as little as they can.
    Eigen::Vector3d mCentre = Eigen::Vector3d::Zero();
    double mRayOffset = 0.0; ///< world units
    /// Numbered by whether they cast and whether they are masked.
    std::array<Group, 4> mGroups;
    std::unique_ptr<RTCDeviceTy, DeviceRelease> mDevice;
    std::unique_ptr<RTCSceneTy, SceneRelease> mEmbree;
};

} // namespace Lixel::Samples
