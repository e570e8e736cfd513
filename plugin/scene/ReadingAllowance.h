#pragma once

#include <algorithm>
#include <cstddef>

namespace Lixel {

/** Time for reading meshes, spent by counting what is read.

    Times are estimates, in microseconds, of what reading so much costs (MeshReading.cpp), and no
    clock is asked: so that the same frames give the same shapes on every machine, whatever else
    runs on it.
*/
class ReadingAllowance {
public:
    explicit ReadingAllowance(double microseconds) : mLeft(microseconds) {}

    /** Pays for as many of `wanted` things as there is time for, at the price of `each`.

        For one at least where any time is left, or what is dear would never be done.
        @return how many may be done now */
    std::size_t take(std::size_t wanted, double each) {
        if (!(mLeft > 0.0) || wanted == 0) return 0;
        const double most = std::max(mLeft / each, 1.0);
        const std::size_t taken =
            most < static_cast<double>(wanted) ? static_cast<std::size_t>(most) : wanted;
        const double price = static_cast<double>(taken) * each;
        mLeft -= price;
        mSpent += price;
        return taken;
    }

    double spent() const { return mSpent; }

private:
    double mLeft = 0.0;
    double mSpent = 0.0;
};

} // namespace Lixel
