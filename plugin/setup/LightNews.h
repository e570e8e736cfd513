#pragma once

#include "fit/problem/ShadowFit.h"
#include "fit/problem/ShadowProblem.h"
#include "setup/News.h"

#include <string>

namespace Ogre {
class Light;
}

namespace Lixel {

/// Whether the log is told of a reason.
bool isTrouble(FitReason reason);

/** What the log is told of one light: each kind of trouble once, and again only after there was
    none for News::Quiet frames. */
class LightNews {
public:
    /// Trouble beside the reasons of fits.
    enum Trouble : unsigned {
        TooFewTextures = 24,
        NoMapsOfItsOwn,
        BodyWithoutBounds,
        MapsDrawnTogether,
        MapsLeftOver,
        OneMapToDivide
    };
    static_assert(static_cast<unsigned>(FitReason::TooFewMaps) < TooFewTextures);

    /// Whether to tell it now.
    bool isNew(Trouble trouble);
    /// A light that happens to shadow nothing is no news; input that cannot be drawn is.
    void tell(const Ogre::Light& light, FitReason reason, const ShadowProblem& problem);
    void tellWithoutBounds(const Ogre::Light& light, const std::string& body);

    /// Its light is asked for in this frame.
    void use();
    /// Whether this can be deleted: it holds nothing that must still be remembered.
    bool isForgettable() const;

    /// Whether "needs more shadow maps than it has" was logged. It is logged only once, as long as
    /// the light is used: each check costs the fits of all parts that got no map.
    bool toldOfParts = false;

private:
    News mNews;
    unsigned long mLastUse = 0;
};

} // namespace Lixel
