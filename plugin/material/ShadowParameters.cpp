#include "material/ShadowParameters.h"

#include "scene/OgreMath.h"

#include <OgreCamera.h>
#include <OgreGpuProgramManager.h>
#include <OgreLight.h>
#include <OgreSceneManager.h>

#include <cmath>

namespace Lixel {
namespace {

const char* const SharedParameters = "Lixel/ModulativeReceiver";

/// Depth that interpolation and the slope's screen derivatives may be wrong by: depths are at most
/// 1, with 24 bits; where a texel covers 32 pixels, their difference over one pixel is known to
/// 2^-24, and over half a texel to 2^-20. Twice that.
constexpr double RoundingBias = 0x1p-19;

/// What a receiver needs to know of one map.
struct ReceiverParameters {
    Ogre::Vector4 rowU, rowV, rowW, rowDepth, sizeBias, rowShare;
};

/// As many maps of a light as Lixel's materials read: a program keeps zeros, or the last light's
/// values, of what a light does not have.
constexpr std::size_t MostMapsRead = 6;

/// Beyond any depth, and a float.
constexpr Ogre::Real Endless = Ogre::Real(1e30);

/// Parameters under which everything is lit: w is -1 everywhere.
ReceiverParameters lit() {
    const Ogre::Vector4 zero(0, 0, 0, 0);
    return {zero,
            zero,
            Ogre::Vector4(0, 0, 0, -1),
            zero,
            Ogre::Vector4(1, 1, 0, 0),
            Ogre::Vector4(0, 0, 0, -Endless)};
}

Ogre::Vector4 toOgreRow(const Eigen::RowVector4d& row) {
    return {static_cast<Ogre::Real>(row[0]), static_cast<Ogre::Real>(row[1]),
            static_cast<Ogre::Real>(row[2]), static_cast<Ogre::Real>(row[3])};
}

ReceiverParameters receiverParameters(const ShadowMap& map) {
    // Programs see world positions relative to the viewer with camera-relative rendering, else
    // absolute ones; the fit's are relative to wsOrigin. Rounded to float only here.
    const Vec3 wsBase = map.sceneManager.getCameraRelativeRendering()
                            ? toDouble(map.viewer.getDerivedPosition())
                            : Vec3(Vec3::Zero());
    Mat4 originFromBase = Mat4::Identity();
    originFromBase.topRightCorner<3, 1>() = wsBase - map.wsOrigin;
    const Ogre::Vector4 share = toOgreRow(map.part.wsRow.transpose() * originFromBase);
    if (!map.fit.hasMap()) {
        ReceiverParameters none = lit();
        none.rowShare = share;
        return none;
    }
    const Mat4 clip = map.fit.clipFromWorld * originFromBase;

    const Eigen::RowVector4d w = clip.row(3);
    Eigen::RowVector4d depth = map.fit.depthScale * clip.row(2);
    depth[3] += map.fit.depthOffset;
    // OGRE's render textures have v downwards on every render system.
    return {toOgreRow(0.5 * (w + clip.row(0))),
            toOgreRow(0.5 * (w - clip.row(1))),
            toOgreRow(w),
            toOgreRow(depth),
            Ogre::Vector4(
                static_cast<Ogre::Real>(map.width), static_cast<Ogre::Real>(map.height),
                static_cast<Ogre::Real>(map.depthBias * map.fit.depthPerWorldUnit + RoundingBias),
                static_cast<Ogre::Real>(map.fit.depthPerWorldUnit)),
            share};
}

void bind(Ogre::Light& light, std::size_t map, const ReceiverParameters& p) {
    const auto set = [&](LightParameter parameter, const Ogre::Vector4& value) {
        light.setCustomParameter(static_cast<Ogre::uint16>(parameter + LP_MAP_STEP * map), value);
    };
    set(LP_MAP_ROW_U, p.rowU);
    set(LP_MAP_ROW_V, p.rowV);
    set(LP_MAP_ROW_W, p.rowW);
    set(LP_MAP_ROW_DEPTH, p.rowDepth);
    set(LP_MAP_SIZE_BIAS, p.sizeBias);
    set(LP_MAP_ROW_SHARE, p.rowShare);
}

/// Every map's parameters of a light that has none.
void bindLit(Ogre::Light& light) {
    for (std::size_t map = 0; map < MostMapsRead; ++map)
        bind(light, map, lit());
    light.setCustomParameter(LP_SPLIT_DEPTHS, Ogre::Vector4(Endless, Endless, Endless, Endless));
}

} // namespace

/// One scene manager's receivers: unshadowed until a map is fitted, and modulative ones served.
class ShadowParameters::SceneListener : public Ogre::SceneManager::Listener {
public:
    explicit SceneListener(ShadowParameters& owner) : mOwner(owner) {}

