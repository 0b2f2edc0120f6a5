#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/PlumeBand.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Gas about an axis, as computations of flows give it: its state over the distance x along the
/// axis, downstream, and the distance r from it.
class PlumeTable {
  public:
    /// Columns by name: `x [m]`, `r [m]`, `T [K]`, and any of `p [atm]` (1 where it is missing),
    /// `CO2`, `H2O`, `CO`, `CH4`, `O2` (mole fractions) and `soot [ppmv]`. Each x has the same r,
    /// in any order of rows; 2 at least of both, r from 0. Throws InputError with every diagnostic
    /// by file, line and column.
    static PlumeTable read(const std::filesystem::path& file);
    static PlumeTable of(const CsvTable& csv);
    /// Nodes by x, then r; both ascending, r from 0. LogicError for another number of nodes.
    static PlumeTable ofNodes(std::vector<double> x_m, std::vector<double> r_m,
                              std::vector<GasLayer> nodes);

    const std::vector<double>& x_m() const { return x_m_; }
    const std::vector<double>& r_m() const { return r_m_; }
    /// Bilinear between nodes, held beyond the ends.
    GasLayer at(double x_m, double r_m) const;
    const GasLayer& node(std::size_t x, std::size_t r) const { return nodes_[x * r_m_.size() + r]; }

  private:
    std::vector<double> x_m_, r_m_;
    std::vector<GasLayer> nodes_; ///< by x, then r; of no length
};

/// Uniform gas in a surface of revolution, which lies in those before it and holds those behind.
struct PlumeZone {
    GasLayer gas;
    double from_K = 0.0; ///< it is the gas of at least that temperature
    /// Closed pieces by (x, r), x ascending, that begin and end on the axis or at the ends of the
    /// table.
    std::vector<std::vector<std::array<double, 2>>> outlines_m;
};

/// So many zones between temperatures that part emission and absorption evenly; gas that has less
/// than 1e-3 of them, colder than all, is left out. The gas of a zone is the mean of its nodes,
/// weighted with what they emit. InputError where nothing emits, or the temperature rises away from
/// the axis.
std::vector<PlumeZone> plumeZones(const PlumeTable& table, std::size_t count);

/// What zones send compared with the table itself.
struct PlumeZonesError {
    std::string view; ///< "side", "quarter", "tail"
    double table_W_sr = 0.0, zones_W_sr = 0.0;
    double relative() const { return zones_W_sr / table_W_sr - 1.0; }
};

/// Radiant intensity of a plume in a band, along parallel lines of sight at 90, 45 and 10 degrees
/// to its axis from behind. What more steps would change is not bounded here; `fineness` tells it.
class PlumeIntensities {
  public:
    /// `fineness` times as many steps each way.
    PlumeIntensities(const PlumeTable& table, const SpectralRange& band, int fineness = 1);
    std::vector<PlumeZonesError> errorsOf(const std::vector<PlumeZone>& zones) const;

  private:
    /// A line of sight: where it is, (x, r), by the distance along it towards the sensor.
    struct Line {
        double first_m = 0.0;            ///< x of the nozzle
        double u_m = 0.0, v_m = 0.0;     ///< beside the middle of the nozzle
        double cosine = 0.0, sine = 0.0; ///< of its angle to the axis
        std::array<double, 2> at(double s_m) const;
    };
    struct Sight {
        Line line;
        std::vector<double> edges_m; ///< of its steps, from the sensor on: distances descend
        double area_m2 = 0.0;
    };
    struct View {
        std::string name;
        std::vector<Sight> sights; ///< of zones
        double intensity_W_sr = 0.0;
    };
    static std::vector<Sight> sightsOf(const PlumeTable& table, double angle_deg, int along,
                                       int across, int deep);
    static void takeSteps(Sight& sight, double length_m, double radius_m, int steps);

    PlumeBand band_;
    std::vector<View> views_;
};

} // namespace irsg
