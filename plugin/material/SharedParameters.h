#pragma once

#include "fit/problem/ShadowFit.h"
#include "material/ReceiverParameters.h"

#include <OgreResourceGroupManager.h>

#include <string>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** The sets of shared parameters that Lixel's programs refer to by `shared_params_ref`.

    They are made when scripts begin to be parsed, not by a script: OGRE refuses to make a set
    twice, and so refused to parse a group of scripts anew.

    The functions do nothing where there are no sets yet.
*/
class SharedParameters : public Ogre::ResourceGroupListener {
public:
    SharedParameters();
    ~SharedParameters() override;
    SharedParameters(const SharedParameters&) = delete;
    SharedParameters& operator=(const SharedParameters&) = delete;

    /// Set `Lixel/Caster`: stored depth = lixelCasterDepth.x * clip z + lixelCasterDepth.y, of the
    /// map that is drawn next.
    static void setCasterDepth(const ShadowFit& fit);

    /// Set `Lixel/Fog`: lixelFog (mode as Ogre::FogMode, density, start, end) and lixelFogColour,
    /// of the scene that is drawn next.
    static void setFog(const Ogre::SceneManager& manager);

    /// Set `Lixel/ModulativeReceiver`: the map of the light whose modulative pass comes next.
    static void setModulativeReceiver(const ReceiverParameters& parameters,
                                      const Ogre::Vector4& light);

    /// The set that has a constant of this name. Null where none does.
    static const char* setOf(const std::string& constant);

    void resourceGroupScriptingStarted(const Ogre::String& groupName,
                                       std::size_t scriptCount) override;
    /// Scripts that were parsed may name shadow materials that cannot be drawn.
    void resourceGroupScriptingEnded(const Ogre::String& groupName) override;
};

} // namespace Lixel
