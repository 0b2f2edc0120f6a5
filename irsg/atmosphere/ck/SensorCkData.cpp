#include "irsg/atmosphere/ck/SensorCkData.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>

#include "irsg/atmosphere/ck/CkStore.h"
#include "irsg/atmosphere/ck/SparseWeights.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

constexpr double opaque = 1e-3; ///< in-band transmittances below this need not be right relatively

/// Paths between altitudes and over ranges that scenes have.
std::vector<AtmosphericPath> spreadOfPaths(double top_m) {
    struct Ends {
        double sensor_m, target_m;
    };
    std::vector<AtmosphericPath> paths;
    for (const Ends& ends :
         {Ends{5, 5}, Ends{5, 500}, Ends{5, 3000}, Ends{1500, 0}, Ends{1500, 1500},
          Ends{3000, 3000}, Ends{6000, 1000}, Ends{3000, 10000}, Ends{6000, 6000},
          Ends{10000, 10000}, Ends{12000, 0}, Ends{15000, 8000}, Ends{20000, 12000}})
        for (const double range_m : {10.0, 30.0, 150.0, 600.0, 2e3, 3.5e3, 6e3, 9e3, 13e3, 20e3,
                                     30e3, 45e3, 70e3, 150e3}) {
            const double climb_m = std::abs(ends.sensor_m - ends.target_m);
            const bool low = ends.sensor_m < 1000.0 && ends.target_m < 1000.0;
            if (range_m < 1.05 * climb_m || (low && range_m > 30e3) ||
                std::max(ends.sensor_m, ends.target_m) > top_m)
                continue;
            paths.push_back({ends.sensor_m, ends.target_m, range_m});
        }
    return paths;
}

/// Paths between those of the training in range and altitude.
std::vector<AtmosphericPath> pathsHeldOut(double top_m) {
    struct Ends {
        double sensor_m, target_m;
    };
    std::vector<AtmosphericPath> paths;
    for (const Ends& ends : {Ends{20, 20}, Ends{10, 1200}, Ends{2200, 2200}, Ends{5000, 2000},
                             Ends{8000, 7700}, Ends{11000, 300}, Ends{15000, 9000}})
        for (const double range_m : {11.0, 70.0, 800.0, 2.7e3, 7.5e3, 16e3, 36e3, 100e3}) {
            const double climb_m = std::abs(ends.sensor_m - ends.target_m);
            const bool low = ends.sensor_m < 1000.0 && ends.target_m < 1000.0;
            if (range_m >= 1.05 * climb_m && (!low || range_m < 30e3) &&
                std::max(ends.sensor_m, ends.target_m) <= top_m)
                paths.push_back({ends.sensor_m, ends.target_m, range_m});
        }
    return paths;
}

/// The spectral mode over a band: its nodes, and what each weighs in an integral with the response.
/// A spectrum of that mode is linear between the means at the centres of bins, so a bin's share of
/// an integral is that of the hat function over its centre and its neighbours' centres.
class BandNodes {
  public:
    BandNodes(const RadiativeTransfer& transfer, const Band& band)
        : set(transfer.nodesOf(band.range())), band_(band) {
        const BinSet& bins = transfer.gases().bins(transfer.air().resolution_per_cm);
        for (const SpectralBin& own : transfer.binsOf(band.range())) {
            binOf_.insert(binOf_.end(), own.count, centres_um_.size());
            for (std::uint32_t i = own.first; i < own.first + own.count; ++i)
                weight_.push_back(static_cast<double>(bins.weights[i]));
            centres_um_.push_back(1e4 / own.centre_per_cm());
        }
        ones_ = factor([](double) { return 1.0; });
    }
    std::size_t size() const { return set.nodes.size(); }

