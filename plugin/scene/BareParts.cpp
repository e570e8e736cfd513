#include "scene/BareParts.h"

#include <OgreLogManager.h>
#include <OgreMaterial.h>
#include <OgreMovableObject.h>
#include <OgreRenderable.h>
#include <OgreTechnique.h>

#include <optional>

namespace Lixel {
namespace {

/// Asks all parts' materials.
class Question : public Ogre::Renderable::Visitor {
public:
    void visit(Ogre::Renderable* part, Ogre::ushort, bool, Ogre::Any*) override {
        // In this order: a part's technique is its material's.
        const bool bare = !part->getMaterial();
        const Ogre::Technique* const technique = bare ? nullptr : part->getTechnique();
        if (bare && !firstBare) firstBare = parts;
        receives = receives || technique == nullptr || technique->getParent()->getReceiveShadows();
        ++parts;
    }
    bool receives = false;
    std::size_t parts = 0;
    std::optional<std::size_t> firstBare;
};

} // namespace

bool BareParts::receives(Ogre::MovableObject& object) {
    Question question;
    object.visitRenderables(&question);
    if (question.firstBare && mTold.emplace(&object, object.getName()).second)
        Ogre::LogManager::getSingleton().logError(
            "Lixel: " + object.getMovableType() + " '" + object.getName() + "': part " +
            std::to_string(*question.firstBare) + " of " + std::to_string(question.parts) +
            " (from 0) has no material, and OGRE may crash when it draws it. Give it one by "
            "SubEntity::setMaterialName(name, group): what a mesh's file names is looked for in "
            "the mesh's own resource group alone");
    return question.receives;
}

} // namespace Lixel
