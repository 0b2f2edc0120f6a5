#include "irsg/atmosphere/ck/CkTraining.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

constexpr double opaque = 1e-3; ///< in-band transmittances below this need not be right relatively

/// One spectral function in the two forms that training needs: its integral over every node's share
/// of the band, and its mean over the node's bin.
struct Source {
    std::vector<double> integrated, sampled;

    template <typename Function>
    Source(const CkNodes& nodes, Function f)
        : integrated(nodes.factor(f)), sampled(nodes.mean(f)) {}
    double inBand() const { return std::accumulate(integrated.begin(), integrated.end(), 0.0); }
};

/// Rows of the training problem: in-band quantities, each relative to its own size.
class Training {
  public:
    explicit Training(const CkNodes& nodes) : nodes_(nodes) {
        problem_.columnCount = nodes.size();
        shares_.assign(nodes.size(), 0.0f);
    }

    /// Integral of source times values, relative to it or to `least`, whichever is more.
    void add(const Source& source, const std::vector<double>& values, double least = 0.0) {
        add(source.integrated, source.sampled, values, least);
    }
    /// Integral of values alone.
    void add(const std::vector<double>& values, double least = 0.0) {
        add(nodes_.ones(), {}, values, least);
    }
    std::size_t rows() const { return problem_.rows(); }

    /// The fewest terms that hold in every row. Nodes of a bin are much alike: every second of them
    /// is a candidate, and each that has a hundredth of a row by itself.
    SparseWeights solved(double largestError, std::size_t most) {
        std::vector<std::size_t> candidates;
        for (std::size_t i = 0; i < shares_.size(); ++i)
            if (nodes_.placeInBin(i) % 2 == 0 || shares_[i] > 0.01f)
                candidates.push_back(i);
        SparseProblem some;
        some.columnCount = candidates.size();
        some.target = problem_.target;
        some.matrix.reserve(some.columnCount * some.rows());
        for (std::size_t r = 0; r < problem_.rows(); ++r)
            for (const std::size_t i : candidates)
                some.matrix.push_back(problem_.row(r)[i]);
        SparseWeights chosen = sparseWeights(some, largestError, most);
        for (std::size_t& column : chosen.columns)
            column = candidates[column];
        return chosen;
    }

    CkErrors errorsOf(const SparseWeights& chosen) const {
        CkErrors errors;
        for (std::size_t r = 0; r < problem_.rows(); ++r) {
            double error = -problem_.target[r];
            for (std::size_t c = 0; c < chosen.columns.size(); ++c)
                error +=
                    chosen.weights[c] * static_cast<double>(problem_.row(r)[chosen.columns[c]]);
            errors.largest = std::max(errors.largest, std::abs(error));
            errors.rms += error * error / static_cast<double>(problem_.rows());
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
        const std::size_t from = problem_.matrix.size();
        problem_.matrix.resize(from + values.size());
        float* row = problem_.matrix.data() + from;
        const double perScale = 1.0 / scale;
        for (std::size_t i = 0; i < values.size(); ++i)
            shares_[i] =
                std::max(shares_[i], static_cast<float>(integrated[i] * values[i] * perScale));
        if (sampled.empty())
            for (std::size_t i = 0; i < values.size(); ++i)
                row[i] = static_cast<float>(values[i] * perScale);
        else
            for (std::size_t i = 0; i < values.size(); ++i)
                row[i] = static_cast<float>(sampled[i] * values[i] * perScale);
        problem_.target.push_back(sum * perScale);
    }

    const CkNodes& nodes_;
    SparseProblem problem_;
    std::vector<float> shares_; ///< of every node, the largest part of a row
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
std::vector<Source> sources(const CkNodes& nodes, const CkRequest& request) {
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
std::vector<Source> ownSources(const CkNodes& nodes, const CkRequest& request) {
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
double ambientInBand_W_m2_sr(const CkAir& air) {
    return Source(air.nodes,
                  [&](double wavelength_um) {
                      return planckRadiance_W_m2_sr_um(wavelength_um, air.ambient_K);
                  })
        .inBand();
}

/// Light that falls on a target at an altitude: of the sun, the sky and the ground.
class Lights {
  public:
    Lights(const CkAir& air, const SunPosition& sun) : air_(air), sun_(sun) {}

    const std::vector<std::vector<double>>& at(double altitude_m) {
        auto [found, isNew] = known_.try_emplace(altitude_m);
        if (isNew)
            for (const AtmosphericQuery& question :
                 {AtmosphericQuery::solarIrradiance(altitude_m, sun_),
                  AtmosphericQuery::downwardFlux(altitude_m, sun_),
                  AtmosphericQuery::upwardFlux(altitude_m, sun_)})
                found->second.push_back(air_.values(question));
        return found->second;
    }

  private:
    const CkAir& air_;
    SunPosition sun_;
    std::map<double, std::vector<std::vector<double>>> known_;
};

/// What is asked of the terms along paths; of the first `asked` with all spectra of the scene.
Training casesAlong(const CkAir& air, const CkRequest& request,
                    const std::vector<AtmosphericPath>& paths, std::size_t asked) {
    const CkNodes& nodes = air.nodes;
    Training training(nodes);
    const std::vector<Source> surfaces = sources(nodes, request);
    const std::vector<Source> own = ownSources(nodes, request);
    const double ambient_W_m2_sr = ambientInBand_W_m2_sr(air);
    Lights lights(air, request.sun);

    for (const AtmosphericPath& path : paths) {
        const std::vector<double> transmittance = air.values(AtmosphericQuery::transmittance(path));
        if (transmittance.empty())
            continue;
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
        training.add(air.values(AtmosphericQuery::pathRadiance(across, request.sun)),
                     opaque * ambient_W_m2_sr);

        // Light that a surface reflects has been through the air twice.
        for (std::vector<double> light : lights.at(path.targetAltitude_m)) {
            const double all =
                std::inner_product(light.begin(), light.end(), nodes.ones().begin(), 0.0);
            for (std::size_t i = 0; i < light.size(); ++i)
                light[i] *= transmittance[i];
            training.add(light, opaque * all);
        }
    }
    return training;
}

} // namespace

SparseWeights trainedTerms(const CkAir& air, const CkRequest& request) {
    if (air.nodes.size() == 0)
        throw InputError(Diagnostic{"band " + request.band.name(), "", "no spectral node",
                                    "a band within the atmosphere's table"});
    std::vector<AtmosphericPath> paths = request.paths;
    paths.insert(paths.end(), air.paths.begin(), air.paths.end());
    Training training = casesAlong(air, request, paths, request.paths.size());
    const double least = opaque * opaque * ambientInBand_W_m2_sr(air);
    for (const LineOfSight& sight : air.sights)
        training.add(air.values(AtmosphericQuery::backgroundRadiance(sight, request.sun)), least);
    if (training.rows() == 0)
        throw InputError(Diagnostic{"band " + request.band.name(), "", "no light in it",
                                    "a band with a response where the atmosphere answers"});
    return training.solved(request.largestError, request.mostTerms);
}

CkErrors heldOutErrors(const CkAir& air, const CkRequest& request, const SparseWeights& chosen) {
    return casesAlong(air, request, air.heldOut, 0).errorsOf(chosen);
}

} // namespace irsg
