#include "Sight.h"

#include <OgreCamera.h>
#include <OgreLight.h>
#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreRenderQueueSortingGrouping.h>
#include <OgreRenderable.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <vector>

namespace Lixel::Tests {
namespace {

constexpr std::size_t DifferencesShown = 6;

class PartNames : public Ogre::Renderable::Visitor {
public:
    PartNames(RenderableNames& names, const std::string& object) : mNames(names), mObject(object) {}
    void visit(Ogre::Renderable* renderable, Ogre::ushort level, bool isDebug,
               Ogre::Any*) override {
        mNames[renderable] = {
            fmt::format("{}#{}.{}{}", mObject, level, mParts++, isDebug ? " debug" : ""),
            level == 0};
    }

private:
    RenderableNames& mNames;
    const std::string& mObject;
    int mParts = 0;
};

std::uint64_t hashOf(const Ogre::Matrix4* matrices, std::size_t count) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column) {
                const float entry = matrices[i][row][column] + 0.0f; // -0 is 0
                std::uint32_t bits = 0;
                std::memcpy(&bits, &entry, sizeof bits);
                hash = (hash ^ bits) * 1099511628211ULL;
            }
    return hash;
}

std::string namesOf(const Ogre::LightList& lights, const Names& names) {
    std::string all;
    for (const Ogre::Light* light : lights)
        all += ' ' + names.of(*light);
    return all;
}

/// Writes down each renderable that is queued.
class Scribe : public Ogre::QueuedRenderableVisitor {
public:
    Scribe(const RenderableNames& renderables, const Names& names, const Ogre::Camera& camera,
           std::vector<std::string>& lines)
        : mRenderables(renderables), mNames(names), mCamera(camera), mLines(lines) {}

    void visit(Ogre::RenderablePass* queued) override { write(*queued->renderable, *queued->pass); }
    void visit(const Ogre::Pass* pass, Ogre::RenderableList& renderables) override {
        for (Ogre::Renderable* renderable : renderables)
            write(*renderable, *pass);
    }

    /// Of group, priority and kind of what is visited next.
    std::string place;

private:
    void write(Ogre::Renderable& renderable, const Ogre::Pass& pass) {
        const auto name = mRenderables.find(&renderable);
        const bool isKnown = name != mRenderables.end();
        const unsigned short count = renderable.getNumWorldTransforms();
        mMatrices.assign(std::max<std::size_t>(count, 1), Ogre::Matrix4::IDENTITY);
        renderable.getWorldTransforms(mMatrices.data());
        Ogre::RenderOperation operation;
        renderable.getRenderOperation(operation);
        const Ogre::Matrix4& matrix = mMatrices[0];
        std::string line;
        fmt::format_to(std::back_inserter(line),
                       "{} {} '{}'/{} at ({} {} {}) x{} {:x}, {} vertices {} indices", place,
                       isKnown ? name->second.name : "OGRE's own",
                       pass.getParent()->getParent()->getName(), pass.getIndex(), matrix[0][3],
                       matrix[1][3], matrix[2][3], count,
                       hashOf(mMatrices.data(), mMatrices.size()),
                       operation.vertexData != nullptr ? operation.vertexData->vertexCount : 0,
                       operation.useIndexes ? operation.indexData->indexCount : 0);
        // OGRE's own debug lines are attached nowhere.
        if (isKnown && name->second.hasDepth)
            fmt::format_to(std::back_inserter(line), ", depth {:a}",
                           renderable.getSquaredViewDepth(&mCamera));
        line += ", casts " + std::to_string(renderable.getCastsShadows()) + ", lights";
        mLines.push_back(line + namesOf(renderable.getLights(), mNames));
    }

    const RenderableNames& mRenderables;
    const Names& mNames;
    const Ogre::Camera& mCamera;
    std::vector<std::string>& mLines;
    std::vector<Ogre::Matrix4> mMatrices;
};

using Ogre::QueuedRenderableCollection;

struct Kind {
    const char* name;
    const QueuedRenderableCollection& collection;
    QueuedRenderableCollection::OrganisationMode mode;
};

