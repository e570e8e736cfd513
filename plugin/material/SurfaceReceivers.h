#pragma once

#include <OgreRenderObjectListener.h>
#include <OgreTexture.h>

#include <map>

namespace Ogre {
class Light;
class SceneManager;
} // namespace Ogre

namespace Lixel {

/** Gives surfaces with a shadow receiver material of their own the map of the light being drawn.

    Under the additive and modulative techniques OGRE puts each light's map into the scene manager's
    receiver material alone. A surface's own (`shadow_receiver_material` of its technique) keeps the
    first light's, if its texture unit says `content_type shadow`, else none. So the map is put in
    right before such a surface is drawn: into its unit of that content type, or of the name
    ShadowMap.
*/
class SurfaceReceivers : public Ogre::RenderObjectListener {
public:
    explicit SurfaceReceivers(Ogre::SceneManager& sceneManager) : mManager(sceneManager) {}

    /// Forgets all maps: a new frame, or another viewer.
    void clear();
    void setMap(const Ogre::Light& light, const Ogre::TexturePtr& map) { mMaps[&light] = map; }
    /// Modulative passes are drawn without lights; the next ones are of this one.
    void setModulativeLight(const Ogre::Light* light) { mModulativeLight = light; }

    void notifyRenderSingleObject(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                  const Ogre::AutoParamDataSource* source,
                                  const Ogre::LightList* lights,
                                  bool suppressRenderStateChanges) override;

private:
    Ogre::SceneManager& mManager;
    std::map<const Ogre::Light*, Ogre::TexturePtr> mMaps;
    const Ogre::Light* mModulativeLight = nullptr;
};

} // namespace Lixel
