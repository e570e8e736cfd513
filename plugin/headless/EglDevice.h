#pragma once

#include <string>

namespace Lixel::Headless {

/// Whether EGL has a device that OGRE can draw with when there is no display. If not, @a error says
/// why, and what to do about it.
bool hasEglDevice(std::string& error);

} // namespace Lixel::Headless
