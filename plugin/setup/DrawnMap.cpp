#include "setup/DrawnMap.h"

#include "fit/problem/KeptFit.h"

#include <algorithm>

namespace Lixel {

double wrongnessOf(const DrawnMap& drawn, const ShownMap& wanted, const Fingerprint& light,
                   bool castersChanged) {
    if (castersChanged || drawn.light != light) return 1.0;
    const KeptFit compared =
        compareFits(drawn.shown.fit, wanted.fit, wanted.wsOrigin - drawn.shown.wsOrigin);
    return compared.covers ? std::clamp(compared.coarseness - 1.0, 0.0, 1.0) : 1.0;
}

} // namespace Lixel
