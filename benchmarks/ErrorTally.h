#pragma once

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/RandomScenes.h"

namespace irsg::bench {

/// The upper median; 0 of nothing.
inline double median(std::vector<double> values) {
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// How many numbers are within their stated errors, and how much larger those are than the true
/// ones.
struct ErrorTally {
    int count = 0, covered = 0;
    std::vector<double> ratios;

    void add(const test::JudgedNumber& one) {
        ++count;
        covered += one.isCovered() ? 1 : 0;
        ratios.push_back(one.wrong() > 0.0 ? one.error.sum() / one.wrong()
                                           : std::numeric_limits<double>::infinity());
    }
    static void printHead() {
        std::printf("| numbers | count | within the error | stated over true error, median |\n"
                    "|---|---|---|---|\n");
    }
    void print(const std::string& name) const {
        std::printf("| %s | %d | %.1f %% | %.2f |\n", name.c_str(), count,
                    count > 0 ? 100.0 * covered / count : 0.0, median(ratios));
    }
};

} // namespace irsg::bench
