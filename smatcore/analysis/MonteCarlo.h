#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/CaseStore.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/analysis/ScalingDraws.h"
#include "smatcore/analysis/SobolIndices.h"

namespace smat {

/// What a Monte Carlo analysis looks at, and when it has seen enough. The seed is the setting
/// `scaling.seed` of its analysis.
struct MonteCarloOptions {
    enum class Quantity { intensity, contrastIntensity, irradiance };

    static constexpr int leastSamples = 2, mostSamples = 10'000'000;
    static constexpr int mostPhases = 64;
    static constexpr int leastRankingPairs = 256, mostRankingPairs = 1'000'000;

    std::size_t samples = 1024; ///< draws at most
    DrawSequence sequence = DrawSequence::sobol;
    Quantity quantity = Quantity::contrastIntensity;
    std::vector<double> percentiles = {5.0, 25.0, 50.0, 75.0, 95.0};
    /// What the standard error is told of, and what ends the draws early.
    Statistic statistic;
    /// Ends once the standard error of the statistic is below this part of its largest magnitude
    /// over the sweep; without it all draws are made.
    std::optional<double> standardError;
    /// Drawings of every case with the target at different places among the pixels, the first in
    /// its own: their spread is the numerical error. 1 leaves it out.
    int phases = 4;
    bool ranking = false;
    std::size_t rankingPairs = 1024; ///< draws with companions
    /// Where the ranking looks, in the unit of the abscissa (wavelength in um for spectra): the
    /// nearest one; the whole sweep where it is not set.
    std::optional<double> rankingAt;

    /// Throws InputError naming every option that cannot be.
    void check() const;
};

/// What cannot be asked of Monte Carlo, told by those that run it.
irsg::InputError monteCarloRefusal(std::string position, std::string value, std::string expected);

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
    std::vector<std::string> bands;        ///< labels of several bands; one "" of one
    // By place: all abscissae in the first band, then all in the next.
    std::vector<std::vector<double>> values; ///< by place, then by draw
    std::vector<double> nominal;             ///< at scales of 1
    std::vector<double> numericalError;      ///< standard deviation over the phases
    ErrorColumns errors = ErrorColumns::none;
    std::vector<irsg::ErrorParts> nominalErrors; ///< stated ones at scales of 1, where asked for
    std::vector<Estimate> statistic;             ///< by place
    std::vector<RankedScaling> ranking;
    bool reachedStandardError = false;

    std::size_t draws() const { return values.empty() ? 0 : values.front().size(); }
    /// The command that does the same from a terminal.
    std::string equivalentCommand(const std::string& outputFile) const;
    /// The abscissa nearest to a number: its place in the first band.
    std::size_t nearest(double abscissa) const;
    /// Values over the abscissae of one band, from values by place.
    std::vector<double> ofBand(const std::vector<double>& byPlace, std::size_t band) const;
    /// "mean", or "mean@3-5um" of one of several bands: the key of a column.
    std::string columnKey(const std::string& what, std::size_t band) const;
};

/// Repeats an analysis of intensities over the scales of its scaling files (F55 to F57). Geometry
/// is drawn once per case and the air asked once; a draw is a few sums (irsg::ScaledView).
class MonteCarlo {
  public:
    MonteCarlo(ImageSource& source, SceneFactory scenes);

    /// Fills in the results. A stop keeps the cases and draws there are, at least 256 draws once a
    /// case is drawn, and marks them `partial`. Target and viewpoint are put back. Throws
    /// InputError: options that cannot be, an image analysis, no scaling files, no scale that
    /// varies, more than 5e7 values.
    void run(MonteCarloData& data, const ProgressCallback& progress = {}, std::stop_token stop = {},
             StageTimer* timer = nullptr);
    /// The same case by case, for runs in parts: each is drawn and goes through all draws before
    /// the next one. The table comes out with the bytes of one run, and no values of draws. Throws
    /// InputError, too, for what follows from all cases (a ranking, a standard error that ends the
    /// draws) and for a spectrum, which has one.
    void run(MonteCarloData& data, CaseStore& store, const ProgressCallback& progress = {},
             std::stop_token stop = {}, StageTimer* timer = nullptr);

  private:
    ImageSource& source_;
    SceneFactory scenes_;
};

/// Bands as CSV, or everything as JSON; with a CSV of bands the ranking goes to FILE-ranking.csv
/// beside it. Throws InputError for another extension and for a file that cannot be written.
/// Returns the files written.
std::vector<std::filesystem::path> saveMonteCarlo(const MonteCarloData& data,
                                                  const std::filesystem::path& file);
/// The single values of all draws, which no table holds, as an image of 32-bit floats: place after
/// place, draw after draw, in rows of 4096, the rest of the last row 0. LogicError before a run.
irsg::RadianceImage drawsImage(const MonteCarloData& data);
/// The raw draws: a row a draw with its number, `draw`, its scales, `scale NAME`, and the quantity
/// at each place, `contrast_intensity at 90 deg@3-5um`. Of a run that was read back the quantities
/// have the 7 digits that it keeps. LogicError before a run.
ResultTable drawsTable(const MonteCarloData& data);
/// The same of several runs with the same draws, each of an object, `near.contrast_intensity at 2
/// s`; provenance is that of the last.
struct NamedDraws {
    std::string object; ///< "" of all together
    const MonteCarloData* data;
};
ResultTable drawsTable(const std::vector<NamedDraws>& runs);
/// Reads back what saveMonteCarlo wrote as .json, with the values of drawsImage. What was asked is
/// not in a file: project and settings stay empty. Throws InputError for a file of another form and
/// for draws that do not fit it.
MonteCarloData loadMonteCarlo(const std::filesystem::path& file, const irsg::RadianceImage& draws);
/// Place in the ranking, kind (0 temperature, 1 emissivity), index and Sobol' indices with their
/// intervals; names in the provenance.
ResultTable rankingTable(const MonteCarloData& data);

} // namespace smat
