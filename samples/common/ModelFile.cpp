#include "common/ModelFile.h"

#include "common/MeshBuilder.h"
#include "common/ModelGeometry.h"
#include "common/ModelMaterials.h"
#include "common/Surface.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace Lixel::Samples {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

/// Beyond this a float's square, and with it OGRE's bounding spheres, comes close to overflowing.
constexpr double LargestCoordinate = 1e15;

// When a model counts as standing on its own ground; see ModelFile::hasGround.
constexpr double GroundLayer = 0.05;   ///< share of the height
constexpr double GroundSlope = 0.906;  ///< cosine of 25 degrees
constexpr double GroundCoverage = 0.6; ///< share of the footprint's rectangle

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "'" + path + "' " + reason, "ModelFile");
}

bool isUsable(double value) {
    return std::abs(value) <= LargestCoordinate;
} // false for NaN

/// Before any other code works on them: neither Assimp's post-processing nor OGRE survives a NaN.
void refuseBadNumbers(const aiScene& model, const std::string& path) {
    for (unsigned i = 0; i < model.mNumMeshes; ++i) {
        const aiMesh& mesh = *model.mMeshes[i];
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            if (!isUsable(p.x) || !isUsable(p.y) || !isUsable(p.z))
                refuse(path, "has a vertex that is not finite or beyond 1e15: vertex " +
                                 std::to_string(v) + " of mesh '" + mesh.mName.C_Str() + "'");
        }
    }
}

/// Whether anything has three corners; otherwise post-processing fails with less to say.
bool hasFaces(const aiScene& model) {
    for (unsigned i = 0; i < model.mNumMeshes; ++i) {
        const aiMesh& mesh = *model.mMeshes[i];
        const auto isFace = [](const aiFace& face) { return face.mNumIndices >= 3; };
        if (std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, isFace)) return true;
    }
    return false;
}

Vector3d apply(const Matrix4d& matrix, const Vector3d& p) {
    return matrix.topLeftCorner<3, 3>() * p + matrix.topRightCorner<3, 1>();
}

/// Whether what stands below such a node stays within a float.
bool isUsable(const Matrix4d& modelFromNode) {
    return modelFromNode.cwiseAbs().maxCoeff() <= LargestCoordinate &&
           modelFromNode.determinant() > 1.0 / (LargestCoordinate * LargestCoordinate);
}

/// Calls `use(matrix, mesh index, node)` for every mesh of every node, matrices from mesh to model.
template <typename Use>
void forEachInstance(const aiNode& node, const Matrix4d& parent, const Use& use) {
    const Matrix4d matrix = parent * toEigen(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
        use(matrix, node.mMeshes[i], node);
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        forEachInstance(*node.mChildren[i], matrix, use);
}

/// Adds a model's nodes and entities to a scene.
class Builder {
public:
    Builder(const aiScene& model, std::string prefix, Ogre::SceneManager& sceneManager,
            Ogre::SceneNode& root, const std::vector<Ogre::MaterialPtr>& materials)
        : mModel(model),
          mPrefix(std::move(prefix)),
          mSceneManager(sceneManager),
          mRoot(root),
          mMaterials(materials),
          mShared(model.mNumMeshes) {}

    /** Adds a node and those below it.
        @param parent null where an ancestor's transform is none that a node can hold
    */
    void add(const aiNode& node, Ogre::SceneNode* parent, const Matrix4d& modelFromParent) {
        const Matrix4d local = toEigen(node.mTransformation);
        const Matrix4d modelFromNode = modelFromParent * local;
        Ogre::SceneNode* sceneNode = nullptr;
        if (const auto similarity = asSimilarity(local);
            parent && similarity && isUsable(modelFromNode)) {
            sceneNode = parent->createChildSceneNode(similarity->position, similarity->orientation);
            sceneNode->setScale(Ogre::Vector3(similarity->scale));
        }
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            addMeshOf(node.mMeshes[i], sceneNode, modelFromNode);
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            add(*node.mChildren[i], sceneNode, modelFromNode);
    }

private:
    void addMeshOf(unsigned index, Ogre::SceneNode* sceneNode, const Matrix4d& modelFromNode) {
        const aiMesh& mesh = *mModel.mMeshes[index];
        const std::string name = mPrefix + "/mesh" + std::to_string(index);
        Ogre::MeshPtr ogreMesh;
        if (sceneNode) {
            if (!mShared[index]) mShared[index] = makeMesh(name, mesh, Matrix4d::Identity());
            ogreMesh = mShared[index];
        } else {
            ogreMesh = makeMesh(name + "/baked" + std::to_string(mBaked++), mesh, modelFromNode);
        }
        if (!ogreMesh) return;
        Ogre::Entity* entity = mSceneManager.createEntity(ogreMesh);
        entity->setMaterial(mMaterials[mesh.mMaterialIndex]);
        (sceneNode ? *sceneNode : mRoot).attachObject(entity);
    }

    /// Null for a mesh of points and lines.
    Ogre::MeshPtr makeMesh(const std::string& name, const aiMesh& mesh, const Matrix4d& baked) {
        MeshBuilder builder;
        addMesh(builder, mesh, baked, isTwoSided(*mModel.mMaterials[mesh.mMaterialIndex]));
        return builder.empty() ? Ogre::MeshPtr() : builder.build(name);
    }

    const aiScene& mModel;
    std::string mPrefix;
    Ogre::SceneManager& mSceneManager;
    Ogre::SceneNode& mRoot;
    const std::vector<Ogre::MaterialPtr>& mMaterials;
    std::vector<Ogre::MeshPtr> mShared; ///< by mesh index, those used below an OGRE node
    int mBaked = 0;
};

} // namespace

