#include "scene/BareParts.h"

#include <OgreEntity.h>
#include <OgreLogManager.h>
#include <OgreMaterial.h>
#include <OgreMaterialManager.h>
#include <OgreMovableObject.h>
#include <OgreRenderable.h>
#include <OgreSubEntity.h>
#include <OgreTechnique.h>

#include <optional>
#include <typeinfo>

namespace Lixel {
namespace {

/** Whether a material has parts of entities receive, whichever wears it.

    A listener may give a part another material's technique, where its own has none for the scheme in
    use, and so may levels of detail: then it depends on the part. */
std::optional<bool> receivesInAnyPart(const Ogre::Material& material) {
    const auto& techniques = material.getSupportedTechniques();
    const Ogre::ushort scheme = Ogre::MaterialManager::getSingleton()._getActiveSchemeIndex();
    if (techniques.size() != 1 || techniques.front()->_getSchemeIndex() != scheme)
        return std::nullopt;
    return material.getReceiveShadows();
}

/// Asks all parts and their materials.
class Question : public Ogre::Renderable::Visitor {
public:
    explicit Question(bool castersReceive) : mCastersReceive(castersReceive) {}

    void visit(Ogre::Renderable* part, Ogre::ushort, bool, Ogre::Any*) override {
        const Ogre::MaterialPtr& material = part->getMaterial();
        if (!material && !firstBare) firstBare = parts;
        // The part's word, not the object's, because OGRE takes it: before 14 what is not of an
        // entity or of static geometry always says that it casts none.
        receives = receives || ((mCastersReceive || !part->getCastsShadows()) &&
                                (!material || lets(*part, *material)));
        ++parts;
    }
    bool receives = false;
    std::size_t parts = 0;
    std::optional<std::size_t> firstBare;

private:
    /// Whether the material that a part is drawn in lets it receive.
    bool lets(const Ogre::Renderable& part, const Ogre::Material& material) const {
        // An application's part may have another technique too. Asking takes longest.
        if (typeid(part) == typeid(Ogre::SubEntity))
            if (const auto answer = receivesInAnyPart(material)) return *answer;
        const Ogre::Technique* const technique = part.getTechnique();
        return technique == nullptr || technique->getParent()->getReceiveShadows();
    }

    bool mCastersReceive;
};

} // namespace

std::optional<bool> BareParts::receivesAsMaterials(const Ogre::Entity& entity) {
    if (entity.getNumManualLodLevels() > 0) return std::nullopt;
    bool any = false;
    for (const Ogre::SubEntity* part : entity.getSubEntities()) {
        const Ogre::Material* const material = part->getMaterial().get();
        Read& read = mRead[reinterpret_cast<std::uintptr_t>(material) / sizeof(Ogre::Material) %
                           mRead.size()];
        if (material == nullptr) return std::nullopt;
        if (read.material != material) read = {material, receivesInAnyPart(*material)};
        if (!read.receives) return std::nullopt;
        any = any || *read.receives;
    }
    return any;
}

bool BareParts::receives(Ogre::MovableObject& object, bool castersReceive) {
    if (castersReceive && typeid(object) == typeid(Ogre::Entity))
        if (const auto answer = receivesAsMaterials(static_cast<const Ogre::Entity&>(object)))
            return *answer;
    Question question(castersReceive);
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