    /// Per node the integral over its bin's hat of R times a function of wavelength, times the
    /// node's weight.
    template <typename Function>
    std::vector<double> factor(Function f) const {
        std::vector<double> perBin(centres_um_.size());
        integrate([&](double at_um) { return f(at_um) * band_.responseAt(at_um); }, perBin);
        std::vector<double> perNode(size());
        for (std::size_t i = 0; i < size(); ++i)
            perNode[i] = weight_[i] * perBin[binOf_[i]];
        return perNode;
    }
    /// Per node the mean of a function over its bin's hat, as SensorCkData::sampled gives it.
    template <typename Function>
    std::vector<double> mean(Function f) const {
        std::vector<double> sums(centres_um_.size()), weights(centres_um_.size());
        integrate(f, sums);
        integrate([](double) { return 1.0; }, weights);
        std::vector<double> perNode(size());
        for (std::size_t i = 0; i < size(); ++i)
            perNode[i] = weights[binOf_[i]] > 0.0 ? sums[binOf_[i]] / weights[binOf_[i]] : 0.0;
        return perNode;
    }
    /// The hat over a node's bin, cut to the band: linear to 0 at the neighbours' centres.
    Spectrum hat(std::size_t node) const {
        const std::size_t b = binOf_[node];
        std::vector<double> axis, values;
        if (b + 1 < centres_um_.size()) {
            axis.push_back(centres_um_[b + 1]);
            values.push_back(0.0);
        }
        axis.push_back(centres_um_[b]);
        values.push_back(1.0);
        if (b > 0) {
            axis.push_back(centres_um_[b - 1]);
            values.push_back(0.0);
        }
        return Spectrum(axis, values, Spectrum::Outside::zero, "hat");
    }
    const std::vector<double>& ones() const { return ones_; }
    double wavelength_um(std::size_t i) const { return 1e4 / set.wavenumbers_per_cm[i]; }

    NodeSet set;

  private:
    /// Adds the integral of f times every bin's hat over the band.
    template <typename Function>
    void integrate(Function f, std::vector<double>& perBin) const {
        const GaussRule& rule = gaussLegendre(32);
        for (std::size_t b = 0; b + 1 < centres_um_.size(); ++b) { // wavelengths fall
            const double lower_um = std::max(centres_um_[b + 1], band_.range().min_um);
            const double upper_um = std::min(centres_um_[b], band_.range().max_um);
            if (!(lower_um < upper_um))
                continue;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double at_um = lower_um + (upper_um - lower_um) * rule.nodes[i];
                const double value = f(at_um) * (upper_um - lower_um) * rule.weights[i];
                const double part =
                    (at_um - centres_um_[b + 1]) / (centres_um_[b] - centres_um_[b + 1]);
                perBin[b] += part * value;
                perBin[b + 1] += (1.0 - part) * value;
            }
        }
    }

    Band band_;
    std::vector<std::size_t> binOf_; ///< of every node
    std::vector<double> centres_um_; ///< of every bin, falling
    std::vector<double> weight_, ones_;
};

/// One spectral function in the two forms that training needs: its integral over every node's share
/// of the band, and its mean over the node's bin.
struct Source {
    std::vector<double> integrated, sampled;

    template <typename Function>
    Source(const BandNodes& nodes, Function f)
        : integrated(nodes.factor(f)), sampled(nodes.mean(f)) {}
    double inBand() const { return std::accumulate(integrated.begin(), integrated.end(), 0.0); }
};

/// Rows of the training problem: in-band quantities, each relative to its own size.
class Training {
  public:
    explicit Training(const BandNodes& nodes) : nodes_(nodes) {}

    /// Integral of source times values, relative to it or to `least`, whichever is more.
    void add(const Source& source, const std::vector<double>& values, double least = 0.0) {
        add(source.integrated, source.sampled, values, least);
    }
    /// Integral of values alone.
    void add(const std::vector<double>& values, double least = 0.0) {
        add(nodes_.ones(), {}, values, least);
    }
    SparseProblem problem() const {
        SparseProblem problem;
        problem.rows = rows_.size();
        problem.target = target_;
        problem.columns.resize(rows_.size() * nodes_.size());
        for (std::size_t r = 0; r < rows_.size(); ++r)
            for (std::size_t i = 0; i < nodes_.size(); ++i)
                problem.columns[i * rows_.size() + r] = rows_[r][i];
        return problem;
    }

