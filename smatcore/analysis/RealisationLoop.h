#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "smatcore/analysis/MonteCarloData.h"

namespace smat {

/// Draws scales until there are as many draws as were asked for, or the statistic is known well
/// enough. Draws are made in parallel; what comes of one depends on its number alone.
class RealisationLoop {
  public:
    /// The quantity at every place of all parts, one after the other, as a function of the scales.
    /// May be asked by several threads at a time.
    using Values = std::function<std::vector<double>(const std::vector<double>& scales)>;

    /// The parts have one set of options, those of the first, and as many values in `nominal` as
    /// they have places. All must outlive it.
    RealisationLoop(std::vector<MonteCarloData*> parts, const ScalingRealisations& realisations,
                    Values valuesAt);

    /// Throws InputError where no scale varies, and for more than 5e7 values.
    static void check(const std::vector<SceneScaling>& scalings, std::size_t samples,
                      std::size_t places);
    /// How often `run` tells of itself, at most.
    static std::size_t steps(std::size_t samples);

    /// Fills in values and statistic, and whether the standard error was reached. `tell` hears the
    /// number of the next draw, 256 draws apart. A stop keeps the draws there are, at least 256.
    void run(const std::function<void(std::size_t draw)>& tell, const std::stop_token& stop);
    /// Warnings of parts that were stopped, or whose standard error was not reached.
    void tellShortcomings() const;

  private:
    std::size_t realisations() const;
    std::vector<Estimate> statisticsOf(const MonteCarloData& part) const;
    /// Largest standard error over the largest magnitude of the statistic, of the worst part.
    double relativeError() const;
    double relativeErrorOf(const MonteCarloData& part) const;

    std::vector<MonteCarloData*> parts_;
    const MonteCarloOptions& options_;
    const ScalingRealisations& realisations_;
    Values valuesAt_;
};

} // namespace smat
