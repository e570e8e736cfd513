#pragma once

#include "fit/geometry/Types.h"

#include <Eigen/Geometry>

#include <OgreAxisAlignedBox.h>
#include <OgreMatrix4.h>
#include <OgreQuaternion.h>
#include <OgreVector.h>

/// Conversions between OGRE's single and the fit's double precision.
namespace Lixel {

inline Vec3 toDouble(const Ogre::Vector3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Mat4 toDouble(const Ogre::Matrix4& m) {
    Mat4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result(row, column) = m[row][column];
    return result;
}

/// A finite box relative to an origin.
inline Aabb relativeBox(const Ogre::AxisAlignedBox& bounds, const Vec3& wsOrigin) {
    const Vec3 lower = toDouble(bounds.getMinimum()) - wsOrigin;
    const Vec3 upper = toDouble(bounds.getMaximum()) - wsOrigin;
    return {(lower + upper) / 2.0, (upper - lower) / 2.0};
}

/// A transform into the world, as one relative to an origin there.
inline Transform3 relativeTransform(const Ogre::Affine3& wsFromOwn, const Vec3& wsOrigin) {
    Transform3 result(toDouble(wsFromOwn));
    result.pretranslate(-wsOrigin);
    return result;
}

inline Ogre::Vector3 toOgre(const Vec3& v) {
    return {static_cast<Ogre::Real>(v.x()), static_cast<Ogre::Real>(v.y()),
            static_cast<Ogre::Real>(v.z())};
}

/// @param q of length 1
inline Ogre::Quaternion toOgre(const Eigen::Quaterniond& q) {
    return {static_cast<Ogre::Real>(q.w()), static_cast<Ogre::Real>(q.x()),
            static_cast<Ogre::Real>(q.y()), static_cast<Ogre::Real>(q.z())};
}

inline Ogre::Matrix4 toOgre(const Mat4& m) {
    Ogre::Matrix4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[row][column] = static_cast<Ogre::Real>(m(row, column));
    return result;
}

} // namespace Lixel
