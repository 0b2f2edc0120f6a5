#include "smatcore/analysis/TargetSight.h"

#include <numeric>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/sensor/PointSpread.h"

namespace smat {

namespace {

/// Below it no temperature difference stands for a contrast.
constexpr double leastBackground_K = 50.0;

std::string percentText(double part) {
    return irsg::roundedText(100.0 * part, 6) + " %";
}

} // namespace

std::vector<TargetSight::PlaceEnergy> TargetSight::energiesOf(const irsg::SensorDescription& sensor,
                                                              double source_K) {
    const irsg::PointSpread spread(sensor, source_K);
    const irsg::GaussRule& rule = irsg::gaussLegendre(6);
    std::vector<PlaceEnergy> energies;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j)
            energies.push_back({rule.weights[i] * rule.weights[j],
                                spread.energyAt(0.5 * rule.nodes[i], 0.5 * rule.nodes[j])});
    return energies;
}

double TargetSight::ensquaredEnergy(const irsg::SensorDescription& sensor, PointPlace place,
                                    double source_K) {
    const irsg::PointSpread spread(sensor, source_K);
    if (place == PointPlace::centre)
        return spread.energyAt(0.0, 0.0);
    if (place == PointPlace::corner)
        return spread.energyAt(0.5, 0.5);
    double mean = 0.0;
    for (const PlaceEnergy& one : energiesOf(sensor, source_K))
        mean += one.weight * one.energy;
    return mean;
}

TargetSight::TargetSight(const DetectionRequest& request)
    : request_(request),
      response_(request.sensor),
      energy_(ensquaredEnergy(request.sensor, request.place, usual_K())) {
    if (request.criterion == RangeCriterion::bars)
        resolvable_.emplace(request.sensor, usual_K(), request.observer);
    if (request.criterion == RangeCriterion::targeting)
        targeting_.emplace(request.sensor, usual_K(), request.observer, request.display);
    if (request.needsProbability())
        energies_ = energiesOf(request.sensor, usual_K());
}

void TargetSight::see(TargetLook& look) {
    const Background& behind = background(look.background_W_m2_sr);
    look.isFull = behind.isFull;
    const double clutter = look.clutter_W_m2_sr * response_.signalPerRadiance();
    const double noise = std::hypot(behind.noise.total(), behind.clutter, clutter);
    look.nei_W_m2 = noise / (response_.signalPerIrradiance() * energy_);
    look.noiseError =
        clutter * look.clutterError_W_m2_sr * response_.signalPerRadiance() / (noise * noise);
    if (!isOfCycles() || look.solidAngle_sr <= 0.0)
        return;
    look.difference_K = std::abs(look.counted_W_m2) / look.solidAngle_sr *
                        response_.signalPerRadiance() / behind.contrast_per_K;
    look.cycles =
        (resolvable_ ? resolvable_->frequency_per_rad(look.difference_K, behind.perceived_K)
                     : targeting_->cycles_per_rad(look.difference_K, behind.perceived_K)) *
        std::sqrt(look.solidAngle_sr);
}

double TargetSight::relativeError(const TargetLook& look) {
    const double value = reached(look);
    if (value == 0.0 || look.counted_W_m2 == 0.0)
        return 0.0;
    if (!isOfCycles())
        return std::hypot(look.error_W_m2 / look.counted_W_m2, look.noiseError);
    const auto reachedWith = [&](double contrast_W_m2) {
        TargetLook other = look;
        other.counted_W_m2 = std::max(0.0, contrast_W_m2);
        see(other);
        return reached(other);
    };
    const double contrast_W_m2 = std::abs(look.counted_W_m2);
    return 0.5 *
           (reachedWith(contrast_W_m2 + look.error_W_m2) -
            reachedWith(contrast_W_m2 - look.error_W_m2)) /
           value;
}

double TargetSight::wanted() const {
    if (isOfCycles())
        return irsg::taskCycles(request_.task.probability, request_.task.cyclesOfHalf,
                                lawOf(request_.criterion));
    return request_.pointProbability ? ratioOf(*request_.pointProbability) : request_.threshold;
}

double TargetSight::probability(const TargetLook& look) const {
    return isOfCycles() ? irsg::taskProbability(look.cycles, request_.task.cyclesOfHalf,
                                                lawOf(request_.criterion))
                        : pointProbability(look.snr());
}

double TargetSight::pointProbability(double snr) const {
    double sum = 0.0;
    for (const auto& [weight, energy] : energies_)
        sum += weight * 0.5 *
               std::erfc((request_.threshold - snr * energy / energy_) / std::sqrt(2.0));
    return sum;
}

double TargetSight::ratioOf(double probability) const {
    double low = 0.0, high = request_.threshold + 10.0;
    if (pointProbability(low) >= probability)
        throw irsg::InputError(
            {"", "probability of detection", percentText(probability),
             "more than that of a false alarm, " + percentText(pointProbability(low))});
    while (pointProbability(high) < probability)
        high *= 2.0;
    for (int i = 0; i < 80; ++i) {
        const double middle = std::midpoint(low, high);
        (pointProbability(middle) < probability ? low : high) = middle;
    }
    return high;
}

const TargetSight::Background& TargetSight::background(double radiance_W_m2_sr) {
    const double key = request_.background_K.value_or(radiance_W_m2_sr);
    if (const auto known = known_.find(key); known != known_.end())
        return known->second;
    return known_[key] = made(radiance_W_m2_sr); // which may throw
}

TargetSight::Background TargetSight::made(double radiance_W_m2_sr) const {
    Background made;
    irsg::PixelSignal signal = response_.offset();
    signal.scene = request_.background_K ? response_.signal(*request_.background_K).scene
                                         : radiance_W_m2_sr * response_.signalPerRadiance();
    made.isFull = signal.total() >= response_.fullSignal();
    made.noise = response_.noise(signal);
    if (!isOfCycles() && request_.clutter_K == 0.0)
        return made;
    made.contrast_per_K = response_.contrast_per_K(temperature_K(radiance_W_m2_sr));
    made.clutter = request_.clutter_K * made.contrast_per_K;
    made.perceived_K =
        irsg::perceivedNoise_K(request_.sensor, made.noise, made.contrast_per_K, request_.observer);
    return made;
}

double TargetSight::temperature_K(double radiance_W_m2_sr) const {
    const std::optional<double> background_K =
        request_.background_K
            ? request_.background_K
            : irsg::apparentTemperature_K(request_.sensor.band(), radiance_W_m2_sr);
    if (!background_K || *background_K < leastBackground_K)
        throw irsg::InputError(
            {"", "background of the scene",
             irsg::numberText(background_K.value_or(0.0)) + " K in the sensor's band",
             "at least " + irsg::numberText(leastBackground_K) +
                 " K, before which bars and clutter have a temperature difference, or a "
                 "background temperature that is given"});
    return *background_K;
}

double TargetSight::temperatureDifference_K(double difference_W_m2_sr,
                                            double background_W_m2_sr) const {
    return difference_W_m2_sr == 0.0
               ? 0.0
               : difference_W_m2_sr * response_.signalPerRadiance() /
                     response_.contrast_per_K(temperature_K(background_W_m2_sr));
}

} // namespace smat
