#pragma once

#include "fit/geometry/BodyHull.h"
#include "fit/geometry/SurfaceCloud.h"
#include "scene/MeshReading.h"

#include <OgreAxisAlignedBox.h>
// OgrePrerequisites.h of 1.12 declares MeshPtr and needs it.
#include <OgreSharedPtr.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace Ogre {
class Entity;
class Mesh;
class MovableObject;
} // namespace Ogre

namespace Lixel {

/// What a mesh is made of, in its own space.
struct KnownParts {
    const SurfaceCloud* cloud = nullptr;
    /// Each triangle is in one of them.
    std::span<const Eigen::AlignedBox3f> bounds;
};

/** The shapes of meshes, as few discs of their surface and as a convex hull, and whether they are
    convex themselves; where that is asked for, as the bounds of their parts and as more discs too.
    They are read once from their buffers, and kept.

    Buffers are read when a shape is first asked for, within what a frame has of time for it: a
    large mesh takes several frames, and until then its box has to do. `prepare` reads all at once.

    A mesh that is loaded anew, or gets other bounds, is read anew. One whose bounds change again
    and again has no hull, until it is prepared. One whose buffers an application rewrites in place
    otherwise keeps its first shape.

    A shape is null for meshes that move their vertices (skeletons, morphs, poses), for meshes
    without readable triangles, and for meshes that are not read yet. Other pointers stay valid
    until the mesh is destroyed or read anew.
*/
class LIXEL_API MeshShapes {
public:
    /// Discs of each cloud: a wall of a room has a dozen and more.
    static constexpr std::size_t Discs = 128;

    /// Microseconds to read meshes in, each frame: 3 % of a frame of 60 a second. Half of 1 ms,
    /// which nobody notices, so that it holds on processors half as fast as the one that costs were
    /// measured on (MeshReading.cpp).
    static constexpr double DefaultFrameTime = 500.0;

    /// Those of the process, which all scene managers share.
    static MeshShapes& shared();

    /// @param microseconds for each frame to read meshes in; 0 for none, infinity for all at once
    void setFrameTime(double microseconds) { mFrameTime = microseconds; }
    double frameTime() const { return mFrameTime; }

    /** A viewer's picture begins: once a frame there is time to read meshes again.

        Every so many pictures too, for applications that update their render targets by themselves,
        and count no frames.
        @param frame number of the frame that it belongs to */
    void beginPicture(unsigned long frame);

    /// A mesh of fewer parts than this is known as well by its hull.
    static constexpr std::size_t LeastParts = 64;

    /// Reads all that may ever be asked of a mesh, at once. @param parts as of partsOf; 0 for none
    void prepare(const Ogre::MeshPtr& mesh, std::size_t parts = 0);

    /// The surface of an entity, in its own space.
    const SurfaceCloud* cloudOf(const Ogre::Entity& entity);

    /** A hull of an entity, in its own space.
        @return null too where its vertices may go beyond it: with manual levels of detail, buffers
        that are not static, bounds that are given larger than the vertices have it, and vertex
        programs of others than Lixel and OGRE's shader generator, which may move them */
    const BodyHull* hullOf(const Ogre::Entity& entity);

    /** The parts of an entity whose hull is known, in its own space, and as many discs: both
        together take 80 bytes a part.
        @param most parts, and discs; where others ask for more of the mesh, they all get those
        @return nothing too where triangles may be others, with levels of detail; for what is known
        to shadow nothing of itself whatever the light; and for meshes of fewer than LeastParts
        parts */
    std::optional<KnownParts> partsOf(const Ogre::Entity& entity, std::size_t most);