    /// How far the terms are off, row by row.
    struct Errors {
        double largest = 0.0, rms = 0.0;
    };
    Errors errorsOf(const SparseWeights& chosen) const {
        Errors errors;
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            double error = -target_[r];
            for (std::size_t c = 0; c < chosen.columns.size(); ++c)
                error += chosen.weights[c] * static_cast<double>(rows_[r][chosen.columns[c]]);
            errors.largest = std::max(errors.largest, std::abs(error));
            errors.rms += error * error / static_cast<double>(rows_.size());
        }
        errors.rms = std::sqrt(errors.rms);
        return errors;
    }

  private:
    void add(const std::vector<double>& integrated, const std::vector<double>& sampled,
             const std::vector<double>& values, double least) {
        double sum = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i)
            sum += integrated[i] * values[i];
        const double scale = std::max(sum, least);
        if (!(scale > 1e-30))
            return;
        std::vector<float> row(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            row[i] = static_cast<float>((sampled.empty() ? 1.0 : sampled[i]) * values[i] / scale);
        rows_.push_back(std::move(row));
        target_.push_back(sum / scale);
    }

    const BandNodes& nodes_;
    std::vector<std::vector<float>> rows_;
    std::vector<double> target_;
};

/// 1 plus or minus a cosine of some half waves over a range.
auto waveOver(SpectralRange range, int waves, double sign) {
    return [=](double wavelength_um) {
        const double phase =
            std::numbers::pi * waves * (wavelength_um - range.min_um) / range.width_um();
        return 1.0 + sign * std::cos(phase);
    };
}

/// Surfaces of many temperatures, grey and with structure.
std::vector<Source> sources(const BandNodes& nodes, const CkRequest& request) {
    std::vector<Source> all;
    auto planck = [](double temperature_K) {
        return [temperature_K](double wavelength_um) {
            return planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
        };
    };
    for (const double temperature_K : {220.0, 260.0, 300.0, 450.0, 900.0, 2200.0})
        all.emplace_back(nodes, planck(temperature_K));

    // Structure over the band: a surface may emit in any part of it.
    const SpectralRange& range = request.band.range();
    for (const int waves : {1, 2, 3, 5})
        for (const double sign : {1.0, -1.0})
            all.emplace_back(nodes, [&, part = waveOver(range, waves, sign)](double wavelength_um) {
                return part(wavelength_um) * planckRadiance_W_m2_sr_um(wavelength_um, 400.0);
            });

    return all;
}

/// The spectra of the scene: materials as a black body at 400 K has them; radiances of gas as they
/// are and in parts, as their wings are what long paths let through.
std::vector<Source> ownSources(const BandNodes& nodes, const CkRequest& request) {
    std::vector<Source> all;
    const SpectralRange& range = request.band.range();
    auto teaches = [](const Spectrum& spectrum) {
        return !spectrum.isConstant() && spectrum.maximum() > 0.0;
    };
    for (const Spectrum* material : request.materials)
        if (teaches(*material))
            all.emplace_back(nodes, [&](double wavelength_um) {
                return std::max(material->at(wavelength_um), 0.0) *
                       planckRadiance_W_m2_sr_um(wavelength_um, 400.0);
            });
    for (const Spectrum* radiance : request.radiances) {
        if (!teaches(*radiance))
            continue;
        auto own = [&](double wavelength_um) { return std::max(radiance->at(wavelength_um), 0.0); };
        all.emplace_back(nodes, own);
        for (const int waves : {3, 7})
            for (const double sign : {1.0, -1.0})
                all.emplace_back(nodes,
                                 [&, part = waveOver(range, waves, sign)](double wavelength_um) {
                                     return own(wavelength_um) * part(wavelength_um);
                                 });
    }
    return all;
}

/// A black body as warm as the air at the ground.
double ambientInBand_W_m2_sr(const RadiativeTransfer& transfer, const BandNodes& nodes) {
    return Source(nodes,
                  [&](double wavelength_um) {
                      return planckRadiance_W_m2_sr_um(
                          wavelength_um, transfer.air().profile.at(0.0).temperature_K);
                  })
        .inBand();
}

