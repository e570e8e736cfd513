#include "scene/MeshReading.h"

#include "fit/geometry/ConvexSurface.h"
#include "scene/MeshBuffers.h"
#include "scene/OgreMath.h"

#include <OgreHardwareIndexBuffer.h>
#include <OgreHardwareVertexBuffer.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSubMesh.h>
#include <OgreVertexIndexData.h>

#include <algorithm>

namespace Lixel {
namespace {

// What parts of reading take, in microseconds: what lixel-bench-shapes measures, and half as much
// again for cold caches.

/// A byte of a buffer, from a shadow copy or Mesa's memory.
constexpr double ByteTime = 0.0002;
/// A position, taken out of what was read.
constexpr double PositionTime = 0.004;
/// A position, added to a hull or copied to where triangles find it.
constexpr double HullTime = 0.012;
constexpr double CopyTime = 0.004;
/// A triangle, each time that it is looked at.
constexpr double TriangleTime = 0.030;
/// A triangle that is given to a part, and one that may be of a relief.
constexpr double PartTime = 0.060;
constexpr double ReliefTime = 0.055;
/// A whole hull, of what is known of its points; a cloud's discs.
constexpr double BuildTime = 6.0;
constexpr double DiscsTime = 6.0;
/// A position, compared with a triangle's plane.
constexpr double PairTime = 0.0015;
/// A piece of memory that is given back.
constexpr double FreeTime = 10.0;

/// Vertices that are read at once, at most, and triangles: enough for the call to cost little
/// beside, and few enough for fast memory.
constexpr std::size_t MostVertices = 8192;
constexpr std::size_t BlockSize = 2048;
/// Positions to a piece of memory.
constexpr std::size_t PieceSize = 8192;

/// Bounds beyond those of the vertices, relative to the longest side, that are rounding: in files
/// they are kept as floats, or as decimals.
constexpr double BoundsRounding = 1e-3;

const Ogre::HardwareVertexBuffer* positionBuffer(const Ogre::VertexData& data) {
    const Ogre::VertexElement* const element =
        data.vertexDeclaration->findElementBySemantic(Ogre::VES_POSITION);
    if (element == nullptr || !data.vertexBufferBinding->isBufferBound(element->getSource()))
        return nullptr;
    return data.vertexBufferBinding->getBuffer(element->getSource()).get();
}

bool isFixed(const Ogre::VertexData& data) {
    return isStaticBuffer(positionBuffer(data));
}

/// Whether the hull reaches as far as a mesh's bounds, without the margin that OGRE adds to these.
bool fills(const BodyHull& hull, const Ogre::AxisAlignedBox& bounds) {
    if (hull.empty() || !bounds.isFinite()) return false;
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : hull.vertices)
        box.extend(vertex);
    // Padded when it was made, and once more when it was loaded.
    const double padding =
        2.0 * static_cast<double>(Ogre::MeshManager::getSingleton().getBoundsPaddingFactor());
    const Vec3 slack =
        padding * box.sizes() + Vec3::Constant(BoundsRounding * box.sizes().maxCoeff());
    const Eigen::AlignedBox3d padded(box.min() - slack, box.max() + slack);
    return padded.contains(toDouble(bounds.getMinimum())) &&
           padded.contains(toDouble(bounds.getMaximum()));
}

/// Bytes of indices that a triangle takes, at most.
std::size_t triangleBytes(const Ogre::RenderOperation& operation) {
    return operation.useIndexes ? 3 * sizeof(std::uint32_t) : 0;
}

double timeForTriangles(const Ogre::RenderOperation& operation, std::size_t count) {
    return static_cast<double>(count) *
           (static_cast<double>(triangleBytes(operation)) * ByteTime + TriangleTime);
}

} // namespace

