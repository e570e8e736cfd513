#pragma once

#include "common/Triangles.h"

#include <Lixel/scene/MeshBuffers.h>

#include <Ogre.h>

#include <map>
#include <optional>

namespace Lixel::Samples {

/// Triangles that are drawn with one material, as the buffers have them.
struct DrawnPart {
    std::vector<Vec3> positions;
    std::vector<Eigen::Vector2f> uvs; ///< none where nothing is cut
    std::vector<TriangleCorners> corners;
    Triangle flags;                ///< of every triangle
    bool frontIsClockwise = false; ///< the material culls the other side
};

/// Reads what OGRE draws, and adds it to a scene.
class TriangleCollector {
public:
    /// @param flipsMirrored SceneManager::getFlipCullingOnNegativeScale
    TriangleCollector(TriangleScene& scene, bool flipsMirrored)
        : mScene(scene), mFlipsMirrored(flipsMirrored) {}

    /** Reads the triangles of a part of an object.
        @param operation its vertices are blended, and not yet transformed to where they are drawn
        @param copies how often the buffers hold the part; the first is read
        @exception Ogre::InvalidParametersException as collectTriangles
    */
    DrawnPart read(const Ogre::MovableObject& object, const Ogre::MaterialPtr& material,
                   const Ogre::RenderOperation& operation, std::size_t copies = 1);

    /** Adds a part that was read.
        @param mirrored whether OGRE turns its culling around
    */
    void add(const DrawnPart& part, const Ogre::Matrix4& wsFromObject, bool mirrored);

    /// Whether OGRE takes a renderable for mirrored, by the first of its world matrices.
    static bool isMirrored(const Ogre::Renderable& renderable);

private:
    /// A material's holes in TriangleScene::masks.
    struct KnownHoles {
        std::uint32_t mask;
        unsigned uvSet;
        Eigen::Affine3f uvFromMesh;
    };
    const std::optional<KnownHoles>& holesOf(const Ogre::MaterialPtr& material);

    TriangleScene& mScene;
    bool mFlipsMirrored;
    std::map<const Ogre::Material*, std::optional<KnownHoles>> mHoles;
};

} // namespace Lixel::Samples
