#pragma once

#include "setup/ShadowMapObserver.h"

#include <memory>

namespace Ogre {
class SceneManager;
} // namespace Ogre

namespace Lixel {
/// @addtogroup LixelMaterials
/// @{

class SharedParameters;

/** Custom parameters of a light that carry its shadow map to programs.

    In a script: `param_named_auto NAME light_custom N` with N = index * 65536 + the light's index
    in the pass (0 in a per-light pass). materials/README.md lists the numbers.
*/
enum LightParameter : unsigned short {
    /// Rows of the receiver's matrix: (u w, v w, w, depth) from a world position, u and v in
    /// texture coordinates. w <= 0 means "not in the map", so lit.
    LP_MAP_ROW_U = 100,
    LP_MAP_ROW_V = 101,
    LP_MAP_ROW_W = 102,
    LP_MAP_ROW_DEPTH = 103,
    /// (width, height, depth bias in units of stored depth, depth per world unit).
    LP_MAP_SIZE_BIAS = 104,
    /// Stored depth = x * clip z + y, for casters. OGRE draws casters without lights since 13.3.2:
    /// the shared parameters `Lixel/Caster` hold the same and reach them in every version.
    LP_CASTER_DEPTH = 105,
    /// Row whose product with a world position is greatest for the map that serves the position, of
    /// all maps of the light.
    LP_MAP_ROW_SHARE = 106,
    /// Depths in front of the viewer at which the light's first four slices end, in world units;
    /// 1e30 for the last slice's.
    LP_SPLIT_DEPTHS = 107,
    /// The light's maps after the first have the numbers LP_MAP_ROW_U to LP_MAP_SIZE_BIAS and
    /// LP_MAP_ROW_SHARE plus 10 times the map's index.
    LP_MAP_STEP = 10,
};

/** Binds each shadow map to the materials that use it, by itself.

    Light custom parameters reach additive and integrated receivers. Modulative receivers, which
    OGRE draws without lights, read the shared parameters `Lixel/ModulativeReceiver`, set right
    before each of their passes; casters read `Lixel/Caster`, set right before each map is drawn.
    The scene manager's fog is in `Lixel/Fog`. Under the additive and modulative techniques,
    surfaces with a `shadow_receiver_material` of their own get the map of the light that is drawn.
*/
class LIXEL_API ShadowParameters : public ShadowMapObserver {
public:
    ShadowParameters();
    ~ShadowParameters() override;
    void shadowMapFitted(const ShadowMap& map) override;

    /// Starts to serve a scene manager: binds its fog, and tells its lights that they have no map.
    /// Serving one twice has no effect. The plugin serves all of them before every frame.
    void serve(Ogre::SceneManager& manager);

private:
    class SceneListener;
    class Scenes;
    SceneListener& listenerOf(Ogre::SceneManager& manager);
    std::unique_ptr<SharedParameters> mShared;
    std::unique_ptr<Scenes> mScenes;
};

/// @}
} // namespace Lixel
