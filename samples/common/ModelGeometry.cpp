#include "common/ModelGeometry.h"

#include <algorithm>
#include <cmath>

namespace Lixel::Samples {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

Vector3d toEigen(const aiVector3D& v) {
    return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

Ogre::Vector3 toOgre(const Vector3d& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

std::vector<Ogre::uint32> readIndices(const aiMesh& mesh, bool turned) {
    std::vector<Ogre::uint32> indices;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue;
        indices.push_back(face.mIndices[0]);
        indices.push_back(face.mIndices[turned ? 2 : 1]);
        indices.push_back(face.mIndices[turned ? 1 : 2]);
    }
    return indices;
}

/// Unit normals; what the file gives wherever that is usable.
std::vector<Vector3d> readNormals(const aiMesh& mesh, const Matrix3d& normalMatrix,
                                  const std::vector<Vector3d>& positions,
                                  const std::vector<Ogre::uint32>& indices) {
    std::vector<Vector3d> around(positions.size(), Vector3d::Zero());
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Vector3d& a = positions[indices[i]];
        const Vector3d area = (positions[indices[i + 1]] - a).cross(positions[indices[i + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k)
            around[indices[i + k]] += area;
    }
    std::vector<Vector3d> normals(positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        // stableNormalized leaves zero as zero.
        Vector3d normal = Vector3d::Zero();
        if (mesh.HasNormals())
            normal = (normalMatrix * toEigen(mesh.mNormals[i])).stableNormalized();
        if (!(normal.norm() > 0.5)) normal = around[i].stableNormalized();
        if (!(normal.norm() > 0.5)) normal = Vector3d::UnitY();
        normals[i] = normal;
    }
    return normals;
}

std::vector<Ogre::Vector2> readUvs(const aiMesh& mesh) {
    std::vector<Ogre::Vector2> uvs;
    if (!mesh.HasTextureCoords(0)) return uvs;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& uv = mesh.mTextureCoords[0][i];
        const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
        uvs.push_back(finite ? Ogre::Vector2(uv.x, uv.y) : Ogre::Vector2::ZERO);
    }
    return uvs;
}

/// det(M) M^-T: what turns normals, for singular M too.
Matrix3d cofactors(const Matrix3d& m) {
    Matrix3d result;
    result.col(0) = m.col(1).cross(m.col(2));
    result.col(1) = m.col(2).cross(m.col(0));
    result.col(2) = m.col(0).cross(m.col(1));
    return result;
}

} // namespace

Matrix4d toEigen(const aiMatrix4x4& m) {
    Matrix4d matrix;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            matrix(row, column) = static_cast<double>(m[row][column]);
    return matrix;
}

std::optional<Similarity> asSimilarity(const Matrix4d& matrix) {
    constexpr double Tolerance = 1e-4; // of the scale; files hold floats, products of them less
    const Matrix3d linear = matrix.topLeftCorner<3, 3>();
    const double determinant = linear.determinant();
    const double scale = std::cbrt(determinant);
    if (!matrix.allFinite() || !(determinant > 0.0)) return std::nullopt;
    const Matrix3d rotation = linear / scale;
    if (!((rotation.transpose() * rotation - Matrix3d::Identity()).cwiseAbs().maxCoeff() <
          Tolerance))
        return std::nullopt;
    const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
    return Similarity{toOgre(matrix.topRightCorner<3, 1>()),
                      Ogre::Quaternion(static_cast<float>(q.w()), static_cast<float>(q.x()),
                                       static_cast<float>(q.y()), static_cast<float>(q.z())),
                      static_cast<float>(scale)};
}

void addMesh(MeshBuilder& builder, const aiMesh& mesh, const Matrix4d& baked, bool twoSided) {
    const Matrix3d linear = baked.topLeftCorner<3, 3>();
    const bool mirrored = linear.determinant() < 0.0;
    std::vector<Vector3d> positions;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        positions.push_back(linear * toEigen(mesh.mVertices[i]) + baked.topRightCorner<3, 1>());
    std::vector<Ogre::uint32> indices = readIndices(mesh, mirrored);
    const double sign = mirrored ? -1.0 : 1.0;
    const std::vector<Vector3d> normals =
        readNormals(mesh, sign * cofactors(linear), positions, indices);
    const std::vector<Ogre::Vector2> uvs = readUvs(mesh);

    std::vector<Ogre::Vector3> points(positions.size());
    std::vector<Ogre::Vector3> directions(normals.size());
    std::transform(positions.begin(), positions.end(), points.begin(), toOgre);
    std::transform(normals.begin(), normals.end(), directions.begin(), toOgre);
    builder.triangles(points, directions, uvs, indices);
    if (!twoSided) return;
    for (Ogre::Vector3& n : directions)
        n = -n;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        std::swap(indices[i + 1], indices[i + 2]);
    builder.triangles(points, directions, uvs, indices);
}

} // namespace Lixel::Samples