/// What is asked of the terms along paths; of the first `asked` with all spectra of the scene.
Training casesAlong(const RadiativeTransfer& transfer, const BandNodes& nodes,
                    const CkRequest& request, const std::vector<AtmosphericPath>& paths,
                    std::size_t asked) {
    Training training(nodes);
    const std::vector<Source> surfaces = sources(nodes, request);
    const std::vector<Source> own = ownSources(nodes, request);
    const NodeSet& set = nodes.set;
    const bool diffuse = transfer.air().scattering == ScatteringMode::twoStream;
    const double ambient_W_m2_sr = ambientInBand_W_m2_sr(transfer, nodes);

    for (const AtmosphericPath& path : paths) {
        const std::vector<double> transmittance = transfer.transmittance(set, path);
        for (const Source& surface : surfaces)
            training.add(surface, transmittance, opaque * surface.inBand());
        // Where there are many spectra, their rows on every fourth path of the spread are enough.
        const std::size_t number = static_cast<std::size_t>(&path - paths.data());
        if (own.size() <= 8 || number < asked || number % 4 == 0)
            for (const Source& surface : own)
                training.add(surface, transmittance, opaque * surface.inBand());
        // Across the sun, where its light is scattered as much as on the average over azimuths.
        AtmosphericPath across = path;
        across.azimuth_rad = request.sun.azimuth_rad + 0.5 * std::numbers::pi;
        training.add(transfer.pathRadiance(set, across, request.sun), opaque * ambient_W_m2_sr);

        // Light that a surface reflects has been through the air twice.
        auto reflected = [&](std::vector<double> light) {
            const double all =
                std::inner_product(light.begin(), light.end(), nodes.ones().begin(), 0.0);
            for (std::size_t i = 0; i < light.size(); ++i)
                light[i] *= transmittance[i];
            training.add(light, opaque * all);
        };
        reflected(transfer.solarIrradiance(set, path.targetAltitude_m, request.sun));
        if (diffuse) {
            reflected(transfer.downwardFlux(set, path.targetAltitude_m, request.sun));
            reflected(transfer.upwardFlux(set, path.targetAltitude_m, request.sun));
        }
    }
    return training;
}

Training trainingCases(const RadiativeTransfer& transfer, const BandNodes& nodes,
                       const CkRequest& request) {
    std::vector<AtmosphericPath> paths = request.paths;
    const std::vector<AtmosphericPath> spread = spreadOfPaths(transfer.air().profile.top_m());
    paths.insert(paths.end(), spread.begin(), spread.end());
    Training training = casesAlong(transfer, nodes, request, paths, request.paths.size());
    const double least = opaque * opaque * ambientInBand_W_m2_sr(transfer, nodes);
    for (const double altitude_m : {2.0, 3000.0, 10000.0})
        for (const double elevation_rad : {-0.5, -0.1, 0.02, 0.1, 0.5, 1.5})
            training.add(transfer.backgroundRadiance(nodes.set, {altitude_m, elevation_rad, 0.0},
                                                     request.sun),
                         least);
    return training;
}

} // namespace

SensorCkData SensorCkData::prepare(const RadiativeTransfer& transfer, const CkRequest& request) {
    const BandNodes nodes(transfer, request.band);
    if (nodes.size() == 0)
        throw InputError(Diagnostic{"band " + request.band.name(), "", "no spectral node",
                                    "a band within the atmosphere's table"});
    const SparseProblem problem = trainingCases(transfer, nodes, request).problem();
    const SparseWeights chosen = sparseWeights(problem, request.largestError, request.mostTerms);

    const Training::Errors heldOut =
        casesAlong(transfer, nodes, request, pathsHeldOut(transfer.air().profile.top_m()), 0)
            .errorsOf(chosen);

    SensorCkData data(request.band);
    std::vector<double> wavelengths_um, weights_um;
    // Nodes ascend in wavenumber; terms ascend in wavelength.
    for (std::size_t i = chosen.columns.size(); i-- > 0;) {
        const std::size_t node = chosen.columns[i];
        data.nodes_.nodes.push_back(nodes.set.nodes[node]);
        data.nodes_.wavenumbers_per_cm.push_back(nodes.set.wavenumbers_per_cm[node]);
        wavelengths_um.push_back(nodes.wavelength_um(node));
        weights_um.push_back(chosen.weights[i]);
        data.hats_.push_back(nodes.hat(node));
    }
    data.setNodes(std::move(wavelengths_um), std::move(weights_um), request.band.range());
    data.largestError_ = chosen.largestError;
    data.rmsError_ = chosen.rmsError;
    data.heldOutError_ = heldOut.largest;
    data.heldOutRms_ = heldOut.rms;
    return data;
}

