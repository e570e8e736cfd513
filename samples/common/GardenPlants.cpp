#include "common/GardenPlants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace Lixel::Samples {
namespace {

using Ogre::Quaternion;
using Ogre::uint32;
using Ogre::Vector2;
using Ogre::Vector3;

const std::array PictureUvs{Vector2(0, 1), Vector2(1, 1), Vector2(1, 0), Vector2(0, 0)};
const std::array<uint32, 6> PictureTriangles{0, 1, 2, 0, 2, 3};

Vector3 anyDirection(Random& random) {
    const float y = random.between(-1.0F, 1.0F);
    const float angle = random.between(0.0F, 2.0F * std::numbers::pi_v<float>);
    const float flat = std::sqrt(1.0F - y * y);
    return {flat * std::cos(angle), y, flat * std::sin(angle)};
}

/// A picture of leaves in the crown about `middle`. Its normals lean away from the middle, so that
/// light and shade go around the crown as a whole.
void addLeaves(MeshBuilder& mesh, const Vector3& centre, const Vector3& middle, float size,
               Random& random) {
    const Vector3 out = (centre - middle).normalisedCopy();
    const Vector3 facing = (out + 0.8F * anyDirection(random)).normalisedCopy();
    const Quaternion turn = Vector3::UNIT_Z.getRotationTo(facing) *
                            Quaternion(Ogre::Degree(random.between(0.0F, 360.0F)), Vector3::UNIT_Z);
    const float half = 0.5F * size * random.between(0.8F, 1.2F);
    std::array<Vector3, 4> corners{Vector3(-half, -half, 0), Vector3(half, -half, 0),
                                   Vector3(half, half, 0), Vector3(-half, half, 0)};
    std::array<Vector3, 4> normals;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = centre + turn * corners[i];
        normals[i] = ((corners[i] - middle).normalisedCopy() + 0.7F * facing).normalisedCopy();
    }
    mesh.triangles(corners, normals, PictureUvs, PictureTriangles);
}

/// A branch from one point to another, a little into what it grows from.
void addBranch(MeshBuilder& mesh, const Vector3& from, const Vector3& to, float thick, float thin) {
    const Vector3 along = to - from;
    mesh.transform = Ogre::Affine3(from, Vector3::UNIT_Y.getRotationTo(along.normalisedCopy()));
    mesh.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{thick, 0.0F},
                          ProfilePoint{thin, along.length()}, ProfilePoint{0.0F, along.length()}},
               8);
    mesh.transform = Ogre::Affine3::IDENTITY;
}

/// The round masses that a crown is made of, relative to the tree's foot.
std::vector<Ogre::Sphere> massesOf(const CrownShape& crown, Random& random) {
    const Vector3 middle(0.0F, crown.height, 0.0F);
    std::vector<Ogre::Sphere> masses{
        {middle + Vector3(0, 0.25F * crown.radius, 0), 0.72F * crown.radius}};
    constexpr int Around = 5;
    for (int i = 0; i < Around; ++i) {
        const Ogre::Radian turn(2.0F * std::numbers::pi_v<float> / Around * static_cast<float>(i) +
                                random.between(-0.3F, 0.3F));
        const Vector3 side(0.6F * crown.radius, random.between(-0.3F, 0.15F) * crown.radius, 0.0F);
        masses.emplace_back(middle + Quaternion(turn, Vector3::UNIT_Y) * side,
                            random.between(0.42F, 0.55F) * crown.radius);
    }
    return masses;
}

} // namespace

void TreeBuilders::add(const Vector3& foot, const CrownShape& crown, Random& random) {
    const float thick = 0.075F * crown.radius + 0.02F * crown.height;
    const Vector3 fork(0.0F, crown.height - 0.55F * crown.radius, 0.0F);
    wood.transform.setTrans(foot - Vector3(0.0F, 0.15F, 0.0F));
    wood.lathe(std::array{ProfilePoint{0.0F, 0.0F}, ProfilePoint{1.6F * thick, 0.0F},
                          ProfilePoint{1.05F * thick, 0.16F * fork.y, true},
                          ProfilePoint{0.8F * thick, fork.y + 0.25F},
                          ProfilePoint{0.0F, fork.y + 0.3F}},
               12);
    const std::vector<Ogre::Sphere> masses = massesOf(crown, random);
    const Vector3 middle = foot + Vector3(0.0F, crown.height - 0.2F * crown.radius, 0.0F);
    float whole = 0.0F;
    for (const Ogre::Sphere& mass : masses)
        whole += mass.getRadius() * mass.getRadius();
    for (const Ogre::Sphere& mass : masses) {
        addBranch(wood, foot + fork, foot + mass.getCenter(), 0.55F * thick, 0.2F * thick);
        const float share = mass.getRadius() * mass.getRadius() / whole;
        const int count = static_cast<int>(std::lround(static_cast<float>(crown.leaves) * share));
        for (int i = 0; i < count; ++i) {
            const Vector3 place = mass.getCenter() + mass.getRadius() * random.between(0.6F, 1.0F) *
                                                         anyDirection(random);
            addLeaves(leaves, foot + place, middle, crown.leafSize, random);
        }
    }
}

void TreeBuilders::addBush(const Vector3& foot, float radius, int count, Random& random) {
    const Vector3 middle = foot - Vector3(0.0F, 0.2F * radius, 0.0F);
    for (int i = 0; i < count; ++i) {
        Vector3 direction = anyDirection(random);
        direction.y = std::abs(direction.y);
        const Vector3 place = radius * random.between(0.75F, 1.0F) * direction;
        addLeaves(leaves, foot + place * Vector3(1.0F, 0.85F, 1.0F), middle, 0.75F * radius,
                  random);
    }
}

Ogre::MeshPtr tuft(const std::string& name, float width, float height, int pictures) {
    MeshBuilder mesh;
    for (int i = 0; i < pictures; ++i) {
        const Ogre::Radian turn(std::numbers::pi_v<float> * static_cast<float>(i) /
                                static_cast<float>(pictures));
        mesh.transform = Ogre::Affine3(Vector3::ZERO, Quaternion(turn, Vector3::UNIT_Y));
        const float half = 0.5F * width;
        // Lit as the ground is on which it stands.
        mesh.triangles(std::array{Vector3(-half, 0, 0), Vector3(half, 0, 0),
                                  Vector3(half, height, 0), Vector3(-half, height, 0)},
                       {}, PictureUvs, PictureTriangles);
    }
    return mesh.build(name);
}

void plantInstances(Ogre::SceneManager& sceneManager, const std::string& mesh,
                    const std::string& material, int count,
                    const std::function<Placement(Random&)>& pick, std::uint32_t seed) {
    Random random(seed);
    Ogre::InstanceManager& instances = *sceneManager.createInstanceManager(
        mesh, mesh, Ogre::RGN_DEFAULT, Ogre::InstanceManager::HWInstancingBasic, InstancesTogether);
    for (int i = 0; i < count; ++i) {
        const Placement placement = pick(random);
        Ogre::SceneNode& node = *sceneManager.getRootSceneNode()->createChildSceneNode(
            placement.position, Quaternion(Ogre::Degree(placement.yawDegrees), Vector3::UNIT_Y));
        node.setScale(Vector3(placement.scale));
        node.attachObject(instances.createInstancedEntity(material));
    }
}

} // namespace Lixel::Samples
