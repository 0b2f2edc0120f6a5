#pragma once

#include <array>
#include <vector>

#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/SensorDescription.h"

namespace irsg {

/// The screen on which an observer sees the pictures of a sensor, and how they are shown there.
struct SensorDisplay {
    double pixel_mrad = 0.8;       ///< of the sensor, as the observer sees it, square; > 0
    double luminance_cd_m2 = 34.0; ///< of the mean picture (10 fL); > 0
    double sceneContrast_K = 10.0; ///< the temperature difference over which it shows it; > 0
};

/// The least contrast of a sine pattern that the eye sees, P. G. J. Barten, "Evaluation of
/// subjective image quality with the square-root integral method", J. Opt. Soc. Am. A 7, 2024
/// (1990):
///
///     1 / (a u exp(-b u) sqrt(1 + 0.06 exp(b u))), a = 540 (1 + 0.7 / L)^-0.2 / (1 + 12 / (w (1 +
///     u / 3)^2)), b = 0.3 (1 + 100 / L)^0.15
///
/// of frequency u > 0 in cycles/degree, luminance L in cd m-2, side w of the picture in degrees.
double eyeThreshold(double frequency_per_deg, double luminance_cd_m2, double field_deg);

/// The targeting task performance (TTP) of a sensor with its observer: Vollmerhausen, Jacobs and
/// Driggers, "New metric for predicting target acquisition performance", Optical Engineering
/// 43(11), 2806 (2004). Of a target with the contrast C = difference / (2 scene contrast)
///
///     TTP = integral of sqrt(C / CTF(f)) df over the frequencies with CTF(f) < C
///     CTF(f)^2 = (threshold of the eye at f / MTF(f))^2 (1 + 169.6^2 Hz S Q(f) Q / K^2)
///
/// with the scene contrast K, the density S of the noise that the eye perceives, K^2 rad^2 s, and
/// the bandwidths of eye and display along the pattern, Q(f) = integral of (exp(-2.2 ln(g / f)^2)
/// sinc(p g))^2 dg, and across it, Q = integral of sinc(p g)^2 dg, both over all frequencies g of
/// either sign. The MTF is the sensor's with the sinc of the square pixels of the display. The
/// integral ends at Nyquist's frequency, and at the first zero of the MTF: what a sampled picture
/// shows beyond is not counted. Contrast above 1 counts as 1. Fixed pattern is noise that lasts as
/// long as the eye integrates.
class TargetingTask {
  public:
    /// Throws InputError for a background that is not above 0 K, an observer and a display that
    /// cannot be.
    TargetingTask(const SensorDescription& sensor, double background_K,
                  const Observer& observer = {}, const SensorDisplay& display = {});

    using Direction = ResolvableTemperature::Direction;
    /// The system's threshold of contrast at a frequency > 0, cycles/rad, before the background
    /// that is given at the beginning; infinite where nothing passes.
    double threshold(double frequency_per_rad, Direction direction) const;
    /// TTP in cycles/rad: the geometric mean of both directions. Times the root of the target's
    /// solid angle it is the number of cycles that a task needs.
    double cycles_per_rad(double difference_K) const {
        return cycles_per_rad(difference_K, noise_K_);
    }
    /// The same before another background, for which the noise that the observer perceives is given
    /// (perceivedNoise_K).
    double cycles_per_rad(double difference_K, double noise_K) const;

  private:
    /// Squares of the threshold without noise, and what a noise of 1 K adds to 1.
    struct Node {
        double quiet, perNoise;
    };
    Node nodeAt(double frequency_per_rad, Direction direction) const;
    double along(double contrast, double noise_K, Direction direction) const;

    SensorTransfer transfer_;
    Observer observer_;
    SensorDisplay display_;
    double pixel_rad_, field_deg_, step_per_rad_;
    double noise_K_;
    std::array<std::vector<Node>, 2> nodes_; ///< at whole steps from 1 on
};

/// Detection, recognition and identification of tracked vehicles with the cycles V50 of the TTP
/// metric: 2.7, 14.5 and 18.8 (NVThermIP).
const std::vector<JohnsonTask>& targetingTasks();
/// Its probability: exponent 1.51 + 0.24 V / V50.
inline constexpr TaskLaw targetingLaw{1.51, 0.24};

/// The nominal static range of a thermal imager as STANAG 4347 defines it, m: where so many line
/// pairs across a target are just resolved at its temperature difference behind air of Beer's law.
struct NominalTarget {
    double side_m = 2.3;
    double difference_K = 2.0;
    double extinction_per_km = 0.2; ///< >= 0; good air, 1 is limited
};
/// 0 where even a metre is too far. Throws InputError for what cannot be.
double nominalRange_m(const ResolvableTemperature& sensor, const NominalTarget& target,
                      double linePairs);
/// Detection, recognition and identification with their line pairs: 1, 3 and 6.
const std::vector<JohnsonTask>& nominalTasks();

} // namespace irsg
