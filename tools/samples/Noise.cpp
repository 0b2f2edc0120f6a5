#include "tools/samples/Noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace smat {

namespace {

/// A finaliser of 32 bits in the manner of MurmurHash3 over the three coordinates.
double latticeValue(int x, int y, int z) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343u ^
                      static_cast<std::uint32_t>(y) * 0xd8163841u ^
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
    return static_cast<double>(h) / 4294967295.0;
}

double eased(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

} // namespace

double smoothNoise(double x, double y, double z) {
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y)),
              iz = static_cast<int>(std::floor(z));
    const double tx = eased(x - ix), ty = eased(y - iy), tz = eased(z - iz);
    const auto alongX = [&](int dy, int dz) {
        return std::lerp(latticeValue(ix, iy + dy, iz + dz), latticeValue(ix + 1, iy + dy, iz + dz),
                         tx);
    };
    return std::lerp(std::lerp(alongX(0, 0), alongX(1, 0), ty),
                     std::lerp(alongX(0, 1), alongX(1, 1), ty), tz);
}

double fractalNoise(double x, double y, double z, int octaves) {
    double sum = 0.0, weight = 1.0, all = 0.0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * smoothNoise(x, y, z);
        all += weight;
        weight *= 0.5;
        // Turned a little, so that the lattices of the octaves do not lie on each other.
        const double turnedX = 1.6 * x - 1.2 * y, turnedY = 1.2 * x + 1.6 * y;
        x = turnedX + 17.3;
        y = turnedY - 9.7;
        z = 2.0 * z + 31.1;
    }
    return sum / all;
}

double smoothStep(double low, double high, double value) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace smat
