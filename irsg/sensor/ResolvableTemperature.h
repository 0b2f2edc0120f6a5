#pragma once

#include <array>
#include <vector>

#include "irsg/sensor/SensorDescription.h"
#include "irsg/sensor/SensorNumbers.h"
#include "irsg/sensor/SensorTransfer.h"

namespace irsg {

/// What an observer makes of a picture.
struct Observer {
    double threshold = 2.5;     ///< perceived signal to noise ratio at which he sees bars, > 0
    double integration_s = 0.2; ///< over which his eye takes the mean of frames, > 0
};

/// The noise of a pixel before a background, in K of it, that an observer perceives of the frames
/// that his eye takes together.
double perceivedNoise_K(const SensorDescription& sensor, const PixelNoise& noise,
                        double contrast_per_K, const Observer& observer);

/// The minimum resolvable temperature difference (MRTD) of a sensor before a background: that of a
/// pattern of four bars, seven times as long as wide, which an observer just sees,
///
///     pi^2 / (4 sqrt 7) threshold f p sqrt(NETD^2 / max(1, frame rate x integration) + D^2) /
///     |MTF(f)|
///
/// with the angle p of a pixel, the NETD of temporal noise, and the pattern noise D in K, which no
/// frames average and which is taken as independent from pixel to pixel. It is the static model of
/// Ratches (Optical Engineering 15(6), 525, 1976) with noise in a bandwidth of 1 / (2 dwell time):
/// the first harmonic of the bars, and the mean of the noise over the area of one. Display and eye
/// do not blur. Infinite beyond Nyquist's frequency and from the first zero of the MTF on.
class ResolvableTemperature {
  public:
    enum class Direction { horizontal, vertical }; ///< along the rows, along the columns

    /// Throws InputError for a background that is not above 0 K, and an observer that cannot be.
    ResolvableTemperature(const SensorDescription& sensor, double background_K,
                          const Observer& observer = {});

    /// At a frequency >= 0 in cycles/rad; 0 at frequency 0.
    double mrtd_K(double frequency_per_rad, Direction direction) const;
    /// Of both directions: the difference at which the geometric mean of what they resolve is this
    /// frequency.
    double mrtd_K(double frequency_per_rad) const;
    /// The highest frequency, cycles/rad, up to which bars of this temperature difference are
    /// resolved: at most Nyquist's.
    double frequency_per_rad(double difference_K, Direction direction) const {
        return resolved_per_rad(difference_K / noise_K_, direction);
    }
    /// The geometric mean of both directions: that of a target in two dimensions (ACQUIRE).
    double frequency_per_rad(double difference_K) const {
        return bothResolved_per_rad(difference_K / noise_K_);
    }
    /// The same before another background, for which the noise that the observer perceives is
    /// given (perceivedNoise_K); the optics keep their spectrum.
    double frequency_per_rad(double difference_K, double noise_K) const {
        return bothResolved_per_rad(difference_K / noise_K);
    }
    double nyquist_per_rad() const { return nyquist_per_rad_; }

  private:
    double transfer(double frequency_per_rad, Direction direction) const;
    double placeOf(int look) const;
    double resolved_per_rad(double differenceByNoise, Direction direction) const;
    double bothResolved_per_rad(double differenceByNoise) const;

    SensorTransfer transfer_;
    double nyquist_per_rad_;
    double noise_K_;
    double perFrequency_rad_; ///< MRTD through noise and frequency where nothing blurs
    /// The MTF by direction, at equal steps up to Nyquist's frequency, or to where it is reversed.
    std::array<std::vector<double>, 2> looks_;
};

/// The target transfer probability function x^E / (1 + x^E), E = constant + slope x, x = cycles
/// through those of 50 %.
struct TaskLaw {
    double constant, slope;
};
/// Johnson's (Holst, Electro-Optical Imaging System Performance).
inline constexpr TaskLaw johnsonLaw{2.7, 0.7};

/// Johnson's criteria: a task needs so many cycles across the critical dimension of a target, the
/// square root of its projected area, for a probability of 50 %; for others by the law.
double taskProbability(double cycles, double cyclesOfHalf, const TaskLaw& law = johnsonLaw);

struct JohnsonTask {
    const char* name;
    double cyclesOfHalf;
};

/// Detection, recognition and identification with the cycles of the two-dimensional criterion
/// (ACQUIRE): 0.75, 3 and 6.
const std::vector<JohnsonTask>& johnsonTasks();

/// The cycles that a task needs for a probability between 0 and 1, both exclusive (InputError).
double taskCycles(double probability, double cyclesOfHalf, const TaskLaw& law = johnsonLaw);

} // namespace irsg