struct ModelFile::Impl {
    std::string path;
    Assimp::Importer importer; ///< owns the model
    const aiScene* model = nullptr;
    AlignedBox3d bounds;
    Ogre::AxisAlignedBox box;
    std::size_t triangles = 0;
    bool hasGround = false;

    explicit Impl(std::string file) : path(std::move(file)) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored))
            OGRE_EXCEPT(Ogre::Exception::ERR_FILE_NOT_FOUND, "there is no file '" + path + "'",
                        "ModelFile");
        read();
        measure();
        const double footprint = bounds.sizes().x() * bounds.sizes().z();
        hasGround = footprint > 0.0 && groundArea() >= GroundCoverage * footprint;
    }

    void read() {
        importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                    aiPrimitiveType_POINT | aiPrimitiveType_LINE);
        importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 50.0F);
        importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
        model = importer.ReadFile(path, 0);
        if (!model) refuse(path, std::string("cannot be read: ") + importer.GetErrorString());
        refuseBadNumbers(*model, path);
        if (!model->mRootNode || !hasFaces(*model)) refuse(path, "holds no triangles");
        // First without what is not shown, so that a broken light or animation does no harm.
        importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                    aiComponent_LIGHTS | aiComponent_CAMERAS |
                                        aiComponent_ANIMATIONS | aiComponent_BONEWEIGHTS);
        model = importer.ApplyPostProcessing(aiProcess_RemoveComponent);
        if (model)
            model = importer.ApplyPostProcessing(
                aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices | aiProcess_FlipUVs);
        if (!model) refuse(path, std::string("is broken: ") + importer.GetErrorString());
    }

    void measure() {
        forEachInstance(
            *model->mRootNode, Matrix4d::Identity(),
            [&](const Matrix4d& matrix, unsigned index, const aiNode& node) {
                if (index >= model->mNumMeshes ||
                    model->mMeshes[index]->mMaterialIndex >= model->mNumMaterials)
                    refuse(path, std::string("names a mesh or material that it does not hold"));
                forEachTriangle(*model->mMeshes[index], [&](const Vector3d& a, const Vector3d& b,
                                                            const Vector3d& c) {
                    ++triangles;
                    for (const Vector3d& p :
                         {apply(matrix, a), apply(matrix, b), apply(matrix, c)}) {
                        if (!isUsable(p.x()) || !isUsable(p.y()) || !isUsable(p.z()))
                            refuse(path,
                                   std::string("has a node that moves its mesh beyond 1e15 or "
                                               "to no finite place: '") +
                                       node.mName.C_Str() + "'");
                        bounds.extend(p);
                    }
                });
            });
        if (triangles == 0) refuse(path, "holds no triangles");
        if (!(bounds.diagonal().norm() > 1e-30))
            refuse(path, "has no extent: all its triangles are one point");
        const auto corner = [](const Vector3d& p) {
            return Ogre::Vector3(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                 static_cast<float>(p.z()));
        };
        box.setExtents(corner(bounds.min()), corner(bounds.max()));
    }

    /// Area, seen from above, of what faces up in the lowest layer.
    double groundArea() const {
        const double top = bounds.min().y() + GroundLayer * bounds.sizes().y();
        double area = 0.0;
        forEachInstance(*model->mRootNode, Matrix4d::Identity(),
                        [&](const Matrix4d& matrix, unsigned index, const aiNode&) {
                            forEachTriangle(*model->mMeshes[index],
                                            [&](Vector3d a, Vector3d b, Vector3d c) {
                                                a = apply(matrix, a);
                                                b = apply(matrix, b);
                                                c = apply(matrix, c);
                                                const Vector3d cross = 0.5 * (b - a).cross(c - a);
                                                if (std::max({a.y(), b.y(), c.y()}) <= top &&
                                                    cross.y() > GroundSlope * cross.norm())
                                                    area += cross.y();
                                            });
                        });
        return area;
    }

    /// A plain square under the model, as wide as its longest shadows at a low sun.
    void addGround(Ogre::SceneManager& sceneManager, Ogre::SceneNode& node,
                   const std::string& prefix) const {
        constexpr float Built = 20.0F; // five repetitions of the texture, whatever the model's size
        const Ogre::Vector3 size = box.getSize();
        const float halfSide = 1.5F * std::max(size.x, size.z) + 4.0F * size.y;
        Ogre::Vector3 middle = box.getCenter();
        middle.y = box.getMinimum().y;
        MeshBuilder ground;
        ground.transform =
            Ogre::Affine3(middle, Ogre::Quaternion::IDENTITY, Ogre::Vector3(halfSide / Built));
        ground.ground(Built, 32);
        Ogre::Entity* entity = sceneManager.createEntity(ground.build(prefix + "/ground"));
        entity->setMaterial(makeSurface(prefix + "/ground", Ogre::ColourValue(0.68F, 0.68F, 0.62F),
                                        patternTexture(Pattern::Grain)));
        entity->setCastShadows(false);
        node.attachObject(entity);
    }
};

