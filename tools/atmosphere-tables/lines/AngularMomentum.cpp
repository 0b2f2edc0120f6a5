#include "tools/atmosphere-tables/lines/AngularMomentum.h"

#include <cmath>
#include <cstdlib>

namespace irsg::lbl {

double clebschGordan(int J, int k, int q, int upperJ) {
    const int sum = k + q;
    if (upperJ < 0 || std::abs(upperJ - J) > 1 || (upperJ == 0 && J == 0) ||
        std::abs(sum) > upperJ || std::abs(k) > J || std::abs(q) > 1)
        return 0.0;
    const double j = J, m = sum;
    if (upperJ == J + 1) {
        const double all = (2.0 * j + 1.0) * (2.0 * j + 2.0);
        if (q == 1)
            return std::sqrt((j + m) * (j + m + 1.0) / all);
        if (q == -1)
            return std::sqrt((j - m) * (j - m + 1.0) / all);
        return std::sqrt(2.0 * (j - m + 1.0) * (j + m + 1.0) / all);
    }
    if (upperJ == J) {
        const double all = 2.0 * j * (j + 1.0);
        if (q == 1)
            return -std::sqrt((j + m) * (j - m + 1.0) / all);
        if (q == -1)
            return std::sqrt((j - m) * (j + m + 1.0) / all);
        return m * std::sqrt(2.0 / all);
    }
    const double all = 2.0 * j * (2.0 * j + 1.0);
    if (q == 1)
        return std::sqrt((j - m) * (j - m + 1.0) / all);
    if (q == -1)
        return std::sqrt((j + m + 1.0) * (j + m) / all);
    return -std::sqrt(2.0 * (j - m) * (j + m) / all);
}

} // namespace irsg::lbl
