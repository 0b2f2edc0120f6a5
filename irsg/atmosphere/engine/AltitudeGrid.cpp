#include "irsg/atmosphere/engine/AltitudeGrid.h"

#include <algorithm>
#include <cmath>

namespace irsg {

namespace {

/// An ordered set of altitudes between 0 and a top, none close to another.
class Altitudes {
  public:
    explicit Altitudes(double top_m) : values_{0.0, top_m} {}

    void add(double altitude_m) {
        constexpr double closest_m = 0.5;
        if (altitude_m <= 0.0 || altitude_m >= values_.back() ||
            values_.size() >= mostTransferAltitudes)
            return;
        const auto above = std::ranges::lower_bound(values_, altitude_m);
        if (*above - altitude_m >= closest_m && altitude_m - *(above - 1) >= closest_m)
            values_.insert(above, altitude_m);
    }
    std::vector<double> values() && { return std::move(values_); }

  private:
    std::vector<double> values_;
};

void addSteps(Altitudes& altitudes) {
    struct Part {
        double from_m, to_m, step_m;
    };
    constexpr Part parts[] = {{200.0, 2000.0, 200.0}, {2000.0, 5000.0, 250.0},
                              {5000.0, 12e3, 500.0},  {12e3, 30e3, 1000.0},
                              {30e3, 50e3, 2000.0},   {50e3, 70e3, 4000.0},
                              {70e3, 120e3, 5000.0}};
    for (const Part& part : parts)
        for (double z = part.from_m; z < part.to_m; z += part.step_m)
            altitudes.add(z);
}

} // namespace

std::vector<double> transferAltitudes_m(const Profile& profile,
                                        const std::vector<ParticleLayer>& particles) {
    Altitudes altitudes(profile.top_m());
    // Ends of particles first: nothing may come too close to an edge of a cloud.
    for (const ParticleLayer& layer : particles) {
        if (layer.altitudes_m.empty())
            continue;
        altitudes.add(layer.altitudes_m.front());
        altitudes.add(layer.altitudes_m.back());
        if (layer.extinction550_per_m.front() > 0.0)
            altitudes.add(layer.altitudes_m.front() - 1.0);
        if (layer.extinction550_per_m.back() > 0.0)
            altitudes.add(layer.altitudes_m.back() + 1.0);
    }
    addSteps(altitudes);
    for (const ParticleLayer& layer : particles)
        for (const double z : layer.altitudes_m)
            altitudes.add(z);
    return std::move(altitudes).values();
}

} // namespace irsg
