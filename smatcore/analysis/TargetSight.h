#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/SensorNumbers.h"
#include "irsg/sensor/TargetingTask.h"
#include "smatcore/analysis/DetectionRequest.h"

namespace smat {

/// What is known of a target at a range.
struct TargetLook {
    double contrast_W_m2 = 0.0, contrast_W_sr = 0.0, error_W_m2 = 0.0;
    double counted_W_m2 = 0.0, solidAngle_sr = 0.0; ///< of the surfaces that count
    double background_W_m2_sr = 0.0;
    /// Of the background's own pixels, with the error of that number.
    double clutter_W_m2_sr = 0.0, clutterError_W_m2_sr = 0.0;
    double nei_W_m2 = 0.0;
    double noiseError = 0.0;                 ///< of it, relative, by that of the clutter
    double difference_K = 0.0, cycles = 0.0; ///< of criteria of cycles
    bool isFull = false;                     ///< the pixel, of the background alone
    /// How far what was sampled for other ranges, too, reaches from the target's reference point;
    /// 0 where it was sampled for this range alone.
    double alongRangeReach_m = 0.0;
    double snr() const { return std::abs(contrast_W_m2) / nei_W_m2; }
};

/// What a sensor makes of a background and of a target before it, by the criterion of a request,
/// which must outlive it.
class TargetSight {
  public:
    /// Throws InputError as ResolvableTemperature and TargetingTask do.
    explicit TargetSight(const DetectionRequest& request);

    /// The ensquared energy of a point at the place that is asked for.
    double energy() const { return energy_; }
    /// Sets what follows from contrast, solid angle, clutter and the background's radiance. Throws
    /// InputError for a background without a temperature where one is needed.
    void see(TargetLook& look);
    /// A difference of radiance as one of the temperature of a background of this radiance, or of
    /// the one that is asked for. 0 of 0; else throws InputError for one without a temperature.
    double temperatureDifference_K(double difference_W_m2_sr, double background_W_m2_sr) const;

    bool isOfCycles() const { return resolvable_ || targeting_; }
    /// What has to be reached: cycles, or the ratio of a point. Throws InputError for a
    /// probability that noise alone exceeds.
    double wanted() const;
    double reached(const TargetLook& look) const { return isOfCycles() ? look.cycles : look.snr(); }
    /// The relative error of that at two standard deviations, by those of contrast and noise: half
    /// of the difference between what a contrast that is larger by its error reaches and one that
    /// is smaller.
    double relativeError(const TargetLook& look);
    /// Of the task, or that the signal of a point with its noise passes the threshold.
    double probability(const TargetLook& look) const;

  private:
    /// The ensquared energy at places of a quarter of the pixel, whose weights sum up to 1.
    struct PlaceEnergy {
        double weight, energy;
    };
    struct Background {
        irsg::PixelNoise noise;
        bool isFull = false;
        double contrast_per_K = 0.0, perceived_K = 0.0; ///< of cycles
        double clutter = 0.0;                           ///< in the unit of the noise
    };
    static std::vector<PlaceEnergy> energiesOf(const irsg::SensorDescription& sensor,
                                               double source_K);
    static double ensquaredEnergy(const irsg::SensorDescription& sensor, PointPlace place,
                                  double source_K);
    double pointProbability(double snr) const;
    double ratioOf(double probability) const;
    /// Of which the optics' spectrum is.
    double usual_K() const { return request_.background_K.value_or(300.0); }
    const Background& background(double radiance_W_m2_sr);
    Background made(double radiance_W_m2_sr) const;
    double temperature_K(double radiance_W_m2_sr) const;

    const DetectionRequest& request_;
    irsg::PixelResponse response_;
    double energy_;
    std::optional<irsg::ResolvableTemperature> resolvable_;
    std::optional<irsg::TargetingTask> targeting_;
    std::vector<PlaceEnergy> energies_;  ///< of points with a probability
    std::map<double, Background> known_; ///< by its temperature, or radiance
};

} // namespace smat
