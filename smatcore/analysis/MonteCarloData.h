#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/analysis/ScalingRealisations.h"
#include "smatcore/analysis/SobolIndices.h"

namespace smat {

/// What a Monte Carlo analysis looks at, and when it has seen enough. The seed is the setting
/// `scaling.seed` of its analysis.
struct MonteCarloOptions {
    enum class Quantity { intensity, contrastIntensity, irradiance };

    static constexpr int leastSamples = 2, mostSamples = 10'000'000;
    static constexpr int mostSubpixelShifts = 64;
    static constexpr int leastRankingPairs = 256, mostRankingPairs = 1'000'000;

    std::size_t samples = 1024; ///< draws at most
    RealisationSequence sequence = RealisationSequence::sobol;
    Quantity quantity = Quantity::contrastIntensity;
    std::vector<double> percentiles = {5.0, 25.0, 50.0, 75.0, 95.0};
    /// What the standard error is told of, and what ends the draws early.
    Statistic statistic;
    /// Ends once the standard error of the statistic is below this part of its largest magnitude
    /// over the sweep; without it all draws are made.
    std::optional<double> standardError;
    /// Drawings of every case with the target at different places among the pixels, the first in
    /// its own, for the numerical error. 1 leaves it out.
    int subpixelShifts = 4;
    bool ranking = false;
    std::size_t rankingPairs = 1024; ///< draws with companions
    /// Where the ranking looks, in the unit of the abscissa (wavelength in um for spectra): the
    /// nearest one, within the sweep, at all places of the other axes; the whole sweep where it is
    /// not set.
    std::optional<double> rankingAt;

    /// Throws InputError naming every option that cannot be.
    void check() const;
};

/// "contrast_intensity": the word of files and commands.
std::string name(MonteCarloOptions::Quantity quantity);
std::optional<MonteCarloOptions::Quantity> monteCarloQuantity(std::string_view word);
/// "mean", "standard-deviation", "p95".
std::string name(const Statistic& statistic);
std::optional<Statistic> statisticFromName(std::string_view word);

/// One Monte Carlo analysis: what is asked, and, once it ran, what came out.
struct MonteCarloData {
    AnalysisData analysis; ///< its kind, project and settings; table, summary and warnings come out
    MonteCarloOptions options;

    std::uint64_t seed = 1;                ///< of the draws that were made
    std::vector<SceneScaling> scalings;    ///< those that have an effect
    std::string unit;                      ///< of the values
    std::string abscissaKey, abscissaUnit; ///< "wavelength", "um"
    std::vector<double> abscissae;         ///< of a spectrum, wavelengths in um
    /// Of a sweep over several axes: the others, each with its value at each abscissa.
    std::vector<ResultColumn> otherAxes;
    std::vector<std::string> bands; ///< labels of several bands; one "" of one
    // By place: all abscissae in the first band, then all in the next.
    std::vector<std::vector<double>> values; ///< by place, then by draw
    std::vector<double> nominal;             ///< at scales of 1
    /// At scales of 1: as stated of the drawing, or what subpixel shifts show, whichever is more.
    std::vector<double> numericalError;
    ErrorColumns errors = ErrorColumns::none;
    std::vector<std::string> caseWarnings;       ///< of a sweep, by abscissa; "" for nothing
    std::vector<irsg::ErrorParts> nominalErrors; ///< stated ones at scales of 1; NaN where unknown
    std::vector<Estimate> statistic;             ///< by place
    std::vector<RankedScaling> ranking;
    bool reachedStandardError = false;

    std::size_t realisations() const { return values.empty() ? 0 : values.front().size(); }
    /// The command that does the same from a terminal.
    std::string equivalentCommand(const std::string& outputFile) const;
    /// The abscissa nearest to a number: its place in the first band, the first of several.
    std::size_t nearest(double abscissa) const;
    /// The same of all rows with that abscissa, which differ in the other axes.
    std::vector<std::size_t> allNearest(double abscissa) const;
    /// Rows that differ from one in the abscissa alone, ascending, itself among them.
    std::vector<std::size_t> rowsAlong(std::size_t row) const;
    /// "90 deg", of several axes "azimuth 90 deg, elevation 5 deg".
    std::string rowPlace(std::size_t row) const;
    /// "90 deg": where the ranking looked, over the other axes where there are some: "90 deg, 5
    /// rows"; "" for the whole sweep.
    std::string rankedPlace() const;
    /// Values over the abscissae of one band, from values by place.
    std::vector<double> ofBand(const std::vector<double>& byPlace, std::size_t band) const;
    /// "mean", or "mean@3-5um" of one of several bands: the key of a column.
    std::string columnKey(const std::string& what, std::size_t band) const;
};

/// The number of the place that is nearest to one; there must be some.
std::size_t nearestPlace(const std::vector<double>& places, double wanted);

} // namespace smat
