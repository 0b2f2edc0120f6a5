#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <sstream>
#include <thread>

#include "apps/atmosphere-tables/Command.h"
#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/lbl/CompleteLines.h"
#include "irsg/atmosphere/lbl/NodeTraining.h"
#include "irsg/atmosphere/lbl/PartitionSums.h"
#include "irsg/radiometry/Errors.h"

namespace smat::tables {

namespace {

using namespace irsg;
using namespace irsg::lbl;

/// An interval of the spectrum that is worked on at once.
struct Piece {
    double lower_cm = 0.0, upper_cm = 0.0;
    int width_cm = 1;       ///< of the narrowest bins
    double step_cm = 0.001; ///< of the line-by-line grid
};

/// Where there are line lists, bins of 1 cm-1 have a meaning; where lines were made from bands of
/// 20 cm-1, they are of 5; where no line gas absorbs, of 15.
std::vector<Piece> pieces() {
    constexpr double first_cm = 240.0, lines_cm = 480.0, bands_cm = 6420.0, smooth_cm = 18000.0;
    std::vector<Piece> all;
    for (double lower = first_cm; lower < smooth_cm; lower += 60.0) {
        Piece piece{lower, lower + 60.0, 1, lower < 2400.0 ? 0.001 : 0.002};
        if (lower < lines_cm || lower >= bands_cm) {
            piece.width_cm = 5;
            piece.step_cm = lower < lines_cm ? 0.002 : 0.004;
        }
        all.push_back(piece);
    }
    return all;
}

CrossSectionGrid crossSectionGrid() {
    CrossSectionGrid grid;
    grid.pressures_hPa = {1100, 750, 500, 330, 215, 135, 80, 45, 22, 9, 3, 0.8, 0.1};
    grid.temperatures_K = {180, 210, 240, 270, 300, 330};
    grid.moistFraction = 0.04;
    grid.moistPressures = 6;
    return grid;
}

/// Lines that reach into a piece of the spectrum.
LineList linesNear(const LineList& list, const Piece& piece, double reach_cm) {
    const auto first =
        std::ranges::lower_bound(list.lines, piece.lower_cm - reach_cm, {}, &Line::wavenumber_cm);
    const auto last =
        std::ranges::upper_bound(list.lines, piece.upper_cm + reach_cm, {}, &Line::wavenumber_cm);
    return {list.gas, {first, last}, {}};
}

FineCrossSections fineCrossSections(const std::vector<LineList>& gases,
                                    const PartitionSums& partition, const CrossSectionGrid& grid,
                                    const Piece& piece) {
    FineCrossSections fine;
    fine.grid.step_cm = piece.step_cm;
    fine.grid.first_cm = piece.lower_cm + 0.5 * piece.step_cm;
    fine.grid.count =
        static_cast<std::size_t>(std::lround((piece.upper_cm - piece.lower_cm) / piece.step_cm));

    constexpr double nothing_cm2 = 1e-33;
    for (const LineList& gas : gases) {
        const LineShape shape = defaultLineShape(gas.gas);
        const LineList near = linesNear(gas, piece, shape.cut_cm + 1.0);
        if (near.lines.empty())
            continue;
        auto& points = fine.lnCrossSection[static_cast<std::size_t>(gas.gas)];
        auto add = [&](double pressure_hPa, double temperature_K, double fraction) {
            const std::vector<double> k = crossSection_cm2(
                near, partition, fine.grid, temperature_K, pressure_hPa, fraction, shape);
            std::vector<float> ln(k.size());
            std::ranges::transform(k, ln.begin(), [](double value) {
                return std::log(static_cast<float>(std::max(value, nothing_cm2)));
            });
            points.push_back(std::move(ln));
        };
        const double carbonDioxide = gas.gas == Gas::CO2 ? 4e-4 : 0.0;
        const double own = gas.gas == Gas::O2 ? 0.209 : carbonDioxide;
        for (const double pressure : grid.pressures_hPa)
            for (const double temperature : grid.temperatures_K)
                add(pressure, temperature, own);
        if (gas.gas == Gas::H2O)
            for (std::size_t i = 0; i < grid.moistPressures; ++i)
                for (const double temperature : grid.temperatures_K)
                    add(grid.pressures_hPa[i], temperature, grid.moistFraction);
    }
    return fine;
}

/// The whole table, put together from its pieces in order of wavenumber.
class Assembly {
  public:
    void add(TrainedNodes piece) {
        const auto shift = static_cast<std::uint32_t>(wavenumbers_cm.size());
        wavenumbers_cm.insert(wavenumbers_cm.end(), piece.wavenumbers_cm.begin(),
                              piece.wavenumbers_cm.end());
        for (GasTable::Block& block : piece.blocks) {
            block.node += shift;
            blocks.push_back(std::move(block));
        }
        for (std::size_t r = 0; r < bins.size(); ++r) {
            bins[r].resolution_cm = piece.bins[r].resolution_cm;
            const auto first = static_cast<std::uint32_t>(bins[r].nodes.size());
            for (SpectralBin bin : piece.bins[r].bins) {
                bin.first += first;
                bins[r].bins.push_back(bin);
            }
            for (const std::uint32_t node : piece.bins[r].nodes)
                bins[r].nodes.push_back(node + shift);
            bins[r].weights.insert(bins[r].weights.end(), piece.bins[r].weights.begin(),
                                   piece.bins[r].weights.end());
        }
    }
    /// Bins of 15 cm-1 with one node at which no line gas absorbs.
    void addSmooth(double lower_cm, double upper_cm) {
        for (double lower = lower_cm; lower < upper_cm - 1.0; lower += 15.0) {
            TrainedNodes piece;
            piece.wavenumbers_cm = {lower + 7.5};
            for (std::size_t r = 0; r < bins.size(); ++r) {
                piece.bins[r].resolution_cm = GasTable::resolutions_cm[r];
                piece.bins[r].bins = {{lower, lower + 15.0, 0, 1}};
                piece.bins[r].nodes = {0};
                piece.bins[r].weights = {1.0f};
            }
            add(std::move(piece));
        }
    }