bool MeshReading::Part::operator==(const Part& other) const {
    return operation.operationType == other.operation.operationType &&
           operation.useIndexes == other.operation.useIndexes && triangles == other.triangles &&
           sharesVertices == other.sharesVertices && vertexBuffer == other.vertexBuffer &&
           indexBuffer == other.indexBuffer && vertexStart == other.vertexStart &&
           vertexCount == other.vertexCount && vertexSize == other.vertexSize &&
           indexStart == other.indexStart;
}

bool MeshReading::Part::isLocked() const {
    const Ogre::HardwareVertexBuffer* const vertices = positionBuffer(*operation.vertexData);
    if (vertices != nullptr && vertices->isLocked()) return true;
    return operation.useIndexes && operation.indexData->indexBuffer &&
           operation.indexData->indexBuffer->isLocked();
}

MeshReading::Parts MeshReading::partsOf(const Ogre::Mesh& mesh) {
    Parts parts;
    for (Ogre::SubMesh* submesh : mesh.getSubMeshes()) {
        Part part;
        submesh->_getRenderOperation(part.operation);
        const Ogre::VertexData* const vertices = part.operation.vertexData;
        if (vertices == nullptr || vertices->vertexCount == 0) continue;
        // Parts that share their vertices follow each other, as a rule.
        part.sharesVertices = !parts.empty() && parts.back().operation.vertexData == vertices;
        part.triangles = countTriangles(part.operation);
        part.vertexStart = vertices->vertexStart;
        part.vertexCount = vertices->vertexCount;
        if (const Ogre::HardwareVertexBuffer* const buffer = positionBuffer(*vertices)) {
            part.vertexBuffer = buffer;
            part.vertexSize = buffer->getVertexSize();
        }
        if (part.operation.useIndexes) {
            part.indexBuffer = part.operation.indexData->indexBuffer.get();
            part.indexStart = part.operation.indexData->indexStart;
        }
        parts.push_back(part);
    }
    return parts;
}

void MeshReading::advance(const Ogre::Mesh& mesh, ReadingAllowance& allowance) noexcept {
    if (mDone) return;
    try {
        Parts parts = partsOf(mesh);
        if (std::ranges::any_of(parts, [](const Part& part) { return part.isLocked(); })) return;
        if (parts != mParts) {
            mPart = 0;
            mNext = 0;
            mSpent = 0.0;
            restart();
        }
        mParts = std::move(parts);
        const double before = allowance.spent();
        mDone = read(mesh, mParts, allowance);
        mSpent += allowance.spent() - before;
    } catch (const std::exception&) {
        restart();
        mDone = true;
    }
    if (mDone) {
        mParts = {};
        mPositions = {};
    }
}

double MeshReading::timeLeft(const Ogre::Mesh& mesh) const {
    return timeFor(partsOf(mesh)) - mSpent;
}

bool MeshReading::readVertices(const Part& part, double each, ReadingAllowance& allowance) {
    const double bytes = static_cast<double>(part.vertexSize) * ByteTime;
    const std::size_t count = allowance.take(std::min(part.vertexCount - mNext, MostVertices),
                                             bytes + PositionTime + each);
    if (count == 0) return false;
    Lixel::readPositions(*part.operation.vertexData, mNext, count, mPositions);
    mBytesRead += count * part.vertexSize;
    mNext += count;
    return true;
}

double MeshReading::timeForVertices(const Part& part, double each) {
    if (part.sharesVertices) return 0.0;
    return static_cast<double>(part.vertexCount) *
           (static_cast<double>(part.vertexSize) * ByteTime + PositionTime + each);
}

void HullReading::restart() {
    mBuilder = {};
    mHull = {};
}

double HullReading::timeFor(const Parts& parts) const {
    double time = BuildTime;
    for (const Part& part : parts)
        time += timeForVertices(part, HullTime);
    return time;
}

