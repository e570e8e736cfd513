#pragma once

#include "fit/geometry/BodyHull.h"
#include "fit/geometry/MeshParts.h"
#include "fit/geometry/Relief.h"
#include "fit/geometry/SurfaceCloud.h"
#include "scene/ReadingAllowance.h"

#include <OgreRenderOperation.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace Ogre {
class Mesh;
} // namespace Ogre

namespace Lixel {

/** Reads something of a mesh from its buffers, a part at a time.

    No mesh data is held between two calls. Each call compares the mesh's buffers with those of the
    call before. If they differ, reading starts anew.
*/
class MeshReading {
public:
    virtual ~MeshReading() = default;

    /** Reads on, for as long as the allowance lasts.

        Does nothing while a buffer is locked. Finds nothing, for good, where positions are not
        floats, which OGRE logs, or memory is short. */
    void advance(const Ogre::Mesh& mesh, ReadingAllowance& allowance) noexcept;
    bool isDone() const { return mDone; }
    /// What is left of the time to read this mesh, in microseconds.
    double timeLeft(const Ogre::Mesh& mesh) const;
    /// All that was read from buffers so far.
    std::size_t bytesRead() const { return mBytesRead; }

protected:
    /// A submesh that has vertices, and what there is in its buffers' place.
    struct Part {
        Ogre::RenderOperation operation;
        std::size_t triangles = 0;
        /// Whether its vertices are those of the part before.
        bool sharesVertices = false;
        // To find out whether it is another: never followed.
        const void* vertexBuffer = nullptr;
        const void* indexBuffer = nullptr;
        std::size_t vertexStart = 0;
        std::size_t vertexCount = 0;
        std::size_t vertexSize = 0;
        std::size_t indexStart = 0;

        bool operator==(const Part& other) const;
        bool isLocked() const;
    };
    using Parts = std::vector<Part>;

    virtual void restart() = 0;
    /// @return whether all is read
    virtual bool read(const Ogre::Mesh& mesh, const Parts& parts, ReadingAllowance& allowance) = 0;
    virtual double timeFor(const Parts& parts) const = 0;

    /// Reads the next vertices of a part into mPositions.
    /// @param each microseconds that one vertex costs, in addition to reading it
    /// @return false when the allowance is used up
    bool readVertices(const Part& part, double each, ReadingAllowance& allowance);
    static double timeForVertices(const Part& part, double each);

    std::size_t mPart = 0;
    /// In the part.
    std::size_t mNext = 0;
    std::vector<Vec3> mPositions;
    std::size_t mBytesRead = 0;

private:
    static Parts partsOf(const Ogre::Mesh& mesh);

    Parts mParts;
    double mSpent = 0.0;
    bool mDone = false;
};

/// The hull of all vertices; empty where one of them may not stay where it is.
class HullReading final : public MeshReading {
public:
    const BodyHull& hull() const { return mHull; }

private:
    void restart() override;
    bool read(const Ogre::Mesh& mesh, const Parts& parts, ReadingAllowance& allowance) override;
    double timeFor(const Parts& parts) const override;

    BodyHullBuilder mBuilder;
    BodyHull mHull;
};

/** Whether the triangles are the closed surface of a convex body.

    A mesh of many triangles, or of lines or points, is not looked at, and taken for none. */
class ConvexReading final : public MeshReading {
public:
    bool isConvex() const { return mConvex; }

private:
    /// Positions times triangles, at most: a sphere of 18 rings and segments.
    static constexpr std::size_t MostPairs = std::size_t{1} << 18;

    void restart() override;
    bool read(const Ogre::Mesh& mesh, const Parts& parts, ReadingAllowance& allowance) override;
    double timeFor(const Parts& parts) const override;
    static std::size_t pairsOf(const Parts& parts);

    bool mConvex = false;
};

/// The surface of all triangles, whether it is a relief, and the bounds of parts of them. Keeps a
/// copy of all positions until it is done.
class CloudReading final : public MeshReading {
public:
    /// @param discs of the cloud
    /// @param parts at most, @see MeshPartsBuilder; 0 for none
    explicit CloudReading(std::size_t discs, std::size_t parts = 0)
        : mDiscs(discs), mMostParts(parts), mBuilder(discs), mPartsBuilder(parts) {}

    const SurfaceCloud& cloud() const { return mCloud; }
    /// In the mesh's space; every triangle is in one of them.
    std::span<const Eigen::AlignedBox3f> parts() const { return mParts; }
    std::size_t mostParts() const { return mMostParts; }
    /// None before all is read, and of lines and points.
    const std::optional<Relief>& relief() const { return mRelief; }

private:
    enum class Stage { Positions, Measure, Spread, Free };

    void restart() override;
    bool read(const Ogre::Mesh& mesh, const Parts& parts, ReadingAllowance& allowance) override;
    double timeFor(const Parts& parts) const override;
    bool readPositions(const Parts& parts, ReadingAllowance& allowance);
    bool readTriangles(const Parts& parts, ReadingAllowance& allowance);
    void use(const Part& part);
    void begin(Stage stage);
    Vec3 position(std::size_t index) const;

    std::size_t mDiscs = 0;
    std::size_t mMostParts = 0;
    Stage mStage = Stage::Positions;
    /// Positions of all parts, in pieces: to give back all memory at once would take too long.
    std::vector<std::unique_ptr<Eigen::Vector3f[]>> mPieces;
    std::size_t mCount = 0;
    /// Of each part, among all positions.
    std::vector<std::size_t> mFirst;
    std::vector<std::array<std::uint32_t, 3>> mTriangles;
    /// What was measured after each block of triangles: most need not be read once more.
    std::vector<double> mSums;
    std::size_t mBlock = 0;
    SurfaceCloudBuilder mBuilder;
    SurfaceCloud mCloud;
    Eigen::AlignedBox3d mBounds;
    MeshPartsBuilder mPartsBuilder;
    std::vector<Eigen::AlignedBox3f> mParts;
    ReliefBuilder mReliefBuilder;
    /// Whether there are lines, points, or triangles of vertices that there are not.
    bool mHasOthers = false;
    std::optional<Relief> mRelief;
};

} // namespace Lixel
