#include "scene/MeshShapes.h"

#include "scene/CasterPass.h"
#include "scene/OgreMath.h"

#include <OgreEntity.h>
#include <OgreMesh.h>
#include <OgrePass.h>
#include <OgreSceneManager.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <algorithm>
#include <limits>

namespace Lixel {
namespace {

/// A box of so many times the hull's volume is as good: the padding of a mesh's bounds alone makes
/// 1.06 of it. When a body turns, this is also what its map may change by at once.
constexpr double LooseBox = 1.1;

/// As many pictures without another frame are as good as a frame: applications that count frames
/// hardly have as many viewports with shadows.
constexpr unsigned PicturesOfAFrame = 32;

/// A mesh that gets other bounds more often than this is one that changes all the time.
constexpr unsigned MostBoundsChanges = 8;

/// The scheme of OGRE's shader system, whose vertex programs do nothing except transform either.
const Ogre::String ShaderGenerator = "ShaderGeneratorDefaultScheme";

/// Whether a vertex program may move vertices elsewhere than their node has them.
bool mayMoveVertices(const Ogre::Entity& entity) {
    for (const Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material) continue;
        for (const Ogre::Technique* technique : material->getTechniques()) {
            if (technique->getSchemeName() == ShaderGenerator) continue;
            for (const Ogre::Pass* pass : technique->getPasses())
                if (pass->hasVertexProgram() && !isOwnProgram(pass->getVertexProgramName()))
                    return true;
        }
    }
    return false;
}

/// Whether its materials draw nothing of it that faces away from the viewer.
bool drawsFrontsOnly(const Ogre::Entity& entity) {
    for (const Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material) return false;
        for (const Ogre::Technique* technique : material->getTechniques())
            for (const Ogre::Pass* pass : technique->getPasses())
                if (pass->getCullingMode() != Ogre::CULL_CLOCKWISE) return false;
    }
    return true;
}

/// Whether it shows the outside of its mesh alone, whatever its distance.
bool showsOutsideAlone(const Ogre::Entity& entity) {
    return entity.getMesh()->getNumLodLevels() <= 1 && drawsFrontsOnly(entity);
}

/// Whether the scene manager darkens what is in shadow, lit or not, by passes of its own.
bool darkensWhatIsUnlit(const Ogre::SceneManager* sceneManager) {
    return sceneManager == nullptr || (sceneManager->isShadowTechniqueModulative() &&
                                       !sceneManager->isShadowTechniqueIntegrated());
}

/// An entity's hull, for callers that must not throw.
const BodyHull* hullOrNone(MeshShapes& meshes, const Ogre::Entity& entity) noexcept {
    try {
        return meshes.hullOf(entity);
    } catch (const std::exception&) {
        return nullptr;
    }
}

} // namespace

bool MeshShapes::Entry::isRestless() const {
    return boundsChanges > MostBoundsChanges;
}

void MeshShapes::Entry::readAnew() {
    hull = {};
    cloud = CloudReading(Discs);
    convex = {};
    parts.reset();
}

CloudReading& MeshShapes::Entry::partsReading(std::size_t most) {
    if (!parts || parts->mostParts() < most) parts = std::make_unique<CloudReading>(most, most);
    return *parts;
}

MeshShapes& MeshShapes::shared() {
    static MeshShapes shapes;
    return shapes;
}

void MeshShapes::beginPicture(unsigned long frame) {
    if (frame == mFrame && ++mPictures < PicturesOfAFrame) return;
    mFrame = frame;
    mPictures = 0;
    mTimeLeft = mFrameTime;
    mTimeLeftForLarge = LargeShare * mFrameTime;
}

MeshShapes::Entry* MeshShapes::find(const Ogre::Entity& entity) {
    if (entity.hasSkeleton() || entity.hasVertexAnimation()) return nullptr;
    return entity.getMesh()->isLoaded() ? &find(entity.getMesh()) : nullptr;
}

