#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "irsg/sensor/SensorDescription.h"

namespace irsg {

/// What a sensor leaves of the contrast of a pattern, by cause. Every blur of images, point spread
/// and ensquared energy of a sensor come from here.
///
/// Frequencies are in cycles/rad, x along the rows, y along the columns, of either sign. Optics are
/// averaged over the band, weighted by the sensor's response times the radiance of a black body.
class SensorTransfer {
  public:
    struct Component {
        std::string name; ///< "diffraction"
        double value = 0.0;
    };

    /// `source_K`: temperature of the black body, > 0 (InputError). It must outlive nothing.
    explicit SensorTransfer(const SensorDescription& sensor, double source_K = 300.0);

    /// diffraction; defocus, what it changes that by; aberration; detector, its active area;
    /// jitter; motion, within an integration time; time_constant, along the motion.
    std::vector<Component> components(double x_per_rad, double y_per_rad) const;
    /// Their product: the system's transfer function, 1 at frequency 0, real.
    double at(double x_per_rad, double y_per_rad) const;

    double diffraction(double x_per_rad, double y_per_rad) const;
    /// Diffraction with defocus, without the aberration.
    double optics(double x_per_rad, double y_per_rad) const;
    /// All but the optics, which is a function of x times a function of y.
    double alongRows(double x_per_rad) const;
    double alongColumns(double y_per_rad) const;
    /// The highest frequency that the optics transmit, cycles/rad, along an axis.
    double cutoff_per_rad() const { return cutoff_per_rad_; }
    /// The largest defocus of the band's wavelengths, in waves of each, without its sign.
    double defocus_waves() const { return std::abs(nodes_.front().waves); }
    /// Half the angle over which a point is spread, diffraction's far wings aside, rad.
    double spread_rad() const;

  private:
    struct Node {
        double wavelength_m;
        double weight; ///< their sum is 1
        double waves;  ///< defocus at this wavelength
    };
    double averaged(double x_per_rad, double y_per_rad, bool isDefocused) const;

    SensorDescription sensor_;
    std::vector<Node> nodes_;
    double cutoff_per_rad_ = 0.0;
};

} // namespace irsg
