#pragma once

namespace irsg {

/// How far below its horizon a sensor sees level ground at a distance: the ground is the sphere
/// whose horizon dips as far as that of an atmosphere, which includes refraction, or a plane where
/// the horizon does not dip.
class GroundDistance {
  public:
    /// Altitude of the sensor above ground, 0 or more, and apparent elevation of its horizon.
    GroundDistance(double altitude_m, double horizon_rad);

    /// Of a straight distance above 0: 0 for the horizon and what is farther, up to straight down
    /// for what is nearer than the ground.
    double belowHorizon_rad(double distance_m) const;

  private:
    double altitude_m_, horizon_rad_;
    double perCentre_1_m_ = 0.0; ///< 1 / distance of the sphere's centre; 0 for a plane
    double toHorizon_m_ = 0.0;   ///< 0 for a plane
};

} // namespace irsg
