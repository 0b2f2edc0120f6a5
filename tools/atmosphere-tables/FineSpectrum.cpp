#include "tools/atmosphere-tables/FineSpectrum.h"

#include <algorithm>
#include <cmath>

namespace smat::tables {

using namespace irsg;
using namespace irsg::lbl;

namespace {

/// Lines that reach into a piece of the spectrum.
LineList linesNear(const LineList& list, const Piece& piece, double reach_per_cm) {
    const auto first = std::ranges::lower_bound(list.lines, piece.lower_per_cm - reach_per_cm, {},
                                                &Line::wavenumber_per_cm);
    const auto last = std::ranges::upper_bound(list.lines, piece.upper_per_cm + reach_per_cm, {},
                                               &Line::wavenumber_per_cm);
    return {list.gas, {first, last}, {}};
}

} // namespace

CrossSectionGrid crossSectionGrid() {
    CrossSectionGrid grid;
    grid.pressures_hPa = {1100, 720, 470, 300, 190, 120, 70, 36, 15, 5, 1.2, 0.15};
    grid.temperatures_K = {180, 210, 245, 285, 330};
    grid.moistFraction = 0.04;
    grid.moistPressures = 5;
    return grid;
}

std::array<NodeGoals, 3> nodeGoals() {
    return {{{0.0025, 0.03, 6}, {0.0015, 0.015, 12}, {0.0015, 0.015, 16}}};
}

std::vector<Profile> modelAtmospheres() {
    std::vector<Profile> atmospheres;
    for (int model = 1; model <= 6; ++model)
        atmospheres.push_back(Profile::model(static_cast<ModelAtmosphere>(model)));
    return atmospheres;
}

FineCrossSections fineCrossSections(const std::vector<LineList>& gases,
                                    const PartitionSums& partition, const CrossSectionGrid& grid,
                                    const Piece& piece) {
    FineCrossSections fine;
    fine.grid.step_per_cm = piece.step_per_cm;
    fine.grid.first_per_cm = piece.lower_per_cm + 0.5 * piece.step_per_cm;
    fine.grid.count = static_cast<std::size_t>(
        std::lround((piece.upper_per_cm - piece.lower_per_cm) / piece.step_per_cm));

    static constexpr double nothing_cm2 = 1e-33;
    for (const LineList& gas : gases) {
        const LineShape shape = defaultLineShape(gas.gas);
        const LineList near = linesNear(gas, piece, shape.cut_per_cm + 1.0);
        if (near.lines.empty())
            continue;
        auto& points = fine.lnCrossSection[static_cast<std::size_t>(gas.gas)];
        auto add = [&](double pressure_hPa, double temperature_K, double fraction) {
            const std::vector<double> k =
                crossSection_cm2(near, partition, fine.grid, temperature_K, pressure_hPa, fraction,
                                 shape, negligible_cm2(gas.gas));
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

} // namespace smat::tables
