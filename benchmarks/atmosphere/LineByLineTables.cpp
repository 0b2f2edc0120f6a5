#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/TruthPaths.h"

namespace irsg::accuracy {

namespace {

using namespace lbl;

constexpr std::size_t atmospheres = 6;

/// One path in one band, bin by bin.
struct Bins {
    std::vector<double> transmittance, radiance; ///< W m-2 sr-1 per cm-1
};
using Truth =
    std::array<std::array<std::array<Bins, truthBands.size()>, truthPaths.size()>, atmospheres>;

Truth readTruth(const std::filesystem::path& file) {
    Truth truth;
    for (const std::string& line : readTextLines(file)) {
        std::istringstream text(line);
        std::array<double, 5> cells{};
        std::size_t count = 0;
        for (std::string cell; count < cells.size() && std::getline(text, cell, ',');) {
            const auto number = parseNumber(cell);
            if (!number)
                break;
            cells[count++] = *number;
        }
        if (count < cells.size())
            continue; // a comment or the names of the columns
        const auto band = std::ranges::find_if(truthBands, [&](const TruthBand& candidate) {
            return cells[2] >= candidate.lower_per_cm && cells[2] < candidate.upper_per_cm;
        });
        const auto atmosphere = static_cast<std::size_t>(cells[0]) - 1;
        const auto path = static_cast<std::size_t>(cells[1]);
        if (atmosphere >= atmospheres || path >= truthPaths.size() || band == truthBands.end())
            throw InputError(
                Diagnostic{file.string(), "", line, "a row of one of the truth paths"});
        Bins& bins = truth[atmosphere][path][static_cast<std::size_t>(band - truthBands.begin())];
        bins.transmittance.push_back(cells[3]);
        bins.radiance.push_back(cells[4]);
    }
    return truth;
}

/// The spectral mode's means over the same bins.
Bins ours(const RadiativeTransfer& transfer, const AtmosphericPath& path, const TruthBand& band) {
    const BinSet& set = transfer.gases().bins(5);
    const auto [first, last] = set.range(band.lower_per_cm, band.upper_per_cm);
    NodeSet nodes;
    for (std::size_t bin = first; bin < last; ++bin)
        for (std::uint32_t i = 0; i < set.bins[bin].count; ++i) {
            nodes.nodes.push_back(set.nodes[set.bins[bin].first + i]);
            nodes.wavenumbers_per_cm.push_back(
                transfer.gases().wavenumber_per_cm(nodes.nodes.back()));
        }
    const auto transmittance = transfer.transmittance(nodes, path);
    const auto radiance = transfer.pathRadiance(nodes, path, {0.0, -0.5 * std::numbers::pi});
    Bins bins;
    std::size_t node = 0;
    for (std::size_t bin = first; bin < last; ++bin) {
        double t = 0.0, r = 0.0;
        for (std::uint32_t i = 0; i < set.bins[bin].count; ++i, ++node) {
            const double weight = static_cast<double>(set.weights[set.bins[bin].first + i]);
            const double nu = nodes.wavenumbers_per_cm[node];
            t += weight * transmittance[node];
            r += weight * radiance[node] * 1e4 / (nu * nu);
        }
        bins.transmittance.push_back(t);
        bins.radiance.push_back(r);
    }
    return bins;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values)
        total += value;
    return total;
}

} // namespace

void lineByLineTables(const Output& output) {
    const Truth truth = readTruth(output.truth);
    constexpr const char* names[truthBands.size()] = {"8-12", "3-5", "1.5-2.5"};
    struct Score {
        double squares = 0.0, largest = 0.0, bins = 0.0;
        double worstMean = 0.0, worstRadiance = 0.0, radianceSquares = 0.0, paths = 0.0;
    };
    std::array<std::array<Score, truthPaths.size() + 1>, truthBands.size()> scores{};
    for (std::size_t atmosphere = 0; atmosphere < atmospheres; ++atmosphere) {
        AtmosphericModel air{Profile::model(static_cast<ModelAtmosphere>(atmosphere + 1)), {}};
        air.scattering = ScatteringMode::single;
        const RadiativeTransfer transfer(air, GasTable::shipped());
        for (std::size_t path = 0; path < truthPaths.size(); ++path)
            for (std::size_t band = 0; band < truthBands.size(); ++band) {
                const Bins& theirs = truth[atmosphere][path][band];
                const Bins own = ours(transfer, truthPaths[path], truthBands[band]);
                if (own.transmittance.size() != theirs.transmittance.size())
                    throw LogicError("the table of gases has other bins than line by line");
                const double count = static_cast<double>(own.transmittance.size());
                const double meanError =
                    (sum(own.transmittance) - sum(theirs.transmittance)) / count;
                const double radianceError = sum(own.radiance) / sum(theirs.radiance) - 1.0;
                for (const std::size_t row : {path, truthPaths.size()}) {
                    Score& score = scores[band][row];
                    for (std::size_t bin = 0; bin < own.transmittance.size(); ++bin) {
                        const double error = own.transmittance[bin] - theirs.transmittance[bin];
                        score.squares += error * error;
                        score.largest = std::max(score.largest, std::abs(error));
                    }
                    score.bins += count;
                    score.paths += 1.0;
                    score.worstMean = std::max(score.worstMean, std::abs(meanError));
                    score.worstRadiance = std::max(score.worstRadiance, std::abs(radianceError));
                    score.radianceSquares += radianceError * radianceError;
                }
            }
    }
    Table table("Spectral mode against line by line, 5 cm⁻¹, six model atmospheres",
                {"path", "µm", "RMS Δτ", "largest Δτ", "largest in-band Δτ", "RMS in-band ΔL",
                 "largest in-band ΔL"});
    for (std::size_t path = 0; path <= truthPaths.size(); ++path)
        for (std::size_t band = 0; band < truthBands.size(); ++band) {
            const Score& score = scores[band][path];
            const std::string where =
                path == truthPaths.size()
                    ? "all 60"
                    : text("%g", truthPaths[path].sensorAltitude_m / 1e3) + " to " +
                          text("%g", truthPaths[path].targetAltitude_m / 1e3) + " km, " +
                          text("%g km", truthPaths[path].range_m / 1e3);
            table.add({where, names[band], text("%.4f", std::sqrt(score.squares / score.bins)),
                       text("%.4f", score.largest), text("%.4f", score.worstMean),
                       text("%.2f %%", 100.0 * std::sqrt(score.radianceSquares / score.paths)),
                       text("%.2f %%", 100.0 * score.worstRadiance)});
        }
    table.print();
}

} // namespace irsg::accuracy