bool HullReading::read(const Ogre::Mesh& mesh, const Parts& parts, ReadingAllowance& allowance) {
    for (const Part& part : parts)
        if (!isFixed(*part.operation.vertexData)) return true;
    for (; mPart < parts.size(); ++mPart, mNext = 0) {
        const Part& part = parts[mPart];
        while (!part.sharesVertices && mNext < part.vertexCount) {
            if (!readVertices(part, HullTime, allowance)) return false;
            mBuilder.add(mPositions);
        }
    }
    if (allowance.take(1, BuildTime) == 0) return false;
    mHull = mBuilder.build();
    if (!fills(mHull, mesh.getBounds())) mHull = {};
    return true;
}

void ConvexReading::restart() {
    mConvex = false;
}

std::size_t ConvexReading::pairsOf(const Parts& parts) {
    std::size_t positions = 0;
    std::size_t triangles = 0;
    for (const Part& part : parts) {
        if (part.triangles == 0) return 0;
        if (!part.sharesVertices) positions += part.vertexCount;
        triangles += part.triangles;
    }
    // So many triangles alone would make their product too large for a number.
    if (std::max(positions, triangles) > MostPairs) return 0;
    // Positions are compared with triangles, and with each other.
    const std::size_t pairs = positions * std::max(positions, triangles);
    return pairs <= MostPairs ? pairs : 0;
}

double ConvexReading::timeFor(const Parts& parts) const {
    return static_cast<double>(pairsOf(parts)) * PairTime;
}

bool ConvexReading::read(const Ogre::Mesh&, const Parts& parts, ReadingAllowance& allowance) {
    if (pairsOf(parts) == 0) return true;
    if (allowance.take(1, timeFor(parts)) == 0) return false;
    std::vector<Vec3> positions;
    std::vector<TriangleCorners> triangles;
    std::uint32_t first = 0;
    for (const Part& part : parts) {
        if (!part.sharesVertices) {
            first = static_cast<std::uint32_t>(positions.size());
            Lixel::readPositions(*part.operation.vertexData, 0, part.vertexCount, mPositions);
            positions.insert(positions.end(), mPositions.begin(), mPositions.end());
        }
        const std::vector<TriangleCorners> own = Lixel::readTriangles(part.operation);
        for (const auto& [a, b, c] : own) {
            // An index beyond the vertices must not become another part's vertex.
            if (std::max({a, b, c}) >= part.vertexCount) return true;
            triangles.push_back({first + a, first + b, first + c});
        }
        mBytesRead += triangleBytes(part.operation) * part.triangles;
        if (!part.sharesVertices) mBytesRead += part.vertexCount * part.vertexSize;
    }
    mConvex = isConvexSurface(positions, triangles);
    return true;
}

void CloudReading::restart() {
    mStage = Stage::Positions;
    mPieces.clear();
    mCount = 0;
    mFirst.clear();
    mSums.clear();
    mBlock = 0;
    mBuilder = SurfaceCloudBuilder(mDiscs);
    mCloud = {};
    mBounds.setEmpty();
    mParts = {};
    mHasOthers = false;
    mRelief.reset();
}

double CloudReading::timeFor(const Parts& parts) const {
    double time = DiscsTime;
    for (const Part& part : parts) {
        time += timeForVertices(part, CopyTime + FreeTime / PieceSize);
        // Once to measure all, and once more the blocks in which there is a disc.
        const std::size_t again = std::min(part.triangles, mDiscs * BlockSize);
        time += timeForTriangles(part.operation, part.triangles + again);
        if (mReliefBuilder.mayBe()) time += ReliefTime * static_cast<double>(part.triangles);
        if (mMostParts > 0) time += PartTime * static_cast<double>(part.triangles);
    }
    return time;
}

void CloudReading::begin(Stage stage) {
    mStage = stage;
    mPart = 0;
    mNext = 0;
    mBlock = 0;
}

