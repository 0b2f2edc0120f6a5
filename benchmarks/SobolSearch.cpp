// Makes irsg/signature/random/SobolTable.inc: for each coordinate the candidate whose pairs with
// all earlier ones have the least sum of squared t-values.

#include <cstdio>
#include <vector>

#include "irsg/signature/random/SobolSequence.h"

int main() {
    constexpr int candidates = 256, firstPower = 4, lastPower = 12;
    std::vector<std::array<std::uint32_t, 32>> kept{irsg::sobolDirections(0, 0)};
    for (int dimension = 1; dimension < irsg::SobolSequence::mostDimensions; ++dimension) {
        long least = -1;
        int best = 0;
        for (int candidate = 0; candidate < candidates; ++candidate) {
            const auto v = irsg::sobolDirections(dimension, candidate);
            long sum = 0;
            for (const auto& earlier : kept)
                for (int m = firstPower; m <= lastPower && (least < 0 || sum < least); ++m) {
                    const long t = irsg::sobolPairQuality(earlier, v, m);
                    sum += t * t;
                }
            if (least < 0 || sum < least) {
                least = sum;
                best = candidate;
            }
        }
        kept.push_back(irsg::sobolDirections(dimension, best));
        std::printf("%d,%c", best, dimension % 16 == 0 ? '\n' : ' ');
        std::fflush(stdout);
    }
    std::printf("\n");
}
