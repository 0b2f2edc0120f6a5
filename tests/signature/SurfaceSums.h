#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/SurfaceModels.h"

// What surfaces send over the hemisphere, by sums of the tests' own.

namespace irsg::test {

inline SurfaceDirection direction(double angle_deg, double azimuth_deg = 0.0) {
    const double sine = std::sin(radians(angle_deg));
    return {sine * std::cos(radians(azimuth_deg)), sine * std::sin(radians(azimuth_deg)),
            std::cos(radians(angle_deg))};
}

using Brdf = std::function<double(const SurfaceDirection& to)>;

/// The integral over the hemisphere of what is sent, with the cosine as weight: dense about the
/// mirror direction of an incidence, polar angles and azimuths about it.
inline double sentInAll(double incidence_deg, const Brdf& brdf) {
    constexpr int rings = 2000, places = 180;
    const SurfaceDirection mirror = direction(incidence_deg);
    const SurfaceDirection across = direction(incidence_deg + 90.0); // in the plane of incidence
    double sum = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        // Cubes: rings are close together about the mirror direction.
        const double x = (ring + 0.5) / rings, polar = pi * x * x * x;
        const double step = pi * 3.0 * x * x / rings;
        for (int place = 0; place < places; ++place) {
            const double around = pi * (place + 0.5) / places; // both sides are alike
            const double side = std::sin(polar) * std::sin(around);
            const double along = std::sin(polar) * std::cos(around);
            const SurfaceDirection to{mirror.x * std::cos(polar) + across.x * along, side,
                                      mirror.z * std::cos(polar) + across.z * along};
            if (to.z > 0.0) {
                sum += brdf(to) * to.z * std::sin(polar) * step * 2.0 * pi / places;
            }
        }
    }
    return sum;
}

inline double reflectedOf(const Material& material, double incidence_deg) {
    const auto model = surfaceModelOf(material);
    const SurfaceModel::Amounts amounts = model->amountsAt(material, 4.0);
    const SurfaceDirection from = direction(incidence_deg, 180.0);
    return sentInAll(incidence_deg, [&](const SurfaceDirection& to) {
        double sum = 0.0;
        for (std::size_t k = 0; k < model->components(); ++k) {
            sum += amounts[k] * model->brdf_per_sr(k, to, from);
        }
        return sum;
    });
}

/// Equal on every machine, in [0, 1).
struct DirectionSamples {
    std::uint64_t state = 99;
    double next() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) / 9007199254740992.0;
    }
    SurfaceDirection direction() {
        const double cosine = next(), angle = 2.0 * pi * next();
        const double sine = std::sqrt(1.0 - cosine * cosine);
        return {sine * std::cos(angle), sine * std::sin(angle), cosine};
    }
};

/// The largest |f(a, b) - f(b, a)| over their mean, over 10,000 pairs of directions.
inline double worstReciprocity(const Material& material) {
    DirectionSamples draws;
    double worst = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const SurfaceDirection a = draws.direction(), b = draws.direction();
        const double there = brdf_per_sr(material, a, b, 4.0);
        const double back = brdf_per_sr(material, b, a, 4.0);
        if (there + back > 1e-9) {
            worst = std::max(worst, 2.0 * std::abs(there - back) / (there + back));
        }
    }
    return worst;
}

inline std::string findingsOf(const Material& material) {
    SignatureDatabase database;
    database.materials[1] = material;
    std::string text;
    for (const Finding& finding : lint(database)) {
        text += finding.place + ": " + finding.value + " (" + finding.reason + ")\n";
    }
    return text;
}

} // namespace irsg::test
