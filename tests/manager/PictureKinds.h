#pragma once

#include "PictureScene.h"

#include <ostream>
#include <vector>

namespace Lixel::Tests {

/// A kind of scene that is drawn with two scene managers.
struct PictureKind {
    const char* name;
    /// Where the scene is.
    Ogre::Vector3 origin;
    void (*prepare)(PictureScene& scene);
    /// Undoes what makes the kind, for a test that it is seen at all.
    void (*undo)(PictureScene& scene);
};

inline std::ostream& operator<<(std::ostream& out, const PictureKind& kind) {
    return out << kind.name;
}

const std::vector<PictureKind>& pictureKinds();

} // namespace Lixel::Tests
