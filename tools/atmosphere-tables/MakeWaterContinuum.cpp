#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "tools/atmosphere-tables/ContinuumTables.h"
#include "tools/atmosphere-tables/DataTable.h"
#include "tools/atmosphere-tables/NodeCurve.h"
#include "tools/atmosphere-tables/lines/PublishedRun.h"

namespace smat::tables {

namespace {

using irsg::lbl::PublishedRun;
using irsg::lbl::publishedRunSource;

/// LOWTRAN's continuum, 1e-20 cm3 per molecule. Its self part has the dip at 1050 cm-1 that
/// LOWTRAN itself gives it. Its foreign part carries a far wing on top of the tabulated values;
/// that wing makes it too strong wherever it has been tested beyond 10 um, and fades out here
/// between 1100 and 1300 cm-1.
class LowtranContinuum {
  public:
    explicit LowtranContinuum(const Folders& folders)
        : table_(readTable(folders.data / "lowtran" / "continuum_h2o.csv")) {}

    double self296(double nu) const { return dip(nu) * table_.at("self_296K_1e-20cm3", nu); }
    double self260(double nu) const { return dip(nu) * table_.at("self_260K_1e-20cm3", nu); }
    double foreign(double nu) const {
        const double near = 1.025 * 3.159e-8 * std::exp(-2.75e-4 * nu);
        const double far = 8.97e-6 * std::exp(-1.3e-3 * nu);
        const double fade = std::clamp((1300.0 - nu) / 200.0, 0.0, 1.0);
        return table_.at("foreign_296K_1e-20cm3", nu) + fade / (1.0 / near + 1.0 / far);
    }

  private:
    static double dip(double nu) {
        constexpr double square = 200.0 * 200.0;
        return 1.0 - 0.2333 * square / ((nu - 1050.0) * (nu - 1050.0) + square);
    }
    Table table_;
};

/// Optical depths of LOWTRAN's self and foreign continuum over the path of the published run.
struct Depths {
    double self = 0.0, foreign = 0.0;
};

class PublishedPath {
  public:
    PublishedPath(const LowtranContinuum& continuum, const irsg::AtmosphericState& air)
        : continuum_(continuum), temperature_K_(air.temperature_K) {
        const double reference_per_cm3 = 101325.0 / (1.380649e-23 * 296.0) * 1e-6;
        const double all = air.airDensity_per_m3() * 1e-6;
        const double water = air.density_per_m3(irsg::Gas::H2O) * 1e-6;
        const double scale = 1e-20 * water * PublishedRun::length_cm / reference_per_cm3;
        perSelf_ = scale * water;
        perForeign_ = scale * (all - water);
    }
    Depths at(double nu) const {
        const double radiation = nu * std::tanh(1.438776877 * nu / (2.0 * temperature_K_));
        const double warm = continuum_.self296(nu), cool = continuum_.self260(nu);
        const double self = irsg::lerpByRatio(warm, cool, (296.0 - temperature_K_) / 36.0);
        return {self * perSelf_ * radiation, continuum_.foreign(nu) * perForeign_ * radiation};
    }

  private:
    const LowtranContinuum& continuum_;
    double temperature_K_, perSelf_ = 0.0, perForeign_ = 0.0;
};

/// Solves a symmetric positive definite system in place (Cholesky); `matrix` row by row.
void solve(std::vector<double>& matrix, std::vector<double>& right) {
    const std::size_t n = right.size();
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i) {
            double sum = matrix[i * n + j];
            for (std::size_t k = 0; k < j; ++k)
                sum -= matrix[i * n + k] * matrix[j * n + k];
            if (i == j && sum <= 0.0)
                throw irsg::LogicError("the fit of the continuum has no single solution");
            matrix[i * n + j] = i == j ? std::sqrt(sum) : sum / matrix[j * n + j];
        }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k)
            right[i] -= matrix[i * n + k] * right[k];
        right[i] /= matrix[i * n + i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k)
            right[i] -= matrix[k * n + i] * right[k];
        right[i] /= matrix[i * n + i];
    }
}

/// Logarithms of the factors on the two parts. Where both could explain the published depth, the
/// factors nearest to 1 are taken.
class Correction {
  public:
    double selfFactor(double nu) const { return std::exp(self_.at(nu)); }
    double foreignFactor(double nu) const { return std::exp(foreign_.at(nu)); }

