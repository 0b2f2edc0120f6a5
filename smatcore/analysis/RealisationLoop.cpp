#include "smatcore/analysis/RealisationLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"

namespace smat {

namespace {

constexpr std::size_t batch = 256;
constexpr std::size_t mostValues = 50'000'000;

} // namespace

RealisationLoop::RealisationLoop(std::vector<MonteCarloData*> parts,
                                 const ScalingRealisations& realisations, Values valuesAt)
    : parts_(std::move(parts)),
      options_(parts_.front()->options),
      realisations_(realisations),
      valuesAt_(std::move(valuesAt)) {}

void RealisationLoop::check(const std::vector<SceneScaling>& scalings, std::size_t samples,
                            std::size_t places) {
    if (std::ranges::all_of(scalings, [](const SceneScaling& one) { return one.isFixed(); })) {
        throw irsg::InputError({.file = "montecarlo",
                                .position = "scalings",
                                .value = "no scale that varies",
                                .expected = "a scaling file beside the model with min below max "
                                            "for an index that the model has"});
    }
    if (samples > mostValues / std::max<std::size_t>(places, 1)) {
        throw irsg::InputError(
            {.file = "montecarlo",
             .position = "samples",
             .value = fmt::format("{} at {} abscissae", samples, places),
             .expected = fmt::format("at most {} values in all: fewer samples or a coarser sweep",
                                     mostValues)});
    }
}

std::size_t RealisationLoop::steps(std::size_t samples) {
    return (samples + batch - 1) / batch;
}

std::size_t RealisationLoop::realisations() const {
    return parts_.front()->realisations();
}

void RealisationLoop::run(const std::function<void(std::size_t draw)>& tell,
                          const std::stop_token& stop) {
    for (MonteCarloData* part : parts_) {
        part->values.assign(part->nominal.size(), {});
        for (std::vector<double>& values : part->values)
            values.reserve(options_.samples);
    }
    std::size_t nextLook = batch;
    bool isReached = false;
    while (realisations() < options_.samples && !isReached) {
        if (realisations() > 0 && stop.stop_requested())
            break;
        const std::size_t first = realisations();
        tell(first);
        std::vector<std::vector<double>> drawn(std::min(options_.samples, first + batch) - first);
        irsg::parallelFor(drawn.size(), [&](std::size_t i) {
            drawn[i] = valuesAt_(realisations_.at(first + i));
        });
        for (const std::vector<double>& all : drawn) {
            auto value = all.begin();
            for (MonteCarloData* part : parts_)
                for (std::vector<double>& values : part->values)
                    values.push_back(*value++);
        }
        // Looked at ever more rarely: each look sorts what there is.
        if (options_.standardError && realisations() >= nextLook) {
            nextLook = realisations() + realisations() / 4;
            isReached = relativeError() <= *options_.standardError;
        }
    }
    for (MonteCarloData* part : parts_) {
        part->statistic = statisticsOf(*part);
        part->reachedStandardError =
            options_.standardError && relativeErrorOf(*part) <= *options_.standardError;
    }
}

void RealisationLoop::tellShortcomings() const {
    for (MonteCarloData* part : parts_) {
        std::vector<std::string>& warnings = part->analysis.warnings;
        if (part->realisations() < options_.samples && !part->reachedStandardError)
            warnings.push_back(fmt::format("stopped after {} of {} draws", part->realisations(),
                                           options_.samples));
        if (options_.standardError && !part->reachedStandardError)
            warnings.push_back(fmt::format(
                "the standard error of the {} is {:.2g} of its largest magnitude after {} draws; "
                "{:.2g} was asked for",
                name(options_.statistic), relativeErrorOf(*part), part->realisations(),
                *options_.standardError));
    }
}

std::vector<Estimate> RealisationLoop::statisticsOf(const MonteCarloData& part) const {
    std::vector<Estimate> estimates;
    for (const std::vector<double>& values : part.values)
        estimates.push_back(options_.sequence == RealisationSequence::sobol
                                ? estimateByReplicates(values, sobolReplicates, options_.statistic)
                                : estimate(values, options_.statistic));
    return estimates;
}

double RealisationLoop::relativeErrorOf(const MonteCarloData& part) const {
    double error = 0.0, magnitude = 0.0;
    for (const Estimate& one : statisticsOf(part)) {
        if (!std::isfinite(one.standardError)) // no bound yet
            return std::numeric_limits<double>::infinity();
        error = std::max(error, one.standardError);
        magnitude = std::max(magnitude, std::abs(one.value));
    }
    return error == 0.0 ? 0.0 : error / magnitude;
}

double RealisationLoop::relativeError() const {
    double worst = 0.0;
    for (const MonteCarloData* part : parts_)
        worst = std::max(worst, relativeErrorOf(*part));
    return worst;
}

} // namespace smat