MeshShapes::Entry& MeshShapes::find(const Ogre::MeshPtr& mesh) {
    const auto found = mEntries.find(mesh.get());
    // Another mesh may have come to be at the address of one that has gone.
    if (found != mEntries.end() && !found->second.mesh.expired() &&
        found->second.state == mesh->getStateCount()) {
        Entry& known = found->second;
        if (known.bounds == mesh->getBounds()) return known;
        known.bounds = mesh->getBounds();
        ++known.boundsChanges;
        if (!known.isRestless()) known.readAnew();
        return known;
    }

    if (mEntries.size() > 2 * mSwept) {
        std::erase_if(mEntries, [](const auto& entry) { return entry.second.mesh.expired(); });
        mSwept = mEntries.size();
    }
    Entry entry;
    entry.mesh = mesh;
    entry.state = mesh->getStateCount();
    entry.bounds = mesh->getBounds();
    return mEntries.insert_or_assign(mesh.get(), std::move(entry)).first->second;
}

void MeshShapes::advance(MeshReading& reading, const Ogre::Mesh& mesh,
                         ReadingAllowance& allowance) {
    const std::size_t before = reading.bytesRead();
    reading.advance(mesh, allowance);
    mBytesRead += reading.bytesRead() - before;
}

void MeshShapes::advance(MeshReading& reading, const Ogre::Mesh& mesh) {
    if (reading.isDone()) return;
    ++mUnrest;
    if (!(mTimeLeft > 0.0)) return;
    const bool large = reading.timeLeft(mesh) > mTimeLeft;
    ReadingAllowance allowance(large ? std::min(mTimeLeft, mTimeLeftForLarge) : mTimeLeft);
    advance(reading, mesh, allowance);
    mTimeLeft -= allowance.spent();
    if (large) mTimeLeftForLarge -= allowance.spent();
}

void MeshShapes::prepare(const Ogre::MeshPtr& mesh, std::size_t parts) {
    if (!mesh->isLoaded() || mesh->hasSkeleton() || mesh->hasVertexAnimation()) return;
    ++mUnrest;
    Entry& entry = find(mesh);
    if (entry.isRestless()) {
        entry.boundsChanges = 0;
        entry.readAnew();
    }
    ReadingAllowance all(std::numeric_limits<double>::infinity());
    advance(entry.cloud, *mesh, all);
    if (mesh->hasManualLodLevel()) return;
    advance(entry.hull, *mesh, all);
    advance(entry.convex, *mesh, all);
    if (parts > 0) advance(entry.partsReading(parts), *mesh, all);
}

const SurfaceCloud* MeshShapes::cloudOf(const Ogre::Entity& entity) {
    Entry* const entry = find(entity);
    if (entry == nullptr) return nullptr;
    advance(entry->cloud, *entity.getMesh());
    return entry->cloud.cloud().surfels.empty() ? nullptr : &entry->cloud.cloud();
}

const BodyHull* MeshShapes::hullOf(const Ogre::Entity& entity) {
    Entry* const entry = find(entity);
    if (entry == nullptr || entry->isRestless() || entity.getMesh()->hasManualLodLevel())
        return nullptr;
    const HullReading& reading = entry->hull;
    if (reading.isDone() && reading.hull().empty()) return nullptr;
    if (mayMoveVertices(entity)) return nullptr;
    advance(entry->hull, *entity.getMesh());
    return reading.isDone() && !reading.hull().empty() ? &reading.hull() : nullptr;
}

std::optional<KnownParts> MeshShapes::partsOf(const Ogre::Entity& entity, std::size_t most) {
    if (entity.getMesh()->getNumLodLevels() > 1) return std::nullopt;
    const BodyHull* const hull = hullOf(entity);
    if (hull == nullptr || isConvex(entity, *hull)) return std::nullopt;
    CloudReading& reading = find(entity.getMesh()).partsReading(most);
    advance(reading, *entity.getMesh());
    if (!reading.isDone() || reading.parts().size() < LeastParts) return std::nullopt;
    return KnownParts{&reading.cloud(), reading.parts()};
}