bool CloudReading::read(const Ogre::Mesh&, const Parts& parts, ReadingAllowance& allowance) {
    if (mStage == Stage::Positions) {
        if (!readPositions(parts, allowance)) return false;
        begin(Stage::Measure);
        mPartsBuilder.reset(mBounds);
        mReliefBuilder.reset(mBounds);
        mHasOthers =
            std::ranges::any_of(parts, [](const Part& part) { return part.triangles == 0; });
    }
    if (mStage == Stage::Measure) {
        if (!readTriangles(parts, allowance)) return false;
        begin(Stage::Spread);
    }
    if (mStage == Stage::Spread) {
        if (!readTriangles(parts, allowance) || allowance.take(1, DiscsTime) == 0) return false;
        begin(Stage::Free);
        mTriangles = {};
    }
    for (; !mPieces.empty(); mPieces.pop_back())
        if (allowance.take(1, FreeTime) == 0) return false;
    mFirst = {};
    mSums = {};
    mCloud = mBuilder.cloud();
    mBuilder = SurfaceCloudBuilder(mDiscs);
    mParts = mPartsBuilder.parts();
    mPartsBuilder = MeshPartsBuilder(mMostParts);
    if (!mHasOthers) mRelief = mReliefBuilder.relief();
    mReliefBuilder = {};
    return true;
}

bool CloudReading::readPositions(const Parts& parts, ReadingAllowance& allowance) {
    for (; mPart < parts.size(); ++mPart, mNext = 0) {
        const Part& part = parts[mPart];
        if (mFirst.size() == mPart) mFirst.push_back(part.sharesVertices ? mFirst.back() : mCount);
        while (!part.sharesVertices && mNext < part.vertexCount) {
            if (!readVertices(part, CopyTime, allowance)) return false;
            for (const Vec3& position : mPositions) {
                if (mCount % PieceSize == 0)
                    mPieces.push_back(std::make_unique_for_overwrite<Eigen::Vector3f[]>(PieceSize));
                mPieces.back()[mCount % PieceSize] = position.cast<float>();
                ++mCount;
                mBounds.extend(position);
            }
        }
    }
    return true;
}

bool CloudReading::readTriangles(const Parts& parts, ReadingAllowance& allowance) {
    for (; mPart < parts.size(); ++mPart, mNext = 0) {
        const Part& part = parts[mPart];
        while (mNext < part.triangles) {
            const std::size_t count = std::min(part.triangles - mNext, BlockSize);
            if (mStage == Stage::Measure || !mBuilder.skip(mSums[mBlock])) {
                double time = timeForTriangles(part.operation, count);
                if (mStage == Stage::Measure)
                    time += ((mReliefBuilder.mayBe() ? ReliefTime : 0.0) +
                             (mMostParts > 0 ? PartTime : 0.0)) *
                            static_cast<double>(count);
                if (allowance.take(1, time) == 0) return false;
                Lixel::readTriangles(part.operation, mNext, count, mTriangles);
                mBytesRead += triangleBytes(part.operation) * count;
                use(part);
            }
            if (mStage == Stage::Measure) mSums.push_back(mBuilder.measured());
            mNext += count;
            ++mBlock;
        }
    }
    return true;
}

void CloudReading::use(const Part& part) {
    const std::size_t first = mFirst[mPart];
    for (const auto& corners : mTriangles) {
        // An index beyond the vertices must not become another part's vertex.
        if (std::max({corners[0], corners[1], corners[2]}) >= part.vertexCount) {
            mHasOthers = true;
            continue;
        }
        const Vec3 a = position(first + corners[0]);
        const Vec3 b = position(first + corners[1]);
        const Vec3 c = position(first + corners[2]);
        if (mStage == Stage::Spread) {
            mBuilder.spread(a, b, c);
            continue;
        }
        mBuilder.measure(a, b, c);
        mReliefBuilder.add(a, b, c);
        if (mMostParts > 0) mPartsBuilder.add(a, b, c);
    }
}

Vec3 CloudReading::position(std::size_t index) const {
    return mPieces[index / PieceSize][index % PieceSize].cast<double>();
}

} // namespace Lixel
