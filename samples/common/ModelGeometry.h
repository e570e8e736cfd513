#pragma once

#include "common/MeshBuilder.h"

#include <Eigen/Geometry>
#include <assimp/scene.h>

#include <optional>
#include <vector>

namespace Lixel::Samples {

/// A matrix of Assimp's (row vectors of its rows, acting on columns) in double.
Eigen::Matrix4d toEigen(const aiMatrix4x4& matrix);

/// A transform that an OGRE node can hold and that keeps angles.
struct Similarity {
    Ogre::Vector3 position;
    Ogre::Quaternion orientation;
    float scale = 1.0F;
};

/// The similarity that a matrix is, to 1e-4 of its scale; nothing for shear, mirroring, unequal
/// scales or a scale of 0.
std::optional<Similarity> asSimilarity(const Eigen::Matrix4d& matrix);

/// Calls `use(a, b, c)` with the positions (double, the mesh's space) of every triangle.
template <typename Use>
void forEachTriangle(const aiMesh& mesh, const Use& use) {
    const auto position = [&](unsigned index) {
        const aiVector3D& p = mesh.mVertices[index];
        return Eigen::Vector3f(p.x, p.y, p.z).cast<double>().eval();
    };
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices == 3)
            use(position(face.mIndices[0]), position(face.mIndices[1]), position(face.mIndices[2]));
    }
}

/** Adds a mesh's triangles to a builder.

    @param baked applied to positions and, as its inverse transpose, to normals; a mirroring one
    turns the winding too
    @param twoSided adds every triangle again, facing the other way
    Normals that are missing, zero or not finite are made from the triangles around their vertex;
    texture coordinates that are not finite become 0.
*/
void addMesh(MeshBuilder& builder, const aiMesh& mesh, const Eigen::Matrix4d& baked, bool twoSided);

} // namespace Lixel::Samples