    /// A program keeps the last light's value of a custom parameter that the next light lacks, so
    /// every light gets one, which says "lit", before maps are fitted.
    void preUpdateSceneGraph(Ogre::SceneManager* source, Ogre::Camera*) override {
        if (source->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;
        letAllBeLit(*source);
    }

    void letAllBeLit(Ogre::SceneManager& source) {
        mMaps.clear();
        mSplits.clear();
        for (const auto& [name, object] :
             source.getMovableObjects(Ogre::LightFactory::FACTORY_TYPE_NAME))
            bindLit(static_cast<Ogre::Light&>(*object));
    }

    /// Where the map's slice ends, beside those of the maps before it.
    void bindSplit(const ShadowMap& map) {
        Ogre::Vector4& depths =
            mSplits.try_emplace(&map.light, Endless, Endless, Endless, Endless).first->second;
        if (map.iteration < 4 && std::isfinite(map.part.vsEnd))
            depths[map.iteration] = static_cast<Ogre::Real>(map.part.vsEnd);
        map.light.setCustomParameter(LP_SPLIT_DEPTHS, depths);
    }

    void shadowTextureReceiverPreViewProj(Ogre::Light* light, Ogre::Frustum*) override {
        const auto found = mMaps.find(light);
        const ReceiverParameters p = found != mMaps.end() ? found->second : lit();
        const Ogre::GpuSharedParametersPtr shared =
            Ogre::GpuProgramManager::getSingleton().getSharedParameters(SharedParameters);
        shared->setNamedConstant("lixelRowU", p.rowU);
        shared->setNamedConstant("lixelRowV", p.rowV);
        shared->setNamedConstant("lixelRowW", p.rowW);
        shared->setNamedConstant("lixelRowDepth", p.rowDepth);
        shared->setNamedConstant("lixelSizeBias", p.sizeBias);
        shared->setNamedConstant("lixelLight", light->getAs4DVector(true));
    }

    void sceneManagerDestroyed(Ogre::SceneManager* source) override {
        mOwner.mListeners.erase(source); // destroys this
    }

    std::map<const Ogre::Light*, ReceiverParameters> mMaps;
    std::map<const Ogre::Light*, Ogre::Vector4> mSplits;

private:
    ShadowParameters& mOwner;
};

ShadowParameters::ShadowParameters() {
    addShadowMapObserver(*this);
}

ShadowParameters::~ShadowParameters() {
    for (const auto& [manager, listener] : mListeners)
        manager->removeListener(listener.get());
}

void ShadowParameters::shadowMapFitted(const ShadowMap& map) {
    std::unique_ptr<SceneListener>& listener = mListeners[&map.sceneManager];
    if (!listener) {
        listener = std::make_unique<SceneListener>(*this);
        map.sceneManager.addListener(listener.get());
        // The listener is too late for this frame's beginning.
        listener->letAllBeLit(map.sceneManager);
    }
    const ReceiverParameters parameters = receiverParameters(map);
    bind(map.light, map.iteration, parameters);
    listener->bindSplit(map);
    map.light.setCustomParameter(LP_CASTER_DEPTH,
                                 Ogre::Vector4(static_cast<Ogre::Real>(map.fit.depthScale),
                                               static_cast<Ogre::Real>(map.fit.depthOffset), 0, 0));
    // Modulative passes see one map a light.
    if (map.iteration == 0) listener->mMaps[&map.light] = parameters;
}

} // namespace Lixel
