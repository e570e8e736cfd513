#pragma once

namespace Lixel::Samples {

/** Prints how wrong the shadows of each kind of the garden's casters are, with that kind alone
    casting: whole bodies, bodies with holes, what is bent in hardware, and instances.

    Lixel's preset of the scene is drawn, and beside it, in the same views, OGRE's own shadows for
    materials of its shader system, in three maps of the same size.
*/
void printCasters(int width, int height);

} // namespace Lixel::Samples
