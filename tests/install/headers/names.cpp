// An application that says `using namespace` for OGRE and Lixel means OGRE's classes by their names.
#include "headers.cpp"

#include <Ogre.h>

using namespace Ogre;
using namespace Lixel;

[[maybe_unused]] static void nameClasses(const Plane&, const Box&, const Technique&, const Affine3&,
                                         const Vector3&, const Light&, const Camera&, const Pass&) {
}
