#include "irsg/radiance/RadianceTerms.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// The drawn factors of the standard list, by their place in it.
enum StandardGeometryFactor { view, sky, sun };
/// The frame's directions, likewise.
enum StandardDirection { zenithEye, sunEye };

/// A factor in both languages; the shader's functions are those of surface.frag.glsl.
struct Expression {
    std::string glsl;
    GeometryFactorFunction function;
};

Expression constant(const char* glsl, double value) {
    return {glsl, [value](const SampleGeometry&) { return value; }};
}

double cosineTo(StandardDirection to, const SampleGeometry& sample) {
    return std::clamp(dot(sample.normal, sample.directionsEye[to].second), -1.0, 1.0);
}

Expression viewFactor(const RenderSettings&) {
    return {"viewPower(normal, eyePosition, nAngleFactor)", [](const SampleGeometry& sample) {
                if (sample.nAngleFactor == 0.0)
                    return 1.0;
                const double cosView =
                    -dot(sample.normal, sample.eyePosition_m) / length(sample.eyePosition_m);
                return std::pow(std::clamp(cosView, 0.0, 1.0), sample.nAngleFactor);
            }};
}

Expression skyFactor(const RenderSettings& settings) {
    switch (settings.ambientReflection) {
    case ReflectionMode::off:
        return constant("0.0", 0.0);
    case ReflectionMode::approx:
        return constant("0.5", 0.5);
    case ReflectionMode::smart:
        break;
    }
    if (settings.fluxWeights == FluxWeights::report)
        return {"angleWeight(dot(normal, zenithEye))", [](const SampleGeometry& sample) {
                    return 1.0 - std::acos(cosineTo(zenithEye, sample)) / pi;
                }};
    return {"viewWeight(dot(normal, zenithEye))",
            [](const SampleGeometry& sample) { return 0.5 * (1.0 + cosineTo(zenithEye, sample)); }};
}

Expression sunFactor(const RenderSettings& settings) {
    switch (settings.sun) {
    case ReflectionMode::off:
        return constant("0.0", 0.0);
    case ReflectionMode::approx:
        return constant("0.25", 0.25);
    case ReflectionMode::smart:
        break;
    }
    return {"max(dot(normal, sunEye), 0.0)",
            [](const SampleGeometry& sample) { return std::max(cosineTo(sunEye, sample), 0.0); }};
}

GeometryFactor drawn(const char* name, Expression (*expression)(const RenderSettings&)) {
    return {name, [=](const RenderSettings& settings) { return expression(settings).glsl; },
            [=](const RenderSettings& settings) { return expression(settings).function; }};
}

int sunShadow(const RenderSettings& settings) {
    const bool isShadowed =
        settings.sun == ReflectionMode::smart && settings.sunShadows != SunShadowMode::off;
    return isShadowed ? sunEye : -1;
}

bool always(const RenderSettings&) {
    return true;
}
bool withSun(const RenderSettings& settings) {
    return settings.sun != ReflectionMode::off;
}
bool withFluxes(const RenderSettings& settings) {
    return settings.ambientReflection != ReflectionMode::off;
}

bool withSpecular(const RenderSettings& settings) {
    return settings.ambientReflection == ReflectionMode::smart;
}

RadianceTerms makeStandard() {
    RadianceTerms list;
    list.directions = {{"zenithEye",
                        [](const SunPosition&) {
                            return Vec3{0, 0, 1};
                        }},
                       {"sunEye", [](const SunPosition& position) {
                            return direction(position.azimuth_rad, position.elevation_rad);
                        }}};
    list.factors = {drawn("view", viewFactor), drawn("sky", skyFactor), drawn("sun", sunFactor)};
    list.factors[sun].shadowedFrom = sunShadow;
    using enum SurfaceQuantity;
    using enum AtmosphereProperty;
    constexpr bool complement = true, passesAtmosphere = true;
    list.terms = {
        {"thermal", {view}, emission, std::nullopt, false, always},
        {"sun", {sun}, reflectance, solarIrradiance, passesAtmosphere, withSun, LightOrigin::sun},
        {"up",
         {sky, complement},
         reflectance,
         upwardFlux,
         passesAtmosphere,
         withFluxes,
         LightOrigin::ground},
        {"down", {sky}, reflectance, downwardFlux, passesAtmosphere, withFluxes, LightOrigin::sky},
        {"path", {}, opacity, pathRadiance, false, always},
        {"mirror", {}, specular, std::nullopt, passesAtmosphere, withSpecular},
    };
    return list;
}

} // namespace

const RadianceTerms& RadianceTerms::standard() {
    static const RadianceTerms list = makeStandard();
    return list;
}

std::string RadianceTerms::glsl(const RenderSettings& settings, bool withNormals) const {
    const std::size_t count = factors.size() + (withNormals ? normalFactors : 0);
    std::string lines = "#define FACTOR_COUNT " + std::to_string(count) + "\n";
    for (const FrameDirection& direction : directions)
        lines += "uniform vec3 " + direction.name + "; // unit, eye space\n";
    lines += "#define FILL_FACTORS(f)";
    for (std::size_t i = 0; i < factors.size(); ++i)
        lines += " f[" + std::to_string(i) + "] = " + factors[i].glsl(settings) + ";";
    for (std::size_t i = factors.size(); i < count; ++i)
        lines +=
            " f[" + std::to_string(i) + "] = normal[" + std::to_string(i - factors.size()) + "];";
    return lines + "\n";
}

std::vector<int> RadianceTerms::shadowedFrom(const RenderSettings& settings) const {
    std::vector<int> all;
    for (const GeometryFactor& factor : factors)
        all.push_back(factor.shadowedFrom ? factor.shadowedFrom(settings) : -1);
    return all;
}

std::vector<LobeRole> RadianceTerms::lobeRoles() const {
    std::vector<LobeRole> roles(factors.size(), LobeRole::flux);
    for (const RadianceTerm& term : terms) {
        if (term.factor.drawn < 0)
            continue;
        LobeRole& role = roles[static_cast<std::size_t>(term.factor.drawn)];
        if (term.surface == SurfaceQuantity::emission)
            role = LobeRole::emission;
        else if (term.origin == LightOrigin::sun)
            role = LobeRole::sun;
    }
    return roles;
}

std::vector<GeometryFactorFunction> RadianceTerms::functions(const RenderSettings& settings,
                                                             bool withNormals) const {
    std::vector<GeometryFactorFunction> all;
    for (const GeometryFactor& factor : factors) {
        if (!factor.function)
            throw LogicError("the factor '" + factor.name + "' is known to OpenGL alone");
        all.push_back(factor.function(settings));
    }
    if (withNormals) {
        all.emplace_back([](const SampleGeometry& sample) { return sample.normal.x; });
        all.emplace_back([](const SampleGeometry& sample) { return sample.normal.y; });
        all.emplace_back([](const SampleGeometry& sample) { return sample.normal.z; });
    }
    return all;
}

} // namespace irsg
