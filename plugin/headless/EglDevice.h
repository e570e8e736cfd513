#pragma once

#include <string>

namespace Lixel::Headless {

/// Whether EGL has a device that OGRE can draw with when there is no display. If not, @a error says
/// why, and what to do about it.
/// @param library EGL's, a name or a path as dlopen() takes it
bool hasEglDevice(std::string& error, const char* library = "libEGL.so.1");

} // namespace Lixel::Headless
