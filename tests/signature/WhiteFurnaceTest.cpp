// White furnace and reciprocity of every surface model, over 10,000 pairs of directions each.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/signature/SurfaceSums.h"

namespace irsg {

namespace {

using namespace test;

constexpr int pairs = 10000;

struct Surface {
    std::string name;
    Material material;
    /// Whether its published form sends what falls on it, and the same either way.
    bool isWhite = true, isReciprocal = true;
};

Surface facets(const char* model, double roughness, bool usesIndex) {
    Surface surface;
    surface.name = std::string(model) + ", roughness " + std::to_string(roughness) +
                   (usesIndex ? ", n and k" : "");
    surface.material.surfaceModel = model;
    surface.material.roughness = roughness;
    surface.material.emissivity = Spectrum::constant(0.0);
    if (usesIndex) { // a body whose Fresnel curve is 1 to 4e-6 at every angle
        surface.material.refractiveIndex = Spectrum::constant(1.0);
        surface.material.extinction = Spectrum::constant(1e6);
    }
    return surface;
}

Surface paint(double diffuse, double width, double b) {
    Surface surface;
    surface.name = "sandfordRobertson, rho_D " + std::to_string(diffuse);
    surface.material.surfaceModel = "sandfordRobertson";
    surface.material.emissivity = Spectrum::constant(0.0);
    surface.material.diffuseReflectivity = Spectrum::constant(diffuse);
    surface.material.roughness = width;
    surface.material.grazingFactor = b;
    surface.isReciprocal = false;
    return surface;
}

Surface table(bool isBrdf) {
    Surface surface;
    surface.name = isBrdf ? "tabulated, BRDF" : "tabulated, reflectance";
    surface.material.surfaceModel = "tabulated";
    std::vector<ReflectanceTable::Row> rows;
    for (const double incidence_deg : {0.0, 30.0, 60.0, 90.0}) {
        if (!isBrdf) {
            rows.push_back({incidence_deg, 0.0, 0.0, {1.0}});
            continue;
        }
        for (const double reflection_deg : {0.0, 45.0, 90.0}) {
            for (const double azimuth_deg : {0.0, 180.0}) {
                rows.push_back({incidence_deg, reflection_deg, azimuth_deg, {1.0 / pi}});
            }
        }
    }
    surface.material.reflectanceTable = {isBrdf, {4.0}, std::move(rows)};
    return surface;
}

std::vector<Surface> surfaces() {
    std::vector<Surface> all;
    for (const char* model : {"ggx", "beckmann"}) {
        for (const double roughness : {0.05, 0.2, 0.7}) {
            all.push_back(facets(model, roughness, false));
        }
        all.push_back(facets(model, 0.2, true));
    }
    all.push_back(paint(0.0, 0.2, 0.3));
    all.push_back(paint(0.4, 0.4, 0.5));
    all.push_back(table(false));
    all.push_back(table(true));
    Surface shell;
    shell.name = "shellTarget";
    shell.material.surfaceModel = "shellTarget";
    shell.material.roughness = 0.2;
    shell.material.refractiveIndex = Spectrum::constant(1.0);
    shell.material.extinction = Spectrum::constant(1e6);
    shell.isWhite = false;
    all.push_back(shell);
    return all;
}

using Brdfs = std::function<double(const SurfaceDirection& to, bool ofLobes)>;

/// What a lobe sends of light from one direction, by facets about the half way: by midpoints of
/// rings of equal tilt, of which the places lie that mirror it upwards. Rings are whole up to a
/// tilt of 45 degrees less half the angle of incidence, and end at 45 degrees and half of it; they
/// are close together on both sides of either, where what they send changes as a root does.
double sentByLobe(double roughness, const SurfaceDirection& from, const Brdfs& brdf) {
    // Midpoints leave at most 1e-4, of roughness 0.05 to 0.7 and incidence up to a cosine of 0.02.
    constexpr int rings = 100, places = 60;
    const double level = std::hypot(from.x, from.y), along = std::atan2(from.y, from.x);
    const double incidence = std::atan2(level, from.z);
    // Facets by the tangent of their tilt, alpha x / (1 - x), and turned about the normal from the
    // plane of incidence.
    double begin = 0.0, sum = 0.0;
    for (const double last : {0.25 * pi - 0.5 * incidence, 0.25 * pi + 0.5 * incidence}) {
        const double end = std::tan(last) / (roughness + std::tan(last));
        for (int i = 0; i < rings; ++i) {
            const double u = (i + 0.5) / rings;
            const double x = begin + (end - begin) * u * u * (3.0 - 2.0 * u);
            const double tangent = roughness * x / (1.0 - x);
            const double step =
                (end - begin) * 6.0 * u * (1.0 - u) / rings * roughness / ((1.0 - x) * (1.0 - x));
            const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
            const double sine = tangent * cosine;
            const double farthest =
                std::acos(std::clamp(from.z * (0.5 / cosine - cosine) / (level * sine), -1.0, 1.0));
            for (int j = 0; j < places; ++j) {
                const double angle = along + farthest * (j + 0.5) / places; // both sides are alike
                const SurfaceDirection facet{sine * std::cos(angle), sine * std::sin(angle),
                                             cosine};
                const SurfaceDirection to = mirrored(from, facet);
                const double facing = dot(from, facet);
                if (facing > 0.0 && to.z > 0.0) {
                    sum += brdf(to, true) * to.z * 4.0 * facing * sine * cosine * cosine * step *
                           2.0 * farthest / places;
                }
            }
        }
        begin = end;
    }
    return sum;
}

/// What all directions get of light from one that is not level, by facets about the half way of a
/// lobe and by rings for the rest; sums of this test's own.
double sentOf(const SurfaceModel& model, const SurfaceModel::Amounts& amounts,
              const SurfaceDirection& from) {
    const auto brdf = [&](const SurfaceDirection& to, bool ofLobes) {
        double sum = 0.0;
        for (std::size_t k = 0; k < model.components(); ++k) {
            sum += model.hasLobe(k) == ofLobes ? amounts[k] * model.brdf_per_sr(k, to, from) : 0.0;
        }
        return sum;
    };
    constexpr int rings = 200, places = 60;
    const double along = std::atan2(from.y, from.x);
    double rest = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double height = (i + 0.5) / rings, across = std::sqrt(1.0 - height * height);
        for (int j = 0; j < places; ++j) {
            const double angle = along + pi * (j + 0.5) / places; // both sides are alike
            rest += brdf({across * std::cos(angle), across * std::sin(angle), height}, false) *
                    height * 2.0 * pi / (rings * places);
        }
    }
    return sentByLobe(model.roughness(), from, brdf) + rest;
}

} // namespace

