#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/geometry/view/Vec3.h"
#include "irsg/render/sampling/SampleGeometry.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// What of a surface's own properties a term is proportional to, per wavelength.
enum class SurfaceQuantity {
    emission,    ///< epsilon L_bb(T) or a measured spectrum, W m-2 sr-1 um-1
    reflectance, ///< rho / pi of a Lambertian surface, sr-1
    opacity,     ///< 1 - t
    specular     ///< what lobes reflect of the air's radiance in a direction, W m-2 sr-1 um-1
};

/// A direction of the world that a frame has: a uniform of the shader, in eye space there.
struct FrameDirection {
    std::string name;
    std::function<Vec3(const SunPosition&)> world; ///< unit
};

/// What geometry alone makes of a sample: a number that the shader draws, 0 to 1.
struct GeometryFactor {
    std::string name;
    /// GLSL expression of it under given settings, of `normal` (unit, to the side that is seen),
    /// `eyePosition` (m, from the eye to the sample), `nAngleFactor` and the frame's directions.
    std::function<std::string(const RenderSettings&)> glsl;
    /// The same on the CPU, for rays; a list without it is for OpenGL alone. (A test samples both.)
    std::function<GeometryFactorFunction(const RenderSettings&)> function = {};
    /// Number of the frame's direction that its light comes from, where what stands there takes it
    /// away; none.
    std::function<int(const RenderSettings&)> shadowedFrom = {};
};

/// Which factor a term is multiplied with: number `drawn` of the drawn ones, 1 minus it, or 1.
struct TermGeometryFactor {
    int drawn = -1;
    bool complement = false;
};

/// From where the light of a term comes, for what stands in its way and what it falls on: see
/// SceneLight. Surfaces that reflect light of no origin do not light each other with it.
enum class LightOrigin { none, sun, sky, ground };

/// One way in which a surface sends light to the sensor. A sample's apparent spectral radiance is
/// the sum over all terms of factor times surface quantity times light (times transmittance).
struct RadianceTerm {
    std::string name; ///< of its truth layer
    TermGeometryFactor factor;
    SurfaceQuantity surface = SurfaceQuantity::emission;
    /// What the air sends onto the surface, or into the path before it; nothing: 1. Not asked for
    /// where `isOn` says no, and the term is 0 then.
    std::optional<AtmosphereProperty> light;
    /// The light passes the air between surface and sensor. (That of emission is in the surface
    /// quantity, since a measured spectrum holds a part of its air already.)
    bool passesAtmosphere = false;
    std::function<bool(const RenderSettings&)> isOn;
    LightOrigin origin = LightOrigin::none;

    /// Of the path before the surface, and not of what falls onto it.
    bool isAlongPath() const { return light && geometryOf(*light) == QueryGeometry::path; }
};

/// The one list of what a surface can send (report eqs. 1 to 3, corrected as docs/physics.md says).
/// The shader's source is made from it, factors are summed by it and spectra are evaluated by it;
/// nothing else knows a term by name. How to add one: CONTRIBUTING.md.
class RadianceTerms {
  public:
    std::vector<FrameDirection> directions;
    std::vector<GeometryFactor> factors;
    std::vector<RadianceTerm> terms;

    /// Thermal emission, sun, ground and sky by reflection, and the path.
    static const RadianceTerms& standard();

    std::size_t factorCount() const { return factors.size(); }
    /// Lines of GLSL that declare the directions and FILL_FACTORS(f), which sets f[0], f[1], ...
    /// `withNormals`: then the components of the normal in eye space, for LobeQuadrature.
    std::string glsl(const RenderSettings& settings, bool withNormals = false) const;
    /// By factor, the number of the direction from which its light is taken away; -1: none.
    std::vector<int> shadowedFrom(const RenderSettings& settings) const;
    /// The factors on the CPU; LogicError names one that has no function.
    std::vector<GeometryFactorFunction> functions(const RenderSettings& settings,
                                                  bool withNormals = false) const;
    /// What lobes make of each factor.
    std::vector<LobeRole> lobeRoles() const;
};

} // namespace irsg
