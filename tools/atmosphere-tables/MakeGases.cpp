#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <span>
#include <sstream>
#include <thread>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/Command.h"
#include "tools/atmosphere-tables/FineSpectrum.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/NodeTraining.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace smat::tables {

namespace {

using namespace irsg;
using namespace irsg::lbl;

/// Where there are line lists, bins of 1 cm-1 have a meaning; where lines were made from bands of
/// 20 cm-1, they are of 5; where no line gas absorbs, of 15.
std::vector<Piece> pieces() {
    constexpr double first_per_cm = 240.0, lines_per_cm = 480.0, bands_per_cm = 6420.0,
                     smooth_per_cm = 18000.0;
    std::vector<Piece> all;
    for (double lower = first_per_cm; lower < smooth_per_cm; lower += 60.0) {
        Piece piece{lower, lower + 60.0, 1, lower < 2400.0 ? 0.001 : 0.002};
        if (lower < lines_per_cm || lower >= bands_per_cm) {
            piece.width_per_cm = 5;
            piece.step_per_cm = lower < lines_per_cm ? 0.002 : 0.004;
        }
        all.push_back(piece);
    }
    return all;
}

/// The whole table, put together from its pieces in order of wavenumber.
class Assembly {
  public:
    void add(TrainedNodes piece) {
        const auto shift = static_cast<std::uint32_t>(wavenumbers_per_cm.size());
        wavenumbers_per_cm.insert(wavenumbers_per_cm.end(), piece.wavenumbers_per_cm.begin(),
                                  piece.wavenumbers_per_cm.end());
        for (GasTable::Block& block : piece.blocks) {
            block.node += shift;
            blocks.push_back(std::move(block));
        }
        for (std::size_t r = 0; r < bins.size(); ++r) {
            bins[r].resolution_per_cm = piece.bins[r].resolution_per_cm;
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
    void addSmooth(double lower_per_cm, double upper_per_cm) {
        for (double lower = lower_per_cm; lower < upper_per_cm - 1.0; lower += 15.0) {
            TrainedNodes piece;
            piece.wavenumbers_per_cm = {lower + 7.5};
            for (std::size_t r = 0; r < bins.size(); ++r) {
                piece.bins[r].resolution_per_cm = GasTable::resolutions_per_cm[r];
                piece.bins[r].bins = {{lower, lower + 15.0, 0, 1}};
                piece.bins[r].nodes = {0};
                piece.bins[r].weights = {1.0f};
            }
            add(std::move(piece));
        }
    }

    std::vector<double> wavenumbers_per_cm;
    std::vector<GasTable::Block> blocks;
    std::array<BinSet, 3> bins;
};

/// A piece of a table that is there, as it was trained.
TrainedNodes keptPiece(const GasTable& table, const Piece& piece) {
    TrainedNodes kept;
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t node = 0; node < table.nodeCount(); ++node)
        if (table.wavenumber_per_cm(node) >= piece.lower_per_cm &&
            table.wavenumber_per_cm(node) < piece.upper_per_cm) {
            nodes.push_back(node);
            kept.wavenumbers_per_cm.push_back(table.wavenumber_per_cm(node));
        }
    const std::uint32_t first = nodes.front();
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        const auto gas = static_cast<Gas>(g);
        const std::vector<std::int32_t> columns = table.columns(gas, nodes);
        std::vector<GasTable::Block> blocks(nodes.size());
        std::vector<float> steps(nodes.size());
        for (std::size_t point = 0; point < table.grid().points(gas); ++point) {
            table.steps(gas, point, columns, steps);
            for (std::size_t i = 0; i < nodes.size(); ++i)
                blocks[i].lnCrossSection.push_back(static_cast<float>(
                    GasTable::lnLowest + GasTable::lnStep * static_cast<double>(steps[i])));
        }
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (columns[i] >= 0) {
                blocks[i].node = nodes[i] - first;
                blocks[i].gas = gas;
                kept.blocks.push_back(std::move(blocks[i]));
            }
    }
    for (std::size_t r = 0; r < kept.bins.size(); ++r) {
        const BinSet& all = table.bins(GasTable::resolutions_per_cm[r]);
        BinSet& own = kept.bins[r];
        own.resolution_per_cm = all.resolution_per_cm;
        for (SpectralBin bin : all.bins) {
            if (bin.lower_per_cm < piece.lower_per_cm - 1e-6 ||
                bin.lower_per_cm > piece.upper_per_cm - 1e-6)
                continue;
            const auto begin = static_cast<std::uint32_t>(own.nodes.size());
            for (std::uint32_t i = bin.first; i < bin.first + bin.count; ++i) {
                own.nodes.push_back(all.nodes[i] - first);
                own.weights.push_back(all.weights[i]);
            }
            bin.first = begin;
            own.bins.push_back(bin);
        }
    }
    return kept;
}

/// The line of a header that begins so, with its end; nothing where there is none.
std::string lineOf(const std::string& header, const std::string& begin) {
    const std::size_t at = header.find("\n" + begin);
    return at == std::string::npos ? "" : header.substr(at + 1, header.find('\n', at + 1) - at);
}

/// RMS and largest error of some pieces in transmittance, by resolution, and nodes a bin.
std::string errorsOf(std::span<const TrainedNodes> pieces) {
    std::ostringstream text;
    for (std::size_t r = 0; r < std::size(GasTable::resolutions_per_cm); ++r) {
        double squares = 0.0, largest = 0.0;
        std::size_t cases = 0, nodes = 0, bins = 0;
        for (const TrainedNodes& piece : pieces) {
            squares += piece.squaredError[r];
            largest = std::max(largest, piece.largestError[r]);
            cases += piece.cases[r];
            nodes += piece.bins[r].nodes.size();
            bins += piece.bins[r].bins.size();
        }
        if (cases == 0)
            continue;
        text << std::fixed << std::setprecision(4) << (r ? "; " : " ")
             << std::sqrt(squares / static_cast<double>(cases)) << " / " << std::setprecision(3)
             << largest << std::setprecision(1) << " ("
             << static_cast<double>(nodes) / static_cast<double>(bins) << ")";
    }
    return text.str();
}

/// RMS and largest error of training over ranges that users know; that of `before`, the header of
/// the table that is there, for ranges of which not all pieces were trained or measured.
std::string errorTable(const std::vector<Piece>& work, const std::vector<TrainedNodes>& trained,
                       const std::string& before) {
    struct Range {
        double lower_per_cm, upper_per_cm;
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
        std::ostringstream name;
        name << range.lower_per_cm << "-" << range.upper_per_cm << " cm-1:";
        // Pieces ascend.
        const auto isBelow = [&](const Piece& piece) {
            return piece.lower_per_cm < range.lower_per_cm;
        };
        const auto isWithin = [&](const Piece& piece) {
            return piece.upper_per_cm <= range.upper_per_cm;
        };
        const auto first = std::ranges::partition_point(work, isBelow) - work.begin();
        const auto last = std::ranges::partition_point(work, isWithin) - work.begin();
        const std::span inside(trained.begin() + first, trained.begin() + last);
        if (std::ranges::any_of(inside,
                                [](const TrainedNodes& piece) { return piece.cases[0] == 0; })) {
            text << lineOf(before, name.str());
            continue;
        }
        text << name.str() << errorsOf(inside);
        text << "\n";
    }
    return text.str();
}

} // namespace