bool MeshShapes::isConvex(const Ogre::Entity& entity, const BodyHull& hull) {
    if (darkensWhatIsUnlit(entity._getManager())) return false;
    if (hull.flat) return true;
    ConvexReading& reading = find(entity.getMesh()).convex;
    if (reading.isDone() && !reading.isConvex()) return false;
    if (!showsOutsideAlone(entity)) return false;
    advance(reading, *entity.getMesh());
    return reading.isConvex();
}

bool MeshShapes::isSelfShadowFree(const Ogre::Entity& entity, SelfShadowFree& body) {
    const BodyHull* const hull = hullOf(entity);
    if (hull == nullptr) return false;
    Eigen::AlignedBox3d bounds;
    for (const Vec3& vertex : hull->vertices)
        bounds.extend(vertex);
    body.around.box = {bounds.center(), bounds.sizes() / 2.0};
    body.relief = nullptr;
    body.isBox = false;
    if (isConvex(entity, *hull)) {
        body.isBox = hull->hasCorners;
        return true;
    }
    Entry& entry = find(entity.getMesh());
    // Where parts are wanted, the surface is read with them.
    CloudReading& surface = entry.parts ? *entry.parts : entry.cloud;
    if (!entry.convex.isDone() || (surface.isDone() && !surface.relief())) return false;
    if (darkensWhatIsUnlit(entity._getManager()) || !showsOutsideAlone(entity)) return false;
    advance(surface, *entity.getMesh());
    if (!surface.relief()) return false;
    body.relief = &*surface.relief();
    return true;
}

void ObjectShapes::reset(MeshShapes& meshes, const Vec3& wsOrigin) {
    mMeshes = &meshes;
    mWsOrigin = wsOrigin;
    mObjects.clear();
    mPartRuns.clear();
}

void ObjectShapes::addPart(const Ogre::MovableObject& whole) {
    const std::size_t index = mObjects.size();
    mObjects.push_back(nullptr);
    if (mPartRuns.empty() || mPartRuns.back().end != index || mPartRuns.back().whole != &whole)
        mPartRuns.push_back({index, &whole});
    ++mPartRuns.back().end;
}

const BodyHull* ObjectShapes::hullOf(std::size_t index, Transform3& wsFromBody) const noexcept {
    if (index >= mObjects.size()) return nullptr;
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(mObjects[index]);
    const BodyHull* const hull = entity != nullptr ? hullOrNone(*mMeshes, *entity) : nullptr;
    if (hull == nullptr) return nullptr;
    wsFromBody = relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin);
    const double filled = hull->volume * std::abs(wsFromBody.linear().determinant());
    const auto boxed = static_cast<double>(entity->getWorldBoundingBox().volume());
    return boxed > LooseBox * filled ? hull : nullptr;
}

const void* ObjectShapes::identityOf(std::size_t index) const noexcept {
    if (index >= mObjects.size()) return nullptr;
    if (mObjects[index] != nullptr) return mObjects[index];
    return std::ranges::upper_bound(mPartRuns, index, {}, &PartRun::end)->whole;
}

bool ObjectShapes::isSelfShadowFree(std::size_t index, SelfShadowFree& body) const noexcept {
    if (index >= mObjects.size()) return false;
    const auto* const entity = dynamic_cast<const Ogre::Entity*>(mObjects[index]);
    if (entity == nullptr) return false;
    try {
        if (!mMeshes->isSelfShadowFree(*entity, body)) return false;
    } catch (const std::exception&) {
        return false;
    }
    body.around.wsFromBody = relativeTransform(entity->_getParentNodeFullTransform(), mWsOrigin);
    // A mirrored surface shows its inside.
    return body.around.box.halfExtents.minCoeff() == 0.0 ||
           body.around.wsFromBody.linear().determinant() > 0.0;
}

} // namespace Lixel
