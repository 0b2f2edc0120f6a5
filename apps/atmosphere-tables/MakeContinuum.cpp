#include "apps/atmosphere-tables/Command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "apps/atmosphere-tables/DataTable.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/lbl/LineListFile.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"

namespace smat::tables {

namespace {

/// The published transmittance of the water continuum over 5 km of tropical air at the ground, by
/// wavenumber: column "H2O CONT" of a MODTRAN run.
std::map<double, double> publishedContinuum(const std::filesystem::path& file) {
    constexpr std::size_t headerLines = 13, column = 7;
    std::map<double, double> transmittance;
    std::size_t number = 0;
    for (const std::string& line : irsg::lbl::readTextLines(file)) {
        if (++number <= headerLines)
            continue;
        std::istringstream words(line);
        std::vector<double> values;
        for (std::string word; words >> word && values.size() <= column;)
            values.push_back(irsg::parseNumber(word).value_or(-1.0));
        if (values.size() <= column)
            continue; // the mark of the end
        if (values[0] <= 0.0 || values[column] < 0.0 || values[column] > 1.0)
            throw irsg::InputError(irsg::Offence{file.string(), "line " + std::to_string(number),
                                                 line.substr(0, 60),
                                                 "wavenumber and transmittances"});
        transmittance[values[0]] = values[column];
    }
    return transmittance;
}

/// Optical depths of the self and the foreign continuum of LOWTRAN 7 over that path.
class PublishedPath {
  public:
    explicit PublishedPath(const irsg::AirState& air) : temperature_K_(air.temperature_K) {
        const double reference_per_cm3 = 101325.0 / (1.380649e-23 * 296.0) * 1e-6;
        const double all = air.airDensity_per_m3() * 1e-6;
        const double water = air.density_per_m3(irsg::Gas::H2O) * 1e-6;
        const double column_cm2 = water * length_cm;
        perSelf_ = 1e-20 * column_cm2 * water / reference_per_cm3;
        perForeign_ = 1e-20 * column_cm2 * (all - water) / reference_per_cm3;
    }
    double self(double nu, double at296, double at260) const {
        return at296 <= 0.0 ? 0.0
                            : at296 * std::pow(at260 / at296, (296.0 - temperature_K_) / 36.0) *
                                  perSelf_ * radiation(nu);
    }
    double foreign(double nu, double at296) const { return at296 * perForeign_ * radiation(nu); }

  private:
    static constexpr double length_cm = 5e5;
    double radiation(double nu) const {
        return nu * std::tanh(1.438776877 * nu / (2.0 * temperature_K_));
    }
    double temperature_K_, perSelf_ = 0.0, perForeign_ = 0.0;
};

/// A factor known at some wavenumbers, its logarithm linear between them and held outside.
class LogarithmicCurve {
  public:
    void set(double nu, double factor) { ln_[nu] = std::log(factor); }
    double at(double nu) const {
        const auto above = ln_.lower_bound(nu);
        if (above == ln_.begin())
            return std::exp(above->second);
        const auto below = std::prev(above);
        if (above == ln_.end())
            return std::exp(below->second);
        const double part = (nu - below->first) / (above->first - below->first);
        return std::exp(below->second + part * (above->second - below->second));
    }

