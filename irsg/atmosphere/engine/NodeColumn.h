#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericColumn.h"
#include "irsg/atmosphere/engine/CallOnceFast.h"
#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/NodeAbsorption.h"

namespace irsg {

/// Where light of the sun comes from, as seen along a line of sight.
struct SunAngle {
    double sunElevation_rad = 0.0;
    double sightElevation_rad = 0.0;  ///< of the direction from the sensor outward
    double relativeAzimuth_rad = 0.0; ///< of the line of sight from that of the sun

    /// Of the angle by which light of the sun is turned towards the sensor: that between the
    /// directions to the sun and outward along the line of sight.
    double cosine() const;
};

/// Extinction, scattering and emission of the air at every level and at some nodes of the spectrum.
/// A level is computed when it is first asked for and kept; rows run over the nodes. What varies
/// slowly with wavenumber (continua, Rayleigh scattering, particles) is computed every 10 cm-1
/// (50 cm-1 above 10000) and taken linearly between, or at the nodes themselves where they are
/// fewer. Const members may be called from several threads.
class NodeColumn {
  public:
    /// `sunWidth_per_cm`: over how much of the spectrum the sun is averaged around a node.
    NodeColumn(const AtmosphericColumn& air, std::vector<std::uint32_t> nodes,
               std::vector<double> wavenumbers_per_cm, double sunWidth_per_cm);

    const AtmosphericColumn& air() const { return air_; }
    std::size_t size() const { return nodes_.size(); }
    const std::vector<std::uint32_t>& nodes() const { return nodes_; }
    const std::vector<double>& wavenumbers_per_cm() const { return wavenumbers_per_cm_; }

    /// m-1: gases, continua, Rayleigh scattering, particles.
    std::span<const float> extinction(std::size_t level) const;
    /// m-1: the part of the extinction that is scattered.
    std::span<const float> scattering(std::size_t level) const;
    /// m-1: scattering times its asymmetry, and the part of the scattering that delta scaling
    /// counts as not scattered (asymmetry squared, of each kind of particles by itself).
    std::span<const float> asymmetry(std::size_t level) const;
    std::span<const float> forwardPeak(std::size_t level) const;
    /// Radiance of a black body of the level's temperature, W m-2 sr-1 um-1.
    std::span<const double> planck(std::size_t level) const;
    void planckAt(double temperature_K, std::span<double> radiance) const;
    /// The sun above the atmosphere, W m-2 um-1.
    std::span<const double> sun() const;

    /// What scatters: the molecules, kind 0, and every kind of particles after them.
    std::size_t scattererCount() const { return 1 + optics_.size(); }
    /// Scattering by one of them, m-1; false where there is none.
    bool scatteringBy(std::size_t kind, std::size_t level, std::span<double> out) const;
    /// Its phase function, mean 1 over the sphere, for a cosine of the angle of scattering:
    /// Rayleigh's, and Henyey and Greenstein's for particles.
    void phaseOf(std::size_t kind, double cosine, std::span<double> out) const;

  private:
    /// Slowly varying parts at the smooth points of one level, m-1.
    struct Smooth {
        std::vector<double> extinction, scattering, asymmetry, forwardPeak, rayleigh;
    };
    struct Level {
        CallOnceFast extinctionOnce, phaseOnce, planckOnce;
        Smooth smooth;
        std::vector<float> extinction, scattering, asymmetry, forwardPeak;
        std::vector<double> planck;
    };
    /// Optical properties of one kind of particles at the smooth points, per extinction at 0.55 um.
    struct Optics {
        std::vector<double> extinction, scattering, asymmetry;
    };
    Level& withExtinction(std::size_t level) const;
    Level& withPhase(std::size_t level) const;
    Smooth smoothAt(std::size_t level) const;
    template <typename Number>
    void spread(const std::vector<double>& smooth, std::span<Number> out) const;

    const AtmosphericColumn& air_;
    std::vector<std::uint32_t> nodes_;
    std::vector<double> wavenumbers_per_cm_;
    double sunWidth_per_cm_;
    NodeAbsorption absorption_;
    std::vector<double> wavelengths_um_;
    std::vector<double> smoothPoints_per_cm_;
    ContinuumSpectrum continua_;             ///< at the smooth points
    std::vector<std::uint32_t> smoothBelow_; ///< smooth point at or below each node
    std::vector<double> smoothPart_;         ///< and how far to the next
    std::vector<Optics> optics_;
    mutable std::vector<Level> levels_;
    mutable CallOnceFast sunOnce_;
    mutable std::vector<double> sun_;
};

} // namespace irsg