ModelFile::ModelFile(const std::string& path) : mImpl(std::make_unique<Impl>(path)) {}
ModelFile::~ModelFile() = default;
ModelFile::ModelFile(ModelFile&&) noexcept = default;
ModelFile& ModelFile::operator=(ModelFile&&) noexcept = default;

const Ogre::AxisAlignedBox& ModelFile::box() const {
    return mImpl->box;
}
std::size_t ModelFile::triangles() const {
    return mImpl->triangles;
}
bool ModelFile::hasGround() const {
    return mImpl->hasGround;
}

ImportedModel ModelFile::addTo(Ogre::SceneManager& sceneManager, Ogre::SceneNode& parent) const {
    const std::string prefix = "Lixel/Model/" + mImpl->path;
    ImportedModel result;
    result.box = mImpl->box;
    result.triangles = mImpl->triangles;
    const std::string directory = std::filesystem::path(mImpl->path).parent_path().string();
    const auto materials = makeModelMaterials(*mImpl->model, prefix, directory, result.notes);
    result.node = parent.createChildSceneNode();
    Builder(*mImpl->model, prefix, sceneManager, *result.node, materials)
        .add(*mImpl->model->mRootNode, result.node, Matrix4d::Identity());
    if (!mImpl->hasGround) {
        mImpl->addGround(sceneManager, *result.node, prefix);
        result.groundAdded = true;
    }
    return result;
}

ImportedModel importModel(Ogre::SceneManager& sceneManager, Ogre::SceneNode& parent,
                          const std::string& path) {
    return ModelFile(path).addTo(sceneManager, parent);
}

} // namespace Lixel::Samples