TEST(WhiteFurnace, EveryModelSendsAllThatFallsOnItAndTheSameEitherWay) {
    for (const Surface& surface : surfaces()) {
        const auto model = surfaceModelOf(surface.material);
        const SurfaceModel::Amounts amounts = model->amountsAt(surface.material, 4.0);
        DirectionSamples draws;
        double worstSum = 0.0, worstAlbedo = 0.0, worstPair = 0.0;
        for (int i = 0; i < pairs; ++i) {
            const SurfaceDirection a = draws.direction(), b = draws.direction();
            // What scenes take it to reflect, of light from either.
            for (const double cosine : {a.z, b.z}) {
                worstAlbedo =
                    std::max(worstAlbedo,
                             std::abs(reflectanceOverAngle(surface.material, cosine, 4.0) - 1.0));
            }
            double there = 0.0, back = 0.0;
            for (std::size_t k = 0; k < model->components(); ++k) {
                there += amounts[k] * model->brdf_per_sr(k, a, b);
                back += amounts[k] * model->brdf_per_sr(k, b, a);
            }
            if (there + back > 1e-9) {
                worstPair = std::max(worstPair, 2.0 * std::abs(there - back) / (there + back));
            }
            // Its integral, in directions of some of the pairs.
            if (i % 250 == 0) {
                const double cosine = std::max(a.z, 0.02);
                const double sent =
                    sentOf(*model, amounts, {std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
                const double expected = surface.isWhite ? 1.0 : model->reflected(amounts, cosine);
                worstSum = std::max(worstSum, std::abs(sent - expected));
            }
        }
        std::printf("  %-34s furnace %.1e, as scenes take it %.1e; either way %.1e\n",
                    surface.name.c_str(), worstSum, worstAlbedo, worstPair);
        if (surface.isWhite) {
            EXPECT_LE(worstSum, 1e-3) << surface.name;
            EXPECT_LE(worstAlbedo, 1e-3) << surface.name;
        }
        if (surface.isReciprocal) {
            EXPECT_LE(worstPair, 1e-3) << surface.name;
        }
        // What is not so in print stays, and lint says how much it is.
        const std::string findings = findingsOf(surface.material);
        EXPECT_EQ(findings.find("not reciprocal") != std::string::npos, worstPair > 0.02)
            << surface.name << ": " << findings;
        EXPECT_EQ(findings.find("above 1 - t") != std::string::npos, !surface.isWhite)
            << surface.name << ": " << findings;
    }
}

} // namespace irsg