void makeGases(const Folders& folders) {
    const PartitionSums partition = PartitionSums::read(folders.data / "lines" / "partition");
    const std::vector<LineList> gases = completeLineLists(folders.data);
    const CrossSectionGrid grid = crossSectionGrid();

    const TrainingPaths training = trainingPaths(modelAtmospheres());
    const std::array<NodeGoals, 3> goals = nodeGoals();

    const std::vector<Piece> work = pieces();
    const std::shared_ptr<const GasTable> table =
        folders.renew_per_cm.empty() && folders.measure_per_cm.empty()
            ? nullptr
            : GasTable::read(folders.out / "gases.gastable");
    const auto isIn = [](const Piece& piece, const auto& ranges_per_cm) {
        return std::ranges::any_of(ranges_per_cm, [&](const auto& range) {
            return range.first < piece.upper_per_cm && range.second > piece.lower_per_cm;
        });
    };
    std::vector<TrainedNodes> trained(work.size());
    std::atomic<std::size_t> next = 0;
    std::mutex output;
    auto run = [&] {
        for (std::size_t i = next++; i < work.size(); i = next++) {
            const Piece& piece = work[i];
            const bool isKept = table && !isIn(piece, folders.renew_per_cm);
            if (isKept) {
                trained[i] = keptPiece(*table, piece);
                if (!isIn(piece, folders.measure_per_cm))
                    continue;
            }
            const FineCrossSections fine = fineCrossSections(gases, partition, grid, piece);
            if (isKept)
                measureNodes(trained[i], fine, grid, training);
            else
                trained[i] = trainNodes(fine, grid, training, piece.lower_per_cm,
                                        piece.upper_per_cm, piece.width_per_cm, goals);
            const std::lock_guard lock(output);
            std::cout << piece.lower_per_cm << "-" << piece.upper_per_cm
                      << " cm-1: " << trained[i].wavenumbers_per_cm.size() << " nodes,"
                      << errorsOf({&trained[i], 1}) << std::endl;
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
            header << origin << "\n";
    header << errorTable(work, trained, table ? table->header() : "");

    Assembly assembly;
    for (TrainedNodes& piece : trained)
        assembly.add(std::move(piece));
    assembly.addSmooth(work.back().upper_per_cm, 50010.0);
    const GasTable result(grid, std::move(assembly.wavenumbers_per_cm), std::move(assembly.blocks),
                          std::move(assembly.bins), header.str());
    std::cout << result.header() << result.nodeCount() << " nodes" << std::endl;
    result.write(folders.out / "gases.gastable");
}

} // namespace smat::tables