    std::vector<double> wavenumbers_cm;
    std::vector<GasTable::Block> blocks;
    std::array<BinSet, 3> bins;
};

/// RMS and largest error of training over ranges that users know.
std::string errorTable(const std::vector<Piece>& work, const std::vector<TrainedNodes>& trained) {
    struct Range {
        double lower_cm, upper_cm;
    };
    constexpr std::array<Range, 8> ranges = {{{240, 480},
                                              {480, 840},
                                              {840, 1260},
                                              {1260, 1980},
                                              {1980, 3360},
                                              {3360, 4020},
                                              {4020, 6420},
                                              {6420, 18000}}};
    std::ostringstream text;
    text << "transmittance against line by line on the training paths, RMS / largest, bins of 1, "
            "5, 15 "
            "cm-1; nodes a bin\n";
    for (const Range& range : ranges) {
        text << range.lower_cm << "-" << range.upper_cm << " cm-1:";
        for (std::size_t r = 0; r < 3; ++r) {
            double squares = 0.0, largest = 0.0;
            std::size_t cases = 0, nodes = 0, bins = 0;
            for (std::size_t i = 0; i < work.size(); ++i)
                if (work[i].lower_cm >= range.lower_cm && work[i].upper_cm <= range.upper_cm) {
                    squares += trained[i].squaredError[r];
                    largest = std::max(largest, trained[i].largestError[r]);
                    cases += trained[i].cases[r];
                    nodes += trained[i].bins[r].nodes.size();
                    bins += trained[i].bins[r].bins.size();
                }
            if (cases == 0)
                continue;
            text << std::fixed << std::setprecision(4) << (r ? "; " : " ")
                 << std::sqrt(squares / static_cast<double>(cases)) << " / " << std::setprecision(3)
                 << largest << std::setprecision(1) << " ("
                 << static_cast<double>(nodes) / static_cast<double>(bins) << ")";
            text.unsetf(std::ios::fixed);
        }
        text << "\n";
    }
    return text.str();
}

} // namespace

void makeGases(const Folders& folders) {
    const PartitionSums partition = PartitionSums::read(folders.data / "lines" / "partition");
    const std::vector<LineList> gases = completeLineLists(folders.data);
    const CrossSectionGrid grid = crossSectionGrid();

    // The training atmospheres differ most in their water; two of them are made moister and drier.
    std::vector<Profile> atmospheres;
    for (int model = 1; model <= 6; ++model)
        atmospheres.push_back(Profile::model(static_cast<ModelAtmosphere>(model)));
    const TrainingPaths training = trainingPaths(atmospheres);
    constexpr std::array<NodeGoals, 3> goals = {{{0.005, 6}, {0.003, 10}, {0.003, 14}}};

    const std::vector<Piece> work = pieces();
    std::vector<TrainedNodes> trained(work.size());
    std::atomic<std::size_t> next = 0;
    std::mutex output;
    auto run = [&] {
        for (std::size_t i = next++; i < work.size(); i = next++) {
            const Piece& piece = work[i];
            const FineCrossSections fine = fineCrossSections(gases, partition, grid, piece);
            trained[i] = trainNodes(fine, grid, training, piece.lower_cm, piece.upper_cm,
                                    piece.width_cm, goals);
            const std::lock_guard lock(output);
            std::cout << piece.lower_cm << "-" << piece.upper_cm
                      << " cm-1: " << trained[i].wavenumbers_cm.size() << " nodes" << std::endl;
        }
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        workers.emplace_back(run);
    workers.clear();

    std::ostringstream header;
    header
        << "Absorption cross sections of the line gases at spectral nodes, computed line by line "
           "by "
           "`atmosphere-tables gases`.\nVoigt lines, 25 cm-1 cut (water with its pedestal removed, "
           "carbon dioxide with sub-Lorentzian wings to 300 cm-1), TIPS-2017 partition sums; nodes "
           "and "
           "weights by optimal spectral sampling (Moncet et al. 2008).\n";
    for (const LineList& gas : gases)
        for (const std::string& origin : gas.origins)
            header << gasNames[static_cast<std::size_t>(gas.gas)] << ": " << origin << "\n";
    header << errorTable(work, trained);

    Assembly table;
    for (TrainedNodes& piece : trained)
        table.add(std::move(piece));
    table.addSmooth(work.back().upper_cm, 50010.0);
    const GasTable result(grid, std::move(table.wavenumbers_cm), std::move(table.blocks),
                          std::move(table.bins), header.str());
    std::cout << result.header() << result.nodeCount() << " nodes" << std::endl;
    result.write(folders.out / "gases.gastable");
}

} // namespace smat::tables
