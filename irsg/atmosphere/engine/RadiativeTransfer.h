#pragma once

#include <memory>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/engine/RayPath.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// The report's ScatteringMode: light scattered once, or the sources of a two-stream solution.
enum class ScatteringMode { single = 1, twoStream = 2 };

/// Everything that describes the air and the ground under it.
struct AtmosphericModel {
    Profile profile;
    std::vector<ParticleLayer> particles;
    double groundTemperature_K = 288.15;
    Spectrum groundAlbedo = Spectrum::constant(0.2); ///< 0 to 1; emissivity is 1 - albedo
    ScatteringMode scattering = ScatteringMode::twoStream;
    int resolution_per_cm = 5; ///< 1, 5 or 15
};

/// Nodes with the smooth quantities shared between them: spectral mode has the nodes of many bins,
/// wideband-ck a few nodes of the whole band.
struct NodeSet {
    std::vector<std::uint32_t> nodes; ///< of the GasTable
    std::vector<double>
        wavenumbers_per_cm; ///< at which continua, particles, Planck and sun are taken
};

/// Light along a ray, apart by what depends on the azimuth between the ray and the sun: the sun's
/// beam scattered once does, by one phase function for each kind of scatterer.
struct DirectedLight {
    double sightElevation_rad = 0.0; ///< of the direction outward, at the sensor
    std::vector<double> even;        ///< the same at all azimuths, per node, W m-2 sr-1 um-1
    /// Of the beam, for phase functions of 1, by kind; empty in the dark.
    std::vector<std::vector<double>> beams;
};

/// Radiative transfer through a spherical, refracting, scattering atmosphere, monochromatic at
/// every node. Extinction is linear in altitude between grid levels; emission is linear in optical
/// depth along a segment. Scattered light is single scattering of the sun on the line of sight
/// plus, in two-stream mode, the diffuse field of a plane-parallel two-stream solution (Toon et al.
/// 1989, J. Geophys. Res. 94, 16287) as source (as the MODTRAN family does).
///
/// In single mode what is scattered into a path of heat is as if all around were as warm as the air
/// there: air then radiates with all of its extinction (as MODTRAN without multiple scattering).
/// Fluxes, and the light that the ground reflects, are those of the two-stream solution in both
/// modes. The sun has the same elevation all along a path.
///
/// Extinction at a node and level is computed when first asked and kept, so a path costs what it
/// touches. Const members may be called from several threads.
class RadiativeTransfer {
  public:
    RadiativeTransfer(AtmosphericModel air, std::shared_ptr<const GasTable> gases);
    ~RadiativeTransfer();

    const AtmosphericModel& air() const;
    const GasTable& gases() const;
    const RayTracer& tracer() const;

    /// Nodes of the resolution's bins that touch a range, and of one more at an end whose bin has
    /// its centre inside the range. LogicError where the table has no bin in the range.
    NodeSet nodesOf(const SpectralRange& range) const;

    /// The bins of these nodes, ascending in wavenumber.
    std::span<const SpectralBin> binsOf(const SpectralRange& range) const;

    /// Values per node, in the order of the set. Radiances per um at the node's wavenumber. They
    /// throw what RayTracer throws for geometry that cannot be.
    std::vector<double> transmittance(const NodeSet& set, const AtmosphericPath& path) const;
    std::vector<double> pathRadiance(const NodeSet& set, const AtmosphericPath& path,
                                     const SunPosition& sun) const;
    std::vector<double> backgroundRadiance(const NodeSet& set, const LineOfSight& sight,
                                           const SunPosition& sun) const;
    /// The same two for all azimuths, and one azimuth from that.
    DirectedLight pathLight(const NodeSet& set, const AtmosphericPath& path,
                            const SunPosition& sun) const;
    DirectedLight skyLight(const NodeSet& set, const LineOfSight& sight,
                           const SunPosition& sun) const;
    std::vector<double> towards(const NodeSet& set, const DirectedLight& light,
                                double sunElevation_rad, double relativeAzimuth_rad) const;
    std::vector<double> solarIrradiance(const NodeSet& set, double altitude_m,
                                        const SunPosition& sun) const;
    std::vector<double> upwardFlux(const NodeSet& set, double altitude_m,
                                   const SunPosition& sun) const;
    std::vector<double> downwardFlux(const NodeSet& set, double altitude_m,
                                     const SunPosition& sun) const;
    std::vector<double> scatteringOpticalDepth(const NodeSet& set,
                                               const AtmosphericPath& path) const;
    /// Part of the transmittance that one gas, the continua or the particles make alone; for
    /// comparison with the columns of other programs. `component` is a name of gasNames,
    /// continuumNames, "Rayleigh" or "particles".
    std::vector<double> componentTransmittance(const NodeSet& set, const AtmosphericPath& path,
                                               const std::string& component) const;

    /// Means over the resolution's bins as a spectrum over wavelength that covers the range, with a
    /// node at each bin's centre; `nodeValues` are in the order of nodesOf(range), LogicError
    /// otherwise. At the ends of the table the last mean is held to the end of the range.
    Spectrum spectrum(const SpectralRange& range, std::span<const double> nodeValues) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace irsg