void addTo(CkKey& key, const CkRequest& request) {
    auto add = [&](const Spectrum& spectrum) { // a constant has a value and no wavelength
        for (const auto* numbers : {&spectrum.wavelengths_um(), &spectrum.values()}) {
            key.add(static_cast<double>(numbers->size()));
            for (const double number : *numbers)
                key.add(number);
        }
    };
    key.add(request.band.range().min_um).add(request.band.range().max_um);
    add(request.band.response());
    key.add(request.sun.azimuth_rad).add(request.sun.elevation_rad).add(request.sun.distance_au);
    key.add(static_cast<double>(request.paths.size()));
    for (const AtmosphericPath& path : request.paths)
        key.add(path.sensorAltitude_m)
            .add(path.targetAltitude_m)
            .add(path.range_m)
            .add(path.azimuth_rad);
    for (const auto* kind : {&request.materials, &request.radiances}) {
        key.add(static_cast<double>(kind->size()));
        for (const Spectrum* spectrum : *kind)
            add(*spectrum);
    }
    key.add(request.largestError).add(static_cast<double>(request.mostTerms));
}

std::string SensorCkData::kept() const {
    CkKey text;
    text.add(static_cast<double>(size()));
    for (const double error : {largestError_, rmsError_, heldOutError_, heldOutRms_})
        text.add(error);
    for (std::size_t i = 0; i < size(); ++i)
        text.add(static_cast<double>(nodes_.nodes[i]))
            .add(nodes_.wavenumbers_per_cm[i])
            .add(weights_um()[i]);
    return text.text() + "end";
}

std::optional<SensorCkData> SensorCkData::fromKept(const RadiativeTransfer& transfer,
                                                   const Band& band, const std::string& text) {
    std::istringstream words(text);
    auto number = [&] {
        std::string word;
        words >> word;
        const std::optional<double> value = parseNumber(word);
        if (!value)
            words.setstate(std::ios::failbit);
        return value.value_or(0.0);
    };
    SensorCkData data(band);
    const double count = number();
    for (double* error :
         {&data.largestError_, &data.rmsError_, &data.heldOutError_, &data.heldOutRms_})
        *error = number();
    const BandNodes nodes(transfer, band);
    if (!words || !(count >= 1.0) || count > static_cast<double>(nodes.size()))
        return std::nullopt;

    std::vector<double> wavelengths_um, weights_um;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double node = number(), wavenumber_per_cm = number(), weight_um = number();
        const auto found =
            std::ranges::lower_bound(nodes.set.wavenumbers_per_cm, wavenumber_per_cm);
        auto at = static_cast<std::size_t>(found - nodes.set.wavenumbers_per_cm.begin());
        while (at < nodes.size() && nodes.set.wavenumbers_per_cm[at] == wavenumber_per_cm &&
               static_cast<double>(nodes.set.nodes[at]) != node)
            ++at;
        if (!words || at == nodes.size() || nodes.set.wavenumbers_per_cm[at] != wavenumber_per_cm ||
            !(weight_um > 0.0) ||
            (!wavelengths_um.empty() && nodes.wavelength_um(at) < wavelengths_um.back()))
            return std::nullopt;
        data.nodes_.nodes.push_back(nodes.set.nodes[at]);
        data.nodes_.wavenumbers_per_cm.push_back(wavenumber_per_cm);
        wavelengths_um.push_back(nodes.wavelength_um(at));
        weights_um.push_back(weight_um);
        data.hats_.push_back(nodes.hat(at));
    }
    std::string end;
    words >> end;
    if (end != "end")
        return std::nullopt;
    data.setNodes(std::move(wavelengths_um), std::move(weights_um), band.range());
    return data;
}

std::vector<double> SensorCkData::sampled(const Spectrum& spectrum) const {
    std::vector<double> means;
    for (const Spectrum& hat : hats_) {
        // The hat is cut to the band.
        const SpectralRange range{std::max(hat.wavelengths_um().front(), band_.range().min_um),
                                  std::min(hat.wavelengths_um().back(), band_.range().max_um)};
        const Spectrum* factors[] = {&hat, &spectrum};
        means.push_back(integrateProduct(factors, range) /
                        integrateProduct(std::span(factors, 1), range));
    }
    return means;
}

} // namespace irsg
