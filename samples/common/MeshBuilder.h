#pragma once

#include <Ogre.h>

#include <span>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// One corner of a lathe's outline: how far from the axis, and at which height.
struct ProfilePoint {
    float radius = 0.0F;
    float height = 0.0F;
    bool smooth = false; ///< shade it round; otherwise it is an edge
};

/** Collects shapes into one mesh with positions, normals and one set of texture coordinates.

    Every solid is closed: no crack between neighbours, fronts counter-clockwise and outward,
    normals of unit length. Lengths are the mesh's units; texture coordinates advance by 1 per 4 of
    them. Shapes are placed by `transform`, which must keep angles (rotation, translation, one
    scale).
*/
class MeshBuilder {
public:
    /// Applies to what is added from now on.
    Ogre::Affine3 transform = Ogre::Affine3::IDENTITY;

    /// A flat polygon with convex outline, counter-clockwise seen from its front.
    void polygon(std::span<const Ogre::Vector3> corners);
    void quad(const Ogre::Vector3& a, const Ogre::Vector3& b, const Ogre::Vector3& c,
              const Ogre::Vector3& d);
    /// An axis-aligned box.
    void box(const Ogre::Vector3& low, const Ogre::Vector3& high);
    /// A box by the middle of its base.
    void boxOn(const Ogre::Vector3& base, float width, float height, float depth);
    /// A convex outline in x and y, counter-clockwise, from z = back to z = front.
    void prism(std::span<const Ogre::Vector2> outline, float back, float front);
    /// An arch in x and y: legs `height` tall and a half circle, `span` wide inside, `thickness`
    /// between its inner and outer outline, from z = -depth/2 to depth/2.
    void arch(float span, float height, float thickness, float depth, int segments = 16);
    /** A solid of revolution about y.
        @param profile from the lower end on the axis to the upper one: radius 0 first and last
    */
    void lathe(std::span<const ProfilePoint> profile, int segments);
    void cylinder(float radius, float low, float high, int segments = 20);
    void cone(float radius, float low, float high, int segments = 24);
    void sphere(const Ogre::Vector3& centre, float radius, int segments = 24);
    /// A ring about y; `radius` to the middle of a tube of radius `tube`.
    void torus(float radius, float tube, int segments = 32, int sides = 14);
    /// A square of `cells` x `cells` facing up at y = 0 about the origin, all of one texture scale.
    void ground(float halfSide, int cells);
    /// Triangles of one's own; `normals` and `uvs` empty or as many as positions.
    void triangles(std::span<const Ogre::Vector3> positions, std::span<const Ogre::Vector3> normals,
                   std::span<const Ogre::Vector2> uvs, std::span<const Ogre::uint32> indices);

    bool empty() const { return mIndices.empty(); }

    /** The mesh of everything added, with readable buffers; a mesh of that name is replaced.
        @exception Ogre::InvalidStateException when nothing was added
    */
    Ogre::MeshPtr build(const std::string& name) const;

private:
    struct Vertex {
        Ogre::Vector3 position;
        Ogre::Vector3 normal;
        Ogre::Vector2 uv;
    };
    Ogre::uint32 vertex(const Ogre::Vector3& position, const Ogre::Vector3& normal,
                        const Ogre::Vector2& uv);
    void triangle(Ogre::uint32 a, Ogre::uint32 b, Ogre::uint32 c);

    std::vector<Vertex> mVertices;
    std::vector<Ogre::uint32> mIndices;
};

} // namespace Lixel::Samples
