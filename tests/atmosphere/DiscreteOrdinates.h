#pragma once

#include <array>
#include <vector>

namespace irsg {

/// A homogeneous layer of a plane parallel column, and what it emits.
struct OrdinateLayer {
    double opticalDepth = 0.0;
    double albedo = 0.0;                         ///< of single scattering
    double asymmetry = 0.0;                      ///< of Henyey and Greenstein's phase function
    double planckBelow = 0.0, planckAbove = 0.0; ///< at its edges; linear in depth between
};

/// The azimuthal mean of the radiance in a plane parallel, scattering, emitting column over a
/// Lambertian ground, by discrete ordinates: 16 streams, eight Gauss points for each hemisphere
/// (Sykes 1951, Mon. Not. R. Astron. Soc. 111, 377), Legendre moments of the phase function up to
/// 15 with delta-M scaling (Wiscombe 1977, J. Atmos. Sci. 34, 1408). Layers are made from thin ones
/// by doubling, with sources that are linear in depth (Wiscombe 1976, J. Quant. Spectrosc. Radiat.
/// Transfer 16, 477), and joined by adding (Grant and Hunt 1969, Proc. R. Soc. A 313, 183).
///
/// An independent reference: it shares nothing with the two-stream solution but the equation.
class DiscreteOrdinates {
  public:
    static constexpr std::size_t half = 8; ///< streams of a hemisphere
    using Row = std::array<double, half>;

    /// Layers from the ground up; the beam has irradiance `beam` normal to itself at the top.
    DiscreteOrdinates(std::vector<OrdinateLayer> layers, double groundAlbedo, double groundPlanck,
                      double beam = 0.0, double sinElevation = 1.0);

    /// Per level, from the ground up: diffuse fluxes through a horizontal plane, and the mean
    /// radiance over all directions, 4 pi of which is the actinic flux.
    std::vector<double> up, down, mean;
    /// What scattering sends into a direction at a level, per scattering depth of the delta-scaled
    /// air just below it, as `cosine` (up positive, 0 horizontal) has it on the azimuthal mean; of
    /// the diffuse light alone.
    double scattered(std::size_t level, double cosine) const;

    const std::vector<Row>& upward() const { return up_; }
    const std::vector<Row>& downward() const { return down_; }

  private:
    std::vector<OrdinateLayer> layers_;
    std::vector<Row> up_, down_;
};

} // namespace irsg