std::array<Kind, 6> kindsOf(const Ogre::RenderPriorityGroup& priority) {
    constexpr auto grouped = QueuedRenderableCollection::OM_PASS_GROUP;
    constexpr auto sorted = QueuedRenderableCollection::OM_SORT_DESCENDING;
    return {{{"solid", priority.getSolidsBasic(), grouped},
             {"diffuse", priority.getSolidsDiffuseSpecular(), grouped},
             {"decal", priority.getSolidsDecal(), grouped},
             {"unshadowed", priority.getSolidsNoShadowReceive(), grouped},
             {"unsorted", priority.getTransparentsUnsorted(), sorted},
             {"transparent", priority.getTransparents(), sorted}}};
}

std::string text(const Ogre::AxisAlignedBox& box) {
    if (box.isNull()) return "null";
    if (box.isInfinite()) return "infinite";
    const Ogre::Vector3& low = box.getMinimum();
    const Ogre::Vector3& high = box.getMaximum();
    return fmt::format("{:a} {:a} {:a} to {:a} {:a} {:a}", low.x, low.y, low.z, high.x, high.y,
                       high.z);
}

std::string text(const Ogre::VisibleObjectsBoundsInfo& info) {
    return fmt::format("{}; receivers {}; {:a} to {:a}; in frustum {:a} to {:a}", text(info.aabb),
                       text(info.receiverAabb), info.minDistance, info.maxDistance,
                       info.minDistanceInFrustum, info.maxDistanceInFrustum);
}

} // namespace

void addRenderables(RenderableNames& names, Ogre::MovableObject& object, const std::string& name) {
    PartNames parts(names, name);
    object.visitRenderables(&parts, true);
}

Sight look(Ogre::SceneManager& manager, const RenderableNames& renderables, const Names& names) {
    const Ogre::Camera& camera = *manager.getCurrentViewport()->getCamera();
    Sight sight;
    sight.camera = names.of(camera);
    Scribe scribe(renderables, names, camera, sight.queued);
    const auto& groups = manager.getRenderQueue()->_getQueueGroups();
    for (std::size_t id = 0; id < std::size(groups); ++id) {
        if (!groups[id]) continue;
        // By number, because priorities themselves cannot be asked for in every version.
        int number = 0;
        forPriorityGroups(*groups[id], [&](const Ogre::RenderPriorityGroup& priority) {
            for (const Kind& kind : kindsOf(priority)) {
                scribe.place = fmt::format("{}/{} {}", id, number, kind.name);
                kind.collection.acceptVisitor(&scribe, kind.mode);
            }
            ++number;
        });
    }
    std::sort(sight.queued.begin(), sight.queued.end());
    sight.bounds = text(manager.getVisibleObjectsBoundsInfo(&camera));
    // Without a search, the list keeps lights that are destroyed.
    if (manager.getFindVisibleObjects())
        sight.lights = namesOf(manager._getLightsAffectingFrustum(), names);
    return sight;
}

std::string difference(const Sight& expected, const Sight& actual) {
    if (expected.camera != actual.camera)
        return "another camera: " + expected.camera + ", and here " + actual.camera;
    std::vector<std::string> missing;
    std::vector<std::string> surplus;
    std::set_difference(expected.queued.begin(), expected.queued.end(), actual.queued.begin(),
                        actual.queued.end(), std::back_inserter(missing));
    std::set_difference(actual.queued.begin(), actual.queued.end(), expected.queued.begin(),
                        expected.queued.end(), std::back_inserter(surplus));
    std::string found;
    for (const auto& [lines, what] : {std::pair{&missing, "missing"}, {&surplus, "surplus"}})
        for (std::size_t i = 0; i < std::min(lines->size(), DifferencesShown); ++i)
            found += std::string("\n  ") + what + ": " + (*lines)[i];
    if (expected.bounds != actual.bounds)
        found += "\n  bounds: " + expected.bounds + "\n    here: " + actual.bounds;
    if (expected.lights != actual.lights)
        found += "\n  lights:" + expected.lights + "\n    here:" + actual.lights;
    return found.empty() ? "" : expected.camera + " sees" + found;
}

std::string difference(const std::map<std::string, int>& expected,
                       const std::map<std::string, int>& actual) {
    std::map<std::string, int> counts = actual;
    for (const auto& [what, count] : expected)
        counts[what] -= count;
    std::string found;
    std::size_t shown = 0;
    for (const auto& [what, surplus] : counts)
        if (surplus != 0 && ++shown <= DifferencesShown)
            found += fmt::format("\n  {} times {}: {}", std::abs(surplus),
                                 surplus < 0 ? "too few" : "too often", what);
    return found.empty() ? "" : "heard" + found;
}

} // namespace Lixel::Tests
