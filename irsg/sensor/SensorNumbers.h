#pragma once

#include <string>
#include <vector>

#include "irsg/sensor/SensorDescription.h"

namespace irsg {

/// The signal of a pixel in an integration time, by where it comes from: electrons, of a thermal
/// detector absorbed watts.
struct PixelSignal {
    double scene = 0.0;
    double optics = 0.0;  ///< what the optics emit
    double housing = 0.0; ///< past the cold shield
    double dark = 0.0;

    double offset() const { return optics + housing + dark; } ///< without a scene
    double total() const { return scene + offset(); }
};

/// Standard deviations of the signal of a pixel, in its unit, by cause.
struct PixelNoise {
    double photon = 0.0; ///< sqrt of the electrons from scene, optics and housing (Poisson's law)
    double dark = 0.0;
    double read = 0.0;
    double quantisation = 0.0; ///< a count / sqrt(12)
    double thermal = 0.0;      ///< of a thermal detector, from its NETD
    double pattern = 0.0;      ///< all components of 3-D noise but tvh

    double temporal() const; ///< all but the pattern
    double total() const;
};

/// The numbers of a sensor before a uniform background. Of bands: W m-2 and W m-2 sr-1 are weighted
/// by the sensor's response relative to its peak (SensorDescription::band).
struct SensorNumbers {
    ConeConvention convention = ConeConvention::exact;
    PixelSignal signal;
    PixelNoise noise;
    double contrast_per_K = 0.0;     ///< change of the signal with the background's temperature
    double netd_K = 0.0;             ///< temporal noise / contrast_per_K; infinite where that is 0
    double totalNetd_K = 0.0;        ///< the same of the total noise
    double ner_W_m2_sr = 0.0;        ///< radiance whose signal is the temporal noise
    double nep_W = 0.0;              ///< power on the pixel at the response's peak, the same
    double dStar_cm_sqrtHz_W = 0.0;  ///< sqrt(active area / (2 integration time)) / nep
    double ensquaredEnergy = 0.0;    ///< of a point in the middle of a pixel
    double nei_W_m2 = 0.0;           ///< irradiance on the pupil of a point there, the same
    double neiWholePoint_W_m2 = 0.0; ///< with an ensquared energy of 1
    double totalNei_W_m2 = 0.0;      ///< of the total noise, with ensquared energy
    double wellFill = 0.0;           ///< part of the well, of a thermal detector of the converter
    double dynamicRange_dB = 0.0;    ///< 20 lg(full / noise without scene)
};

/// How radiance and irradiance become the signal of a pixel, and what noise it has.
class PixelResponse {
  public:
    explicit PixelResponse(const SensorDescription& sensor,
                           ConeConvention convention = ConeConvention::exact);

    /// Before a black body that fills the field.
    PixelSignal signal(double background_K) const;
    /// d(scene signal)/dT there.
    double contrast_per_K(double background_K) const;
    /// Of a band radiance / of a point's band irradiance on the pupil whose whole light falls on
    /// the active area.
    double signalPerRadiance() const { return perRadiance_; }
    double signalPerIrradiance() const { return perIrradiance_; }
    /// The signal without a scene.
    PixelSignal offset() const;
    PixelNoise noise(const PixelSignal& signal) const;
    /// The most that a pixel holds and the converter tells apart.
    double fullSignal() const;

  private:
    double blackBodySignal(double temperature_K, bool throughOptics, bool derivative) const;

    SensorDescription sensor_;
    double cone_sr_, time_, perRadiance_ = 0.0, perIrradiance_ = 0.0;
    double thermalNoise_ = 0.0, patternNoise_ = 0.0;
};

/// Throws InputError for a background that is not above 0 K. A well that is more than full is
/// reported as such (wellFill above 1); its numbers are those of a larger one.
SensorNumbers sensorNumbers(const SensorDescription& sensor, double background_K,
                            ConeConvention convention, double ensquaredEnergy);

} // namespace irsg
