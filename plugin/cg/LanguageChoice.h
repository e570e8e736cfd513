#pragma once

#include <OgreScriptTranslator.h>

#include <set>

namespace Lixel::Cg {

/// Has a program that a script declares in several languages, such as `vertex_program Name hlsl
/// glsl`, made in GLSL where that is one of them. OGRE takes the first language that there is, and
/// such scripts mean HLSL for Direct3D.
///
/// It translates nothing itself: it takes languages out of a declaration before OGRE reads it.
class LanguageChoice : public Ogre::ScriptTranslatorManager {
public:
    /// A language that is there by this room.
    void add(const Ogre::String& language) { mLanguages.insert(language); }
    void clear() { mLanguages.clear(); }

    Ogre::ScriptTranslator* getTranslator(const Ogre::AbstractNodePtr& node) override;

private:
    std::set<Ogre::String> mLanguages;
};

} // namespace Lixel::Cg