    /// Gauss-Newton on the logarithm of the depth; returns the largest step of an iteration.
    double improve(const PublishedRun& run, const PublishedPath& path) {
        const std::size_t n = self_.size() + foreign_.size();
        std::vector<double> matrix(n * n, 0.0), right(n, 0.0);
        for (std::size_t i = 0; i < run.wavenumber_per_cm.size(); ++i)
            addPoint(run.wavenumber_per_cm[i], run.waterContinuum[i], path, matrix, right);
        for (std::size_t i = 0; i < n; ++i) {
            const double stiffness = isFixed(i) ? 1e12 : 1.0 / (priorSpread * priorSpread);
            matrix[i * n + i] += stiffness;
            right[i] -= stiffness * parameter(i);
        }
        solve(matrix, right);
        double largest = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            parameter(i) += std::clamp(right[i], -0.5, 0.5);
            largest = std::max(largest, std::abs(right[i]));
        }
        return largest;
    }
    std::string described() const {
        std::string text = "# factors on the self part:";
        for (std::size_t i = 0; i < self_.size(); ++i)
            text += nodeText(self_, i);
        text += "\n# factors on the foreign part:";
        for (std::size_t i = 0; i < foreign_.size(); ++i)
            text += nodeText(foreign_, i);
        return text + "\n";
    }

  private:
    static constexpr double priorSpread = 1.0; ///< of the logarithm of a factor
    static constexpr double lowest_per_cm = 660.0, highest_per_cm = 2400.0;

    void addPoint(double nu, double transmittance, const PublishedPath& path,
                  std::vector<double>& matrix, std::vector<double>& right) const {
        if (nu < lowest_per_cm || nu > highest_per_cm || transmittance < 0.004 ||
            transmittance > 0.9997)
            return;
        const Depths plain = path.at(nu);
        const double self = plain.self * selfFactor(nu),
                     foreign = plain.foreign * foreignFactor(nu), all = self + foreign;
        const double depth = -std::log(transmittance);
        const double spread = 0.01 + PublishedRun::rounding / (transmittance * depth);
        const double residual = std::log(depth / all);

        std::vector<NodeCurve::Share> gradient;
        for (const auto& [node, weight] : self_.shares(nu))
            gradient.push_back({node, weight * self / all});
        for (const auto& [node, weight] : foreign_.shares(nu))
            gradient.push_back({self_.size() + node, weight * foreign / all});
        for (const auto& a : gradient) {
            right[a.node] += a.weight * residual / (spread * spread);
            for (const auto& b : gradient)
                matrix[a.node * right.size() + b.node] += a.weight * b.weight / (spread * spread);
        }
    }
    double& parameter(std::size_t i) {
        return i < self_.size() ? self_.value(i) : foreign_.value(i - self_.size());
    }
    /// The factor is 1 at the ends and in the centre of the band at 1595 cm-1, of which the run
    /// sees nothing.
    bool isFixed(std::size_t i) const {
        if (i < self_.size())
            return i + 1 == self_.size();
        const double nu = foreign_.node_per_cm(i - self_.size());
        return nu == 1120.0 || nu == 1500.0 || nu == 1700.0 || nu == 2350.0;
    }
    static std::string nodeText(const NodeCurve& curve, std::size_t i) {
        return " " + irsg::numberText(curve.node_per_cm(i)) + " " +
               irsg::numberText(std::round(1e3 * std::exp(curve.value(i))) / 1e3) +
               (i + 1 < curve.size() ? "," : "");
    }

    NodeCurve self_{{600, 700, 750, 800, 850, 890, 920, 960, 1000, 1040, 1080, 1120, 1160, 1200,
                     1240, 1280, 1330, 1500}};
    NodeCurve foreign_{
        {1120, 1200, 1250, 1300, 1350, 1500, 1700, 1920, 2000, 2050, 2100, 2200, 2350}};
};

constexpr const char* recipe =
    "# Water vapour continuum, for lines cut at 25 cm-1 with their pedestal removed\n"
    "# recipe: atmosphere-tables continuum; the continuum of LOWTRAN 7 (self at 296 and 260 K with "
    "its dip at 1050 cm-1, foreign with its added far wing faded out between 1100 and 1300 cm-1) "
    "times factors whose logarithm is linear between a few wavenumbers and 1 beyond them, fitted "
    "by least squares to the H2O CONT column of a published MODTRAN run (tropical, 5 km "
    "horizontal at the ground, 660 to 2400 cm-1 where its transmittance lies between 0.004 and "
    "0.9997)\n";

constexpr const char* validity =
    "# units: cm-1; 1e-20 cm3 molecule-1; absorption (cm-1) = value 1e-20 n_H2O v tanh(c2 v / 2T) "
    "n_partner / n(296 K, 1013.25 hPa), self: ln linear in T through 296 and 260 K\n"
    "# expected error: what the fit leaves of that run (660 to 2400 cm-1) is 0.001 rms and 0.003 "
    "largest in transmittance; from 2400 to 11000 cm-1, where no factor is fitted but the far wing "
    "is left out, 0.001 and 0.005. One path cannot part self from foreign: factors nearest to 1 "
    "are taken. That run holds a continuum of the 1990s. Against a modern one, in transmittance "
    "over 5 km of tropical air (10 km of winter air), rms: 800 to 1250 cm-1 0.066 (0.030), 2000 to "
    "2400 0.035 (0.015), 2400 to 2900 0.030 (0.002), 2900 to 4200 0.096 (0.096), 4200 to 5000 "
    "0.081 (0.025), 5000 to 10000 0.078 (0.077); the self part is 25 % stronger at 1000 cm-1, 1.7 "
    "to 2.7 times weaker from 2500 to 2900 and up to 4.6 times weaker from 4000 to 5000 cm-1\n";

} // namespace

void makeWaterContinuum(const Folders& folders) {
    const LowtranContinuum plain(folders);
    const PublishedRun run = PublishedRun::read(folders.data);
    const PublishedPath path(plain, PublishedRun::air());

    Correction correction;
    double step = 1.0;
    for (int i = 0; i < 200 && step > 1e-4; ++i)
        step = correction.improve(run, path);
    if (!(step <= 1e-4))
        throw irsg::LogicError("the fit of the continuum does not settle");

    std::array<std::vector<double>, 4> columns;
    for (double nu = 200.0; nu <= 20000.0; nu += 10.0) {
        columns[0].push_back(nu);
        columns[1].push_back(correction.selfFactor(nu) * plain.self296(nu));
        columns[2].push_back(correction.selfFactor(nu) * plain.self260(nu));
        columns[3].push_back(correction.foreignFactor(nu) * plain.foreign(nu));
    }
    Writer writer(lowtran + std::string(publishedRunSource));
    writer.add("wavenumber [cm-1]", columns[0]);
    writer.add("self296 [1e-20 cm3]", columns[1]);
    writer.add("self260 [1e-20 cm3]", columns[2]);
    writer.add("foreign296 [1e-20 cm3]", columns[3]);
    std::cout << correction.described();
    writer.write(folders.out / "continuum-water.csv",
                 recipe + correction.described() + std::string(validity), 0.0, 1e9);
}

} // namespace smat::tables