  private:
    std::map<double, double> ln_;
};

/// LOWTRAN's continuum is right in the centres of the bands and of the self part in the windows.
/// Its foreign wings are far too strong, and its self part a little too weak at 10 um. Below 1180
/// cm-1 the self part, above it the foreign part takes up the difference to the published run
/// wherever that run is neither opaque nor clear; the factor is 1 in the centres of the bands.
void makeWater(const Folders& folders) {
    const Table lowtranTable = readTable(folders.data / "lowtran" / "continuum_h2o.csv");
    const auto published =
        publishedContinuum(folders.data / "modtran" / "pyradi" / "horizon5kmtropical.fl7");
    const irsg::AirState air = irsg::Profile::model(irsg::ModelAtmosphere::tropical).at(0.0);
    const PublishedPath path(air);

    auto self296 = [&](double nu) {
        constexpr double width = 200.0;
        const double dip =
            1.0 - 0.2333 * width * width / ((nu - 1050.0) * (nu - 1050.0) + width * width);
        return dip * lowtranTable.at("self_296K_1e-20cm3", nu);
    };
    auto self260 = [&](double nu) {
        const double plain = lowtranTable.at("self_296K_1e-20cm3", nu);
        return plain > 0.0 ? self296(nu) * lowtranTable.at("self_260K_1e-20cm3", nu) / plain : 0.0;
    };
    auto foreign = [&](double nu) {
        const double near = 1.025 * 3.159e-8 * std::exp(-2.75e-4 * nu);
        const double far = 8.97e-6 * std::exp(-1.3e-3 * nu);
        return lowtranTable.at("foreign_296K_1e-20cm3", nu) + 1.0 / (1.0 / near + 1.0 / far);
    };
    auto publishedDepth = [&](double nu) {
        double sum = 0.0;
        int count = 0;
        for (auto at = published.lower_bound(nu - 10.0);
             at != published.end() && at->first <= nu + 10.0; ++at, ++count)
            sum += at->second;
        const double transmittance = count ? sum / count : 1.0;
        return transmittance > 0.005 && transmittance < 0.9995 ? -std::log(transmittance) : -1.0;
    };

    LogarithmicCurve selfFactor, foreignFactor;
    selfFactor.set(600.0, 1.0);
    foreignFactor.set(1180.0, 1.0);
    for (const double centre_cm : {1450.0, 1750.0, 3560.0, 3900.0, 5200.0, 5450.0, 7100.0, 7350.0,
                                   8740.0, 8900.0, 10500.0, 10700.0})
        foreignFactor.set(centre_cm, 1.0);
    for (double nu = 670.0; nu < 10400.0; nu += 10.0) {
        const double depth = publishedDepth(nu);
        if (depth < 0.0)
            continue;
        const double own = path.self(nu, self296(nu), self260(nu));
        const double other = path.foreign(nu, foreign(nu));
        if (nu <= 1180.0)
            selfFactor.set(nu, std::clamp((depth - other) / own, 0.5, 1.5));
        else if (nu < 1400.0) // the self part comes back to its own over the flank of the band
            foreignFactor.set(
                nu,
                std::clamp((depth - own * (0.8 + 0.2 * (nu - 1180.0) / 220.0)) / other, 0.05, 1.5));
        else
            foreignFactor.set(nu, std::clamp((depth - own) / other, 0.003, 1.5));
    }
    selfFactor.set(1400.0, 1.0);

    std::array<std::vector<double>, 4> columns;
    for (double nu = 200.0; nu <= 20000.0; nu += 10.0) {
        const double factor = selfFactor.at(nu);
        columns[0].push_back(nu);
        columns[1].push_back(factor * self296(nu));
        columns[2].push_back(factor * self260(nu));
        columns[3].push_back(foreignFactor.at(nu) * foreign(nu));
    }
    Writer writer;
    writer.add("wavenumber [cm-1]", columns[0]);
    writer.add("self296 [1e-20 cm3]", columns[1]);
    writer.add("self260 [1e-20 cm3]", columns[2]);
    writer.add("foreign296 [1e-20 cm3]", columns[3]);
    writer.write(
        folders.out / "continuum-water.csv",
        "# Water vapour continuum, for lines cut at 25 cm-1 with their pedestal removed\n"
        "# recipe: atmosphere-tables continuum; the continuum of LOWTRAN 7 (self at 296 and 260 K, "
        "foreign), corrected by factors of wavenumber: below 1180 cm-1 on the self part, above on "
        "the "
        "foreign part, so that the sum gives the published transmittance of a MODTRAN run "
        "(tropical, 5 "
        "km horizontal at the ground) where that lies between 0.005 and 0.9995; logarithmic "
        "between, 1 "
        "in the centres of the bands\n"
        "# units: cm-1; k = value 1e-20 n_H2O v tanh(c2 v / 2T) n_partner / n(296 K, 1013.25 hPa)\n"
        "# source: the MODTRAN run of pyradi (C. J. Willers, MIT licence), "
        "data/horizon5kmtropical.fl7\n"
        "# expected error: 10 % in windows at 290 to 300 K, 20 % at 250 K, 40 % of the foreign "
        "part in "
        "the centres of bands\n",
        0.0, 1e9);
}

/// Nitrogen's collision-induced absorption at three temperatures, by interpolation of its logarithm
/// between those of the source.
void makeNitrogen(const Folders& folders) {
    std::map<double, std::pair<std::vector<double>, std::vector<double>>> sets; // by temperature
    std::map<double, std::pair<std::vector<double>, std::vector<double>>> rotation;
    std::size_t number = 0;
    const auto file = folders.data / "continuum" / "n2_n2_cia_hitran2011.csv.gz";
    for (const std::string& line : irsg::lbl::readTextLines(file)) {
        ++number;
        if (line.empty() || line[0] == '#' || line[0] == 't')
            continue;
        std::istringstream cells(line);
        std::array<double, 3> values{};
        for (double& value : values) {
            std::string cell;
            std::getline(cells, cell, ',');
            const auto found = irsg::parseNumber(irsg::trimmed(cell));
            if (!found)
                throw irsg::InputError(irsg::Offence{file.string(),
                                                     "line " + std::to_string(number), line,
                                                     "temperature, wavenumber, coefficient"});
            value = *found;
        }
        auto& set = (values[1] < 1000.0 ? rotation : sets)[values[0]];
        set.first.push_back(values[1]);
        set.second.push_back(values[2]);
    }
    auto at = [](const std::pair<std::vector<double>, std::vector<double>>& set, double nu) {
        const auto& [axis, values] = set;
        if (nu < axis.front() || nu > axis.back())
            return 0.0;
        const auto upper =
            std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(axis, nu) - axis.begin(), 1,
                                       static_cast<std::ptrdiff_t>(axis.size()) - 1);
        const auto i = static_cast<std::size_t>(upper);
        const double part = (nu - axis[i - 1]) / (axis[i] - axis[i - 1]);
        return std::max(0.0, (1.0 - part) * values[i - 1] + part * values[i]);
    };
    auto write = [&](const char* name, const auto& from, double colder_K, double warmer_K,
                     double hot_K, double lower, double upper, double step) {
        Writer writer(
            "# source: HITRAN collision-induced absorption N2-N2 (C. Richard et al. 2012, J. "
            "Quant. "
            "Spectrosc. Radiat. Transfer 113, 1276; I. E. Gordon et al. 2022, 277, 107949)\n");
        std::array<std::vector<double>, 4> columns;
        constexpr double amagat2 = 2.6867774e19 * 2.6867774e19;
        for (double nu = lower; nu <= upper; nu += step) {
            columns[0].push_back(nu);
            std::size_t c = 1;
            for (const double temperature_K : {220.0, 260.0, 300.0}) {
                const double low_K = temperature_K < warmer_K ? colder_K : warmer_K;
                const double high_K = temperature_K < warmer_K ? warmer_K : hot_K;
                const double a = at(from.at(low_K), nu), b = at(from.at(high_K), nu);
                const double part = (temperature_K - low_K) / (high_K - low_K);
                const double k = a > 0.0 && b > 0.0 ? a * std::pow(b / a, part)
                                                    : std::max(0.0, a + part * (b - a));
                columns[c++].push_back(k * amagat2);
            }
        }
        const std::array<const char*, 4> names = {"wavenumber [cm-1]", "k220 [cm-1 amagat-2]",
                                                  "k260 [cm-1 amagat-2]", "k300 [cm-1 amagat-2]"};
        for (std::size_t c = 0; c < columns.size(); ++c)
            writer.add(names[c], columns[c]);
        writer.write(
            folders.out / name,
            "# Collision-induced absorption of nitrogen by nitrogen at 220, 260 and 300 K\n"
            "# recipe: atmosphere-tables continuum; logarithms interpolated between " +
                irsg::numberText(colder_K) + ", " + irsg::numberText(warmer_K) + " and " +
                irsg::numberText(hot_K) +
                " K\n# units: cm-1; cm-1 amagat-2\n# expected error: 3 % of the fundamental, 5 "
                "% of the rotational band; the first overtone (4300 to 5000 cm-1) is not held\n",
            0.0, 1e9);
    };
    write("continuum-nitrogen-rotation.csv", rotation, 185.7, 239.8, 309.7, 200.0, 550.0, 5.0);
    write("continuum-nitrogen-fundamental.csv", sets, 228.2, 253.2, 300.9, 2000.0, 2695.0, 2.5);
}

void makeOthers(const Folders& folders) {
    const auto source = folders.data / "lowtran";
    const Table oxygen = readTable(source / "continuum_o2_fundamental.csv");
    Writer o2;
    o2.add("wavenumber [cm-1]", oxygen.column("wavenumber_cm-1"));
    o2.add("S0 [atm-1 cm-1 atm-1]", oxygen.column("S0"));
    o2.add("A [K-1]", oxygen.column("A_K-1"));
    o2.add("B [K-2]", oxygen.column("B_K-2"));
    o2.write(
        folders.out / "continuum-oxygen.csv",
        "# Collision-induced fundamental of oxygen\n# recipe: the numbers of the source\n"
        "# units: depth = S0 / 0.20946 (1 + A t + (A^2/2 + B) t^2) w, t = T - 220 K, w = O2 amount "
        "(atm-cm) times p / 1013.25 hPa\n# expected error: 10 %; the bands at 1.27 and 1.06 um are "
        "not held\n",
        0.0, 1e9);

    const Table visible = readTable(source / "ozone_visible_uv.csv");
    Writer chappuis;
    chappuis.add("wavenumber [cm-1]", visible.column("wavenumber_cm-1"));
    chappuis.add("k [atm-1 cm-1]", visible.column("C8_atm-1_cm-1"));
    chappuis.write(
        folders.out / "continuum-ozone-visible.csv",
        "# Chappuis bands of ozone\n# recipe: the numbers of the source, 13000 to 24000 cm-1\n"
        "# units: depth = k times amount (atm-cm)\n# expected error: 5 %\n",
        12999.0, 24001.0);
    const Table warm = readTable(source / "ozone_hartley_huggins.csv");
    Writer huggins;
    huggins.add("wavenumber [cm-1]", warm.column("wavenumber_cm-1"));
    huggins.add("c0 [1e-20 cm2]", warm.column("c0_1e-20cm2"));
    huggins.add("c1 [K-1]", warm.column("c1_K-1"));
    huggins.add("c2 [K-2]", warm.column("c2_K-2"));
    huggins.write(
        folders.out / "continuum-ozone-huggins.csv",
        "# Hartley and Huggins bands of ozone\n# recipe: the numbers of the source\n"
        "# units: cross section c0 (1 + c1 t + c2 t^2), t = T - 273.15 K\n# expected error: 3 %\n",
        0.0, 1e9);
    const Table far = readTable(source / "ozone_uv.csv");
    Writer ultraviolet;
    ultraviolet.add("wavenumber [cm-1]", far.column("wavenumber_cm-1"));
    ultraviolet.add("sigma [1e-20 cm2]", far.column("sigma_1e-20cm2"));
    ultraviolet.write(folders.out / "continuum-ozone-ultraviolet.csv",
                      "# Ozone in the far ultraviolet\n# recipe: the numbers of the source\n"
                      "# units: cross section\n# expected error: 3 %\n",
                      0.0, 1e9);

    const Table acid = readTable(source / "hno3.csv");
    std::array<std::vector<double>, 2> columns;
    for (double nu = 845.0; nu <= 1740.0; nu += 5.0) {
        const auto& axis = acid.column("wavenumber_cm-1");
        const auto found = std::ranges::find(axis, nu);
        columns[0].push_back(nu);
        columns[1].push_back(found == axis.end()
                                 ? 0.0
                                 : acid.columns[1][static_cast<std::size_t>(found - axis.begin())]);
    }
    Writer hno3;
    hno3.add("wavenumber [cm-1]", columns[0]);
    hno3.add("k [atm-1 cm-1]", columns[1]);
    hno3.write(
        folders.out / "continuum-nitric-acid.csv",
        "# Three bands of nitric acid\n# recipe: the numbers of the source, 0 between the bands\n"
        "# units: depth = k times amount (atm-cm)\n# expected error: 20 %\n",
        0.0, 1e9);
}

} // namespace

void makeContinuum(const Folders& folders) {
    makeWater(folders);
    makeNitrogen(folders);
    makeOthers(folders);
}

} // namespace smat::tables
