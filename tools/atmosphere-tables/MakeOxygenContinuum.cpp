#include <algorithm>
#include <array>
#include <cmath>

#include "tools/atmosphere-tables/ContinuumTables.h"
#include "tools/atmosphere-tables/DataTable.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/PublishedRun.h"

namespace smat::tables {

namespace {

using irsg::lbl::PublishedRun;
using irsg::lbl::publishedRunSource;

constexpr double loschmidt_per_cm3 = 2.686780111e19;

/// The transmittance of oxygen's lines over the path of the published run, seen through its slit.
class LinePath {
  public:
    LinePath(const Folders& folders, const irsg::AtmosphericState& air, double lower_per_cm,
             double upper_per_cm) {
        const auto lines =
            irsg::lbl::readLineList(irsg::Gas::O2, folders.data / "lines" / "O2.par.gz");
        const auto partition = irsg::lbl::PartitionSums::read(folders.data / "lines" / "partition");
        grid_ = {lower_per_cm - 20.0, 0.005,
                 static_cast<std::size_t>((upper_per_cm - lower_per_cm + 40.0) / 0.005) + 1};
        const double fraction = air.fraction(irsg::Gas::O2);
        transmittance_ = irsg::lbl::crossSection_cm2(lines, partition, grid_, air.temperature_K,
                                                     air.pressure_hPa, fraction,
                                                     irsg::lbl::defaultLineShape(irsg::Gas::O2));
        const double column_per_cm2 =
            air.density_per_m3(irsg::Gas::O2) * 1e-6 * PublishedRun::length_cm;
        for (double& value : transmittance_)
            value = std::exp(-value * column_per_cm2);
    }
    double at(double nu) const {
        constexpr double slit_per_cm = 10.0;
        double sum = 0.0, weights = 0.0;
        const auto first =
            static_cast<std::size_t>((nu - slit_per_cm - grid_.first_per_cm) / grid_.step_per_cm);
        for (std::size_t i = first; i < grid_.count && grid_.at(i) < nu + slit_per_cm; ++i) {
            const double weight = std::max(0.0, 1.0 - std::abs(grid_.at(i) - nu) / slit_per_cm);
            sum += weight * transmittance_[i];
            weights += weight;
        }
        return sum / weights;
    }

  private:
    irsg::lbl::WavenumberGrid grid_;
    std::vector<double> transmittance_;
};

/// Mean depth of the published run about a wavenumber, less that of the lines where there are any.
class PublishedDepth {
  public:
    PublishedDepth(const PublishedRun& run, const LinePath* lines) : run_(run), lines_(lines) {}
    double mean(double nu, double halfWidth_per_cm) const {
        double sum = 0.0;
        int count = 0;
        const auto first = std::ranges::lower_bound(run_.wavenumber_per_cm, nu - halfWidth_per_cm);
        for (auto i = static_cast<std::size_t>(first - run_.wavenumber_per_cm.begin());
             i < run_.wavenumber_per_cm.size() &&
             run_.wavenumber_per_cm[i] <= nu + halfWidth_per_cm;
             ++i) {
            const double lines = lines_ ? lines_->at(run_.wavenumber_per_cm[i]) : 1.0;
            sum -= std::log(run_.oxygen[i] / lines);
            ++count;
        }
        // One and a half units of the last digit and less are no absorption.
        const double depth = count ? sum / count : 0.0;
        return depth > 3.0 * PublishedRun::rounding ? depth : 0.0;
    }