    /** Whether an entity is known to shadow nothing of itself: @see BodyShapes::isSelfShadowFree

        It is where its hull is known, and it is a flat sheet, or the closed surface of few
        triangles of a convex body, or a relief, whose materials draw the outside alone. Neither
        levels of detail nor a scene manager that darkens shadows, whichever side of a surface they
        are on, may be in play: that is, OGRE's modulative shadows without shaders.
        @param[out] body where the answer is true: the entity in its own space; where it is in the
        world is not set */
    bool isSelfShadowFree(const Ogre::Entity& entity, SelfShadowFree& body);

    /// A number that changes whenever answers may be others the next time, although no entity
    /// changes: a reading was left for another frame, or a mesh was prepared.
    std::uint64_t unrest() const { return mUnrest; }

    /// Bytes that were read from buffers so far, for statistics.
    std::size_t bytesRead() const { return mBytesRead; }

private:
    struct Entry {
        std::weak_ptr<Ogre::Mesh> mesh;
        std::size_t state = 0; ///< how often the mesh had been loaded
        Ogre::AxisAlignedBox bounds;
        /// How often it has got others.
        unsigned boundsChanges = 0;
        HullReading hull;
        CloudReading cloud{Discs};
        ConvexReading convex;
        /// None before it is asked for.
        std::unique_ptr<CloudReading> parts;

        CloudReading& partsReading(std::size_t most);
        /// Its shape is not worth reading any more.
        bool isRestless() const;
        void readAnew();
    };

    /// Whether an entity of that hull is known to shadow nothing of itself, whatever the light.
    bool isConvex(const Ogre::Entity& entity, const BodyHull& hull);
    /// Null where vertices move.
    Entry* find(const Ogre::Entity& entity);
    Entry& find(const Ogre::MeshPtr& mesh);
    /// Reads on, for as long as this frame has time.
    void advance(MeshReading& reading, const Ogre::Mesh& mesh);
    void advance(MeshReading& reading, const Ogre::Mesh& mesh, ReadingAllowance& allowance);

    std::map<const Ogre::Mesh*, Entry> mEntries;
    /// There were as many when those of meshes that have gone were last looked for.
    std::size_t mSwept = 0;
    double mFrameTime = DefaultFrameTime;
    /// What is left of it: for all meshes, and for those that take several frames.
    double mTimeLeft = DefaultFrameTime;
    double mTimeLeftForLarge = LargeShare * DefaultFrameTime;
    unsigned long mFrame = ~0UL; // none yet
    unsigned mPictures = 0;
    std::size_t mBytesRead = 0;
    std::uint64_t mUnrest = 0;

    /// Of a frame's time, for meshes that take several frames. The rest is for small ones, which
    /// are there at once.
    static constexpr double LargeShare = 0.75;
};

/// The hulls of a set's bodies, where these are entities that fill their world boxes badly, and
/// which entities shadow nothing of themselves.
class LIXEL_API ObjectShapes final : public BodyShapes {
public:
    /// @param meshes must outlive what follows
    void reset(MeshShapes& meshes, const Vec3& wsOrigin);
    /// Adds what the next box of the set is of; it must be there until the next reset.
    void add(const Ogre::MovableObject& object) { mObjects.push_back(&object); }
    /// The next box is of a part of an object: it has no other shape than that.
    void addPart(const Ogre::MovableObject& whole);
    /// What was added, null for parts.
    std::span<const Ogre::MovableObject* const> objects() const { return mObjects; }

    const BodyHull* hullOf(std::size_t index, Transform3& wsFromBody) const noexcept override;
    /// The object, of parts too.
    const void* identityOf(std::size_t index) const noexcept override;
    bool isSelfShadowFree(std::size_t index, SelfShadowFree& body) const noexcept override;

private:
    MeshShapes* mMeshes = nullptr;
    Vec3 mWsOrigin = Vec3::Zero();
    std::vector<const Ogre::MovableObject*> mObjects;
    /// Boxes in a row that are parts of one object.
    struct PartRun {
        std::size_t end;
        const Ogre::MovableObject* whole;
    };
    std::vector<PartRun> mPartRuns;
};

} // namespace Lixel
