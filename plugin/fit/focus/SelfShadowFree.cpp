#include "fit/focus/SelfShadowFree.h"

#include "fit/geometry/BoxQuery.h"

#include <algorithm>

namespace Lixel {
namespace {

/// A relief is left as it is where more than this part of it may face away from the light.
constexpr double MostSlopes = 0.5;

} // namespace

/// @return false where the body is better left as it is
bool SelfShadowFreeBodies::addSlopes(const SelfShadowFree& body, const LightImage& image) {
    const Transform3& wsFromBody = body.around.wsFromBody;
    if (!wsFromBody.matrix().allFinite()) return false;
    if (body.relief == nullptr) return true;
    const Relief& relief = *body.relief;
    const Vec4 light = wsFromBody.inverse(Eigen::Affine) * image.wsLight();
    if (image.directional() && relief.isBelow(light.head<3>())) return true;
    const std::size_t first = mSlopes.size();
    const auto most =
        static_cast<std::size_t>(MostSlopes * static_cast<double>(relief.cells.size()));
    for (const ReliefCell& cell : relief.cells)
        if (!relief.isLit(cell, light)) mSlopes.push_back(boundsOf(cell.bounds, wsFromBody));
    const bool isWorthIt = !relief.cells.empty() && mSlopes.size() - first <= most;
    if (!isWorthIt) mSlopes.resize(first);
    return isWorthIt;
}

void SelfShadowFreeBodies::find(const ShadowProblem& problem, const LightImage& image,
                                const BoxSet& casters, const BoxSet& receivers,
                                const LargeBodies& large) {
    clear();
    if (problem.casterShapes == nullptr || large.indices().empty()) return;
    std::array<const void*, LargeBodies::Most> identities;
    const auto end =
        std::ranges::transform(large.indices(), identities.begin(), [&](std::size_t i) {
            return problem.receiverShapes->identityOf(receivers.origin(i));
        }).out;
    std::array<std::size_t, LargeBodies::Most> largest;
    const std::size_t count = largestBoxes(casters, largest);
    for (const std::size_t k : std::span(largest).first(count)) {
        if (casters.box(k).halfExtents.sum() < large.leastSize()) break;
        SelfShadowFreeBody body;
        body.caster = casters.origin(k);
        body.identity = problem.casterShapes->identityOf(body.caster);
        if (body.identity == nullptr) continue;
        if (std::find(identities.begin(), end, body.identity) == end) continue;
        SelfShadowFree known;
        if (!problem.casterShapes->isSelfShadowFree(body.caster, known) || !addSlopes(known, image))
            continue;
        body.around = known.around;
        mBodies[mCount++] = body;
    }
}

bool SelfShadowFreeBodies::hasCaster(std::size_t index) const {
    return std::ranges::any_of(
        all(), [=](const SelfShadowFreeBody& body) { return body.caster == index; });
}

std::size_t behindLitFaces(const PlacedBox& around, const LightImage& image, double extent,
                           std::span<HalfSpace, 3> planes) {
    const Mat3 axes = around.wsFromBody.linear();
    const Vec3 centre = around.wsFromBody * around.box.centre;
    const Vec3 wsTowardsSun = image.lsFromWs().row(2);
    std::size_t count = 0;
    for (const int axis : {0, 1, 2}) {
        // Across the other two axes: right for a box that is sheared, too.
        Vec3 normal = Vec3(axes.col((axis + 1) % 3)).cross(Vec3(axes.col((axis + 2) % 3)));
        normal = normal.stableNormalized();
        const double half = std::abs(normal.dot(axes.col(axis))) * around.box.halfExtents[axis];
        // The light's height above the plane through the middle.
        const double height =
            image.directional() ? normal.dot(wsTowardsSun) : normal.dot(image.wsEye() - centre);
        if (height < 0.0) normal = -normal;
        if (!(std::abs(height) > (image.directional() ? 0.0 : half))) continue;
        const double offset = normal.dot(centre) + half;
        const double slack = TouchingSlack * (std::abs(offset) + extent);
        planes[count++] = {-normal, offset + slack};
    }
    return count;
}

} // namespace Lixel
