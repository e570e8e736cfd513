// Manual objects, whose bounds are those of what was drawn last.
#include "Operation.h"

#include "Materials.h"

#include <OgreManualObject.h>

namespace Lixel::Tests {
namespace {

void drawTriangle(Ogre::ManualObject& object, Random& random) {
    for (int corner = 0; corner < 3; ++corner)
        object.position(anyPlace(random, 2));
}

std::string createManualObject(World& world, Random& random) {
    if (world.objects.size() > 60) return "";
    const std::string name = world.newName("manual");
    Ogre::ManualObject* object = world.manager().createManualObject(name);
    world.add(*object, name);
    object->setDynamic(true);
    for (std::size_t section = 0; section < 1 + random.below(2); ++section) {
        object->begin(materials()[random.below(materials().size())],
                      Ogre::RenderOperation::OT_TRIANGLE_LIST);
        drawTriangle(*object, random);
        object->end();
    }
    anyNode(world, random).node->attachObject(object);
    return "create " + name;
}

std::string redraw(World& world, Random& random) {
    const Found<Ogre::ManualObject> object = anyOfType<Ogre::ManualObject>(world, random);
    if (!object) return "";
    if (object->getSections().empty() || random.oneIn(2)) {
        object->clear();
        object->begin("lit", Ogre::RenderOperation::OT_TRIANGLE_LIST);
    } else {
        object->beginUpdate(0);
    }
    drawTriangle(*object.object, random);
    object->end();
    return "redraw " + object.name;
}

std::string wipe(World& world, Random& random) {
    const Found<Ogre::ManualObject> object = anyOfType<Ogre::ManualObject>(world, random);
    if (!object) return "";
    object->clear();
    return "wipe " + object.name;
}

std::string setOwnBox(World& world, Random& random) {
    const Found<Ogre::ManualObject> object = anyOfType<Ogre::ManualObject>(world, random);
    if (!object) return "";
    const bool infinite = random.oneIn(3) && !world.drawsBoxes;
    world.hasInfinite = world.hasInfinite || infinite;
    object->setBoundingBox(infinite ? Ogre::AxisAlignedBox(Ogre::AxisAlignedBox::EXTENT_INFINITE)
                                    : Ogre::AxisAlignedBox(-1, -1, -1, 1, 2, 1));
    if (object->isAttached()) object->getParentNode()->needUpdate();
    return (infinite ? "infinite box of " : "small box of ") + object.name;
}

std::string setView(World& world, Random& random) {
    const Found<Ogre::ManualObject> object = anyOfType<Ogre::ManualObject>(world, random);
    if (!object) return "";
    object->setUseIdentityView(random.oneIn(4));
    return "identity view of " + object.name;
}

} // namespace

void addDrawnByHandOperations(Operations& all) {
    all.insert(all.end(), {{"create a manual object", 4, createManualObject},
                           {"redraw a manual object", 4, redraw},
                           {"wipe a manual object", 2, wipe},
                           {"set a manual object's box", 2, setOwnBox},
                           {"set a manual object's view", 3, setView}});
}

} // namespace Lixel::Tests
