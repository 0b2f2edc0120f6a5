#include "irsg/scene/radiance/RadianceTerms.h"

#include "irsg/scene/view/Pose.h"

namespace irsg {

namespace {

/// The drawn factors of the standard list, by their place in it.
enum StandardFactor { view, sky, sun };

std::string viewFactor(const RenderSettings&) {
    return "viewPower(normal, eyePosition, nAngleFactor)";
}

std::string skyFactor(const RenderSettings& settings) {
    switch (settings.fluxes) {
    case ReflectionMode::off:
        return "0.0";
    case ReflectionMode::approx:
        return "0.5";
    case ReflectionMode::smart:
        break;
    }
    return settings.fluxWeights == FluxWeights::report ? "angleWeight(dot(normal, zenithEye))"
                                                       : "viewWeight(dot(normal, zenithEye))";
}

std::string sunFactor(const RenderSettings& settings) {
    switch (settings.sun) {
    case ReflectionMode::off:
        return "0.0";
    case ReflectionMode::approx:
        return "0.25";
    case ReflectionMode::smart:
        break;
    }
    return "max(dot(normal, sunEye), 0.0)";
}

bool always(const RenderSettings&) {
    return true;
}
bool withSun(const RenderSettings& settings) {
    return settings.sun != ReflectionMode::off;
}
bool withFluxes(const RenderSettings& settings) {
    return settings.fluxes != ReflectionMode::off;
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
    list.factors = {{"view", viewFactor}, {"sky", skyFactor}, {"sun", sunFactor}};
    using enum SurfaceQuantity;
    using enum AtmosphereProperty;
    constexpr bool complement = true, passesAir = true;
    list.terms = {
        {"thermal", {view}, emission, std::nullopt, false, always},
        {"sun", {sun}, reflectance, solarIrradiance, passesAir, withSun},
        {"up", {sky, complement}, reflectance, upwardFlux, passesAir, withFluxes},
        {"down", {sky}, reflectance, downwardFlux, passesAir, withFluxes},
        {"path", {}, opacity, pathRadiance, false, always},
    };
    return list;
}

} // namespace

const RadianceTerms& RadianceTerms::standard() {
    static const RadianceTerms list = makeStandard();
    return list;
}

std::string RadianceTerms::glsl(const RenderSettings& settings) const {
    std::string lines = "#define FACTOR_COUNT " + std::to_string(factors.size()) + "\n";
    for (const FrameDirection& direction : directions)
        lines += "uniform vec3 " + direction.name + "; // unit, eye space\n";
    lines += "#define FILL_FACTORS(f)";
    for (std::size_t i = 0; i < factors.size(); ++i)
        lines += " f[" + std::to_string(i) + "] = " + factors[i].glsl(settings) + ";";
    return lines + "\n";
}

} // namespace irsg
