#pragma once

#include "HardScene.h"

#include <Lixel/setup/ShadowMapObserver.h>

#include <Eigen/Geometry>

#include <vector>

namespace Lixel::Tests {

/// A matrix of floats, as programs get it, and what the positions that it acts on are relative to.
struct DrawnMatrix {
    Eigen::Matrix4d clipFromBase = Eigen::Matrix4d::Zero(); ///< OpenGL clip space
    Eigen::Vector3d wsBase = Eigen::Vector3d::Zero();       ///< world coordinates

    /// The same for positions relative to another point of the world.
    Eigen::Matrix4d relativeTo(const Eigen::Vector3d& wsOrigin) const;
};

/// A caster, and what the map has it drawn with.
struct ProbedCaster {
    /// Infinite where the object has no bounds.
    Eigen::AlignedBox3d wsBox;
    bool drawn = false; ///< the shadow camera does not cull it
    /// World from object in floats, and OpenGL clip space from object as OGRE multiplies it.
    Eigen::Affine3d wsFromObject = Eigen::Affine3d::Identity();
    Eigen::Matrix4d clipFromObject = Eigen::Matrix4d::Zero();
};

/// What a map is drawn and read with.
struct ProbedMap {
    FitReason reason = FitReason::InvalidInput;
    DrawnMatrix receivers;
    std::vector<ProbedCaster> casters;
    /// What positions are relative to in every program, in world coordinates: the viewer with
    /// camera-relative rendering, else the world's origin.
    Eigen::Vector3d wsBase = Eigen::Vector3d::Zero();
    /// Half spaces n . x + d >= 0 as (n, d), relative to wsFitOrigin: what the map serves.
    std::vector<Eigen::Vector4d> wsServed;
    /// Of the light's maps, that whose row times a position relative to wsBase is the greatest
    /// serves it.
    Eigen::RowVector4d wsShare = Eigen::RowVector4d::Zero();
    Eigen::Vector3d wsFitOrigin = Eigen::Vector3d::Zero(); ///< world coordinates
    int width = 0;                                         ///< texels
    int height = 0;                                        ///< texels
};

/// Which of a light's maps (there is at least one) a receiver at that point of the world
/// reads.
std::size_t servingMap(const std::vector<ProbedMap>& maps, const Eigen::Vector3d& ws);

/** Keeps the last maps of a scene's light.

    @param lixel whether the setup is Lixel's, whose receivers are handed their own matrix; those of
    OGRE's setups get OGRE's texture_viewproj_matrix
*/
class MapProbe : private ShadowMapObserver {
public:
    MapProbe(HardScene& scene, bool lixel);
    ~MapProbe() override;
    MapProbe(const MapProbe&) = delete;
    MapProbe& operator=(const MapProbe&) = delete;

    /// Of the last frame, in the order of their textures; none where no setup was asked for any.
    std::vector<ProbedMap> maps;

private:
    void shadowMapFitted(const ShadowMap& fitted) override;

    HardScene& mScene;
    bool mLixel;
};

} // namespace Lixel::Tests
