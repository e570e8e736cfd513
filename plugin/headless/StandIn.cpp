#include "Lixel/headless/StandIn.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace Lixel::Headless {
namespace {

/// OGRE reads a Display through Xlib's macros, that is as this structure.
using PublicDisplay = std::remove_pointer_t<_XPrivDisplay>;

} // namespace

void Surface::growTo(unsigned newWidth, unsigned newHeight) {
    width = std::clamp(newWidth, width, maxSide);
    height = std::clamp(newHeight, height, maxSide);
}

State& state() {
    // Never destroyed: a static destructor would run after OSMesa's own exit handler.
    static State& theState = *new State;
    return theState;
}

bool isServed() {
    return state().mesa.has_value();
}

Display* standIn() {
    static char name[displayName.size() + 1] = {}; // Xlib's structure wants it mutable
    static Screen screen = {};
    static PublicDisplay display = [] {
        displayName.copy(name, displayName.size());
        screen.root = 1;
        // The size of the desktop: OGRE offers it as the only video mode.
        screen.width = 1920;
        screen.height = 1080;
        PublicDisplay made = {};
        made.screens = &screen;
        made.nscreens = 1;
        made.display_name = name;
        return made;
    }();
    return reinterpret_cast<Display*>(&display);
}

bool makeCurrent(Surface* surface) {
    const OSMesa& mesa = *state().mesa;
    if (!surface) return mesa.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    const std::size_t size = std::size_t{surface->width} * surface->height;
    std::vector<std::uint32_t> replaced; // lives on until OSMesa has let go of it
    if (surface->pixels.size() != size)
        replaced = std::exchange(surface->pixels, std::vector<std::uint32_t>(size));
    return mesa.makeCurrent(surface->context, surface->pixels.data(), GL_UNSIGNED_BYTE,
                            static_cast<GLsizei>(surface->width),
                            static_cast<GLsizei>(surface->height));
}

Surface* currentSurface() {
    State& s = state();
    const OSMesaContext current = s.mesa->getCurrentContext();
    const auto found =
        std::find_if(s.surfaces.begin(), s.surfaces.end(),
                     [current](const Surface& surface) { return surface.context == current; });
    return found == s.surfaces.end() ? nullptr : &*found;
}

} // namespace Lixel::Headless
