#pragma once

// Answered by OSMesa.
extern "C" void (*glXGetProcAddressARB(const unsigned char*))();

namespace Lixel::Tests {

/// Waits until everything drawn is drawn.
inline void finishDrawing() {
    const auto name = reinterpret_cast<const unsigned char*>("glFinish");
    reinterpret_cast<void (*)()>(glXGetProcAddressARB(name))();
}

} // namespace Lixel::Tests
