// What happens to bodies and their nodes.

#include "BodyDeeds.h"

namespace Lixel::Tests {
namespace {

constexpr std::size_t MostBodies = 20;

std::string create(Application& application, World& world, Random& random) {
    if (world.bodies.size() >= MostBodies) return {};
    const std::string& mesh = Application::meshes()[random.below(Application::meshes().size())];
    Ogre::Entity& body = application.addBody(world, mesh);
    body.getParentSceneNode()->setPosition(anyPlace(random, 9, 0.5F, 6));
    body.getParentSceneNode()->setOrientation(anyTurn(random));
    return body.getName() + " of " + mesh;
}

std::string destroy(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr) return {};
    std::string name = body->getName();
    std::erase(world.bodies, body);
    world.manager->destroyEntity(body);
    return name;
}

/// Puts what lost its node on a new one.
std::string attach(Application&, World& world, Random& random) {
    for (Ogre::Entity* const body : world.bodies) {
        if (body->getParentNode() != nullptr) continue;
        Ogre::SceneNode* const node = world.manager->getRootSceneNode()->createChildSceneNode();
        node->setPosition(anyPlace(random, 9, 0.5F, 6));
        node->setScale(Application::unitScale(*body));
        node->attachObject(body);
        return body->getName();
    }
    return {};
}

std::string detach(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr || body->getParentNode() == nullptr) return {};
    body->detachFromParent();
    return body->getName();
}

std::string move(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr || body->getParentNode() == nullptr) return {};
    body->getParentSceneNode()->setPosition(anyPlace(random, 9, 0.5F, 6));
    return body->getName();
}

std::string turn(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr || body->getParentNode() == nullptr) return {};
    body->getParentSceneNode()->setOrientation(anyTurn(random));
    return body->getName();
}

std::string scale(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr || body->getParentNode() == nullptr) return {};
    const auto side = [&] {
        return random.of({0.01F, 0.5F, 1.0F, 1.0F, 2.0F}) * random.of({-1.0F, 1.0F, 1.0F});
    };
    Ogre::Vector3 factor;
    for (std::size_t i = 0; i < 3; ++i)
        factor[i] = side();
    // A flat body has no normals to be lit by; a point shows none.
    if (random.oneIn(8)) factor = Ogre::Vector3::ZERO;
    factor *= Application::unitScale(*body);
    body->getParentSceneNode()->setScale(factor);
    return body->getName() + " by " + text(factor);
}

std::string adopt(Application&, World& world, Random& random) {
    Ogre::Entity* const child = anyBody(world, random);
    Ogre::Entity* const parent = anyBody(world, random);
    if (child == nullptr || child->getParentNode() == nullptr || parent->getParentNode() == nullptr)
        return {};
    // Its own descendants cannot take a node.
    for (const Ogre::Node* node = parent->getParentNode(); node != nullptr;
         node = node->getParent())
        if (node == child->getParentNode()) return {};
    Ogre::SceneNode* const node = child->getParentSceneNode();
    node->getParentSceneNode()->removeChild(node);
    // Where the parent is small its children are, too.
    if (random.oneIn(2))
        world.manager->getRootSceneNode()->addChild(node);
    else
        parent->getParentSceneNode()->addChild(node);
    return child->getName() + " by " + parent->getName();
}

std::string destroyNode(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr || body->getParentNode() == nullptr) return {};
    Ogre::SceneNode* const node = body->getParentSceneNode();
    node->removeAndDestroyAllChildren();
    node->getParentSceneNode()->removeAndDestroyChild(node);
    return body->getName() + "'s";
}

std::string setFlags(Application&, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr) return {};
    switch (random.below(5)) {
    case 0:
        body->setCastShadows(!random.oneIn(4));
        return body->getName() + " casts";
    case 1:
        body->setVisible(!random.oneIn(4));
        return body->getName() + " is seen";
    case 2:
        body->setVisibilityFlags(random.of({1U, 2U, 3U, 0xFFFFFFFFU, 0xFFFFFFFFU}));
        return body->getName() + " visibility flags";
    case 3:
        body->setRenderingDistance(random.of({0.0F, 0.0F, 0.0F, 8.0F, 15.0F}));
        return body->getName() + " rendering distance";
    default:
        body->setRenderQueueGroup(random.of<Ogre::uint8>({40, 50, 50, 60}));
        return body->getName() + " queue group";
    }
}

std::string change(Application& application, World& world, Random& random) {
    Ogre::Entity* const body = anyBody(world, random);
    if (body == nullptr) return {};
    if (random.oneIn(2)) {
        const Ogre::MaterialPtr material = body->getSubEntity(0)->getMaterial();
        material->setReceiveShadows(!material->getReceiveShadows());
        return material->getName() + " receives shadows or not";
    }
    // As in Application::dress, which keeps who ignores shadows.
    const Ogre::MaterialPtr other = Ogre::MaterialManager::getSingleton().getByName(
        random.oneIn(3) ? "Stress/Ignores" : "Stress/Receives");
    if (!other) return {};
    body->setMaterial(other);
    application.dress(world);
    return body->getName() + " material";
}

} // namespace

const std::vector<Deed>& bodyDeeds() {
    static const std::vector<Deed> deeds{
        {"create body", 14, create},      {"destroy body", 7, destroy},
        {"attach body", 12, attach},      {"detach body", 3, detach},
        {"move body", 14, move},          {"turn body", 7, turn},
        {"scale body", 6, scale},         {"reparent body", 5, adopt},
        {"destroy node", 2, destroyNode}, {"flags of body", 10, setFlags},
        {"material", 4, change},
    };
    return deeds;
}

} // namespace Lixel::Tests