  private:
    const PublishedRun& run_;
    const LinePath* lines_;
};

void makeFundamental(const Folders& folders) {
    const Table table = readTable(folders.data / "lowtran" / "continuum_o2_fundamental.csv");
    Writer writer;
    writer.add("wavenumber [cm-1]", table.column("wavenumber_cm-1"));
    writer.add("S0 [atm-1 cm-1 atm-1]", table.column("S0"));
    writer.add("A [K-1]", table.column("A_K-1"));
    writer.add("B [K-2]", table.column("B_K-2"));
    writer.write(
        folders.out / "continuum-oxygen.csv",
        "# Collision-induced fundamental of oxygen\n"
        "# recipe: atmosphere-tables continuum; the numbers of the source, in the exponential form "
        "that the source expands to second order and states to be in error by up to 20 % at 300 K\n"
        "# units: depth = S0 / 0.20946 exp(A t + B t^2) w, t = T - 220 K, w = O2 amount (atm-cm) "
        "times p / 1013.25 hPa\n"
        "# expected error: the band's integral is 2 to 5 % above a later fit to laboratory spectra "
        "from 200 to 320 K, 8 % at 350 K, and single wavenumbers differ by 4 % of the peak (rms); "
        "a "
        "MODTRAN run of 299.7 K absorbs less, by 0.022 rms and 0.041 at most in transmittance over "
        "5 km\n",
        0.0, 1e9);
}

void makeNearInfrared(const Folders& folders, const PublishedRun& run) {
    constexpr double lower_per_cm = 7540.0, upper_per_cm = 10000.0;
    const irsg::AtmosphericState air = PublishedRun::air();
    const LinePath lines(folders, air, lower_per_cm, upper_per_cm);
    const PublishedDepth depth(run, &lines);
    const double all = air.airDensity_per_m3() * 1e-6 / loschmidt_per_cm3;
    const double perDepth =
        1.0 / (PublishedRun::length_cm * air.fraction(irsg::Gas::O2) * all * all);

    std::array<std::vector<double>, 2> columns;
    for (double nu = lower_per_cm; nu <= upper_per_cm; nu += 10.0) {
        columns[0].push_back(nu);
        columns[1].push_back(
            nu == lower_per_cm || nu == upper_per_cm ? 0.0 : perDepth * depth.mean(nu, 10.0));
    }
    Writer writer(std::string(publishedRunSource) +
                  "# source of the lines taken off: HITRAN 2012 (L. S. Rothman et al. 2013, J. "
                  "Quant. Spectrosc. Radiat. Transfer 130, 4)\n");
    writer.add("wavenumber [cm-1]", columns[0]);
    writer.add("k [cm-1 amagat-2]", columns[1]);
    writer.write(folders.out / "continuum-oxygen-near-infrared.csv",
                 "# Collision-induced absorption of oxygen at 1.27 and 1.06 um\n"
                 "# recipe: atmosphere-tables continuum; the O2 column of a published MODTRAN run "
                 "less the lines of oxygen line by line, means over 20 cm-1\n"
                 "# units: cm-1; cm-1 per amagat of oxygen and amagat of air\n"
                 "# expected error: 5 % at 1.27 um, 10 % at 1.06 um; the same at all temperatures; "
                 "the integral at 1.27 um in air is to be 1.26e-4 cm-2 amagat-2 (B. Mate et al. "
                 "1999, J. Geophys. Res. 104, 30585)\n",
                 0.0, 1e9);
}

void makeVisible(const Folders& folders, const PublishedRun& run) {
    // Between these the lines of a band lie on the collision band at 630 nm, whose peak is known.
    constexpr double linesFrom_per_cm = 15780.0, linesTo_per_cm = 15990.0, peak_per_cm = 15873.0;
    constexpr double peak = 7.2e-46 * loschmidt_per_cm3 * loschmidt_per_cm3;
    const PublishedDepth depth(run, nullptr);
    const irsg::AtmosphericState air = PublishedRun::air();
    const double oxygen = air.density_per_m3(irsg::Gas::O2) * 1e-6 / loschmidt_per_cm3;
    auto measured = [&](double nu) {
        return depth.mean(nu, 20.0) / (PublishedRun::length_cm * oxygen * oxygen);
    };
    auto value = [&](double nu) {
        if (nu <= linesFrom_per_cm || nu >= linesTo_per_cm)
            return measured(nu);
        const double end_per_cm = nu < peak_per_cm ? linesFrom_per_cm : linesTo_per_cm;
        return peak +
               (measured(end_per_cm) - peak) * (nu - peak_per_cm) / (end_per_cm - peak_per_cm);
    };
    std::array<std::vector<double>, 2> columns;
    for (double nu = 15300.0; nu <= 30000.0; nu += 30.0) {
        columns[0].push_back(nu);
        columns[1].push_back(nu == 15300.0 ? 0.0 : value(nu));
    }
    Writer writer(publishedRunSource);
    writer.add("wavenumber [cm-1]", columns[0]);
    writer.add("k [cm-1 amagat-2]", columns[1]);
    writer.write(folders.out / "continuum-oxygen-visible.csv",
                 "# Absorption of oxygen pairs in the visible\n"
                 "# recipe: atmosphere-tables continuum; the O2 column of a published MODTRAN run, "
                 "means over 40 cm-1; between 15780 and 15990 cm-1 straight lines to the peak of "
                 "7.2e-46 cm5 (G. D. Greenblatt et al. 1990, J. Geophys. Res. 95, 18577)\n"
                 "# units: cm-1; cm-1 per amagat of oxygen squared\n"
                 "# expected error: 10 %; the same at all temperatures\n",
                 0.0, 1e9);
}

} // namespace

void makeOxygenContinuum(const Folders& folders) {
    makeFundamental(folders);
    const PublishedRun run = PublishedRun::read(folders.data);
    makeNearInfrared(folders, run);
    makeVisible(folders, run);
}

} // namespace smat::tables
