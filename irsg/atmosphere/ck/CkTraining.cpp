#include "irsg/atmosphere/ck/CkTraining.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <numeric>
#include <span>

#include "irsg/atmosphere/ck/ActiveSet.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

constexpr double opaque = 1e-3; ///< in-band transmittances below this need not be right relatively

/// One spectral function, and its integral over the band.
struct Source : CkNodes::Shares {
    double inBand;

    template <typename Function>
    Source(const CkNodes& nodes, Function f, int points = CkNodes::pointsOfBin)
        : Shares(nodes.shares(f, points)),
          inBand(std::accumulate(integrated.begin(), integrated.end(), 0.0)) {}
};

/// Something that quadrature points shall hold: the integral over the band of source times values,
/// relative to itself or to `least`, whichever is more.
struct Case {
    const std::vector<double>& integrated; ///< the source's share of the integral, per node
    const std::vector<double>* sampled;    ///< its value at a point; null: 1
    const std::vector<double>& values;     ///< of the air
    double least;

    /// The integral; `scale` is what errors are relative to, false where it is nothing.
    bool isAny(double& integral, double& scale) const {
        integral = product(values.data(), integrated.data(), values.size());
        scale = std::max(integral, least);
        return scale > 1e-30;
    }
    double atPoint(std::size_t node) const {
        return sampled != nullptr ? (*sampled)[node] * values[node] : values[node];
    }
};

/// A row, and the shares with it.
IRSG_VECTOR_CLONES void fillRow(const double* values, const double* integrated,
                                const double* sampled, double perScale, std::size_t n,
                                float* __restrict row, float* __restrict shares) {
    for (std::size_t i = 0; i < n; ++i) {
        const float share = static_cast<float>(integrated[i] * values[i] * perScale);
        shares[i] = shares[i] < share ? share : shares[i];
    }
    if (sampled != nullptr)
        for (std::size_t i = 0; i < n; ++i)
            row[i] = static_cast<float>(sampled[i] * values[i] * perScale);
    else
        for (std::size_t i = 0; i < n; ++i)
            row[i] = static_cast<float>(values[i] * perScale);
}

/// Some rows of the training problem: in-band quantities, each relative to its own size.
struct Rows {
    std::vector<float> matrix; ///< row by row
    std::vector<double> target;
    std::vector<float> shares; ///< of every node, the largest part of a row

    explicit Rows(std::size_t nodes) : shares(nodes, 0.0f) {}

    void add(const Case& one) {
        double sum = 0.0, scale = 0.0;
        if (!one.isAny(sum, scale))
            return;
        const std::size_t nodes = shares.size(), from = matrix.size();
        matrix.resize(from + nodes);
        float* row = matrix.data() + from;
        const double perScale = 1.0 / scale;
        fillRow(one.values.data(), one.integrated.data(),
                one.sampled ? one.sampled->data() : nullptr, perScale, nodes, row, shares.data());
        target.push_back(sum * perScale);
    }
};

/// The fewest points that hold in every row. Nodes of a bin are much alike: every second of them is
/// a candidate, and each that has a hundredth of a row by itself.
SparseWeights solved(const CkNodes& nodes, const std::vector<Rows>& parts, double largestError,
                     std::size_t most) {
    std::vector<float> shares(nodes.size(), 0.0f);
    SparseProblem problem;
    for (const Rows& part : parts) {
        problem.target.insert(problem.target.end(), part.target.begin(), part.target.end());
        std::ranges::transform(shares, part.shares, shares.begin(),
                               [](float a, float b) { return std::max(a, b); });
    }
    if (problem.target.empty())
        return {};
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (nodes.placeInBin(i) % 2 == 0 || shares[i] > 0.01f)
            candidates.push_back(i);
    problem.columnCount = candidates.size();
    problem.matrix.resize(problem.columnCount * problem.rows());
    float* to = problem.matrix.data();
    for (const Rows& part : parts)
        for (std::size_t r = 0; r < part.target.size(); ++r) {
            const float* row = part.matrix.data() + r * nodes.size();
            for (const std::size_t i : candidates)
                *to++ = row[i];
        }
    SparseWeights chosen = sparseWeights(problem, largestError, most);
    for (std::size_t& column : chosen.columns)
        column = candidates[column];
    return chosen;
}

/// 1 plus or minus a cosine of some half waves over a range.
auto waveOver(SpectralRange range, int waves, double sign) {
    return [=](double wavelength_um) {
        const double phase =
            std::numbers::pi * waves * (wavelength_um - range.min_um) / range.width_um();
        return 1.0 + sign * std::cos(phase);
    };
}

/// Points of a bin at which a smooth function is taken; spectra with lines have more.
constexpr int smoothPoints = 8;

/// Surfaces of many temperatures, grey and with structure.
std::vector<Source> sources(const CkNodes& nodes, const CkRequest& request) {
    std::vector<Source> all;
    auto planck = [](double temperature_K) {
        return [temperature_K](double wavelength_um) {
            return planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
        };
    };
    for (const double temperature_K : {220.0, 260.0, 300.0, 450.0, 900.0, 2200.0})
        all.emplace_back(nodes, planck(temperature_K), smoothPoints);

    // Structure over the band: a surface may emit in any part of it.
    const SpectralRange& range = request.band.range();
    for (const int waves : {1, 2, 3, 5})
        for (const double sign : {1.0, -1.0})
            all.emplace_back(
                nodes,
                [&, part = waveOver(range, waves, sign)](double wavelength_um) {
                    return part(wavelength_um) * planckRadiance_W_m2_sr_um(wavelength_um, 400.0);
                },
                smoothPoints);

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
double ambientInBand_W_m2_sr(const CkAtmosphere& air) {
    return Source(air.nodes,
                  [&](double wavelength_um) {
                      return planckRadiance_W_m2_sr_um(wavelength_um, air.ambient_K);
                  })
        .inBand;
}

/// What is asked of points along paths: sources, the air's own light and what surfaces reflect.
class Cases {
  public:
    /// The light that falls on targets at the ends of the paths is computed here.
    Cases(const CkAtmosphere& air, const CkRequest& request,
          std::initializer_list<std::span<const AtmosphericPath>> paths)
        : air_(air),
          sun_(request.sun),
          surfaces_(sources(air.nodes, request)),
          own_(ownSources(air.nodes, request)),
          ambient_W_m2_sr_(ambientInBand_W_m2_sr(air)) {
        for (const auto& some : paths)
            for (const AtmosphericPath& path : some)
                lights_[path.targetAltitude_m];
        std::vector<decltype(lights_)::value_type*> places;
        places.reserve(lights_.size());
        for (auto& light : lights_)
            places.push_back(&light);
        parallelFor(places.size(), [&](std::size_t i) {
            const double altitude_m = places[i]->first;
            for (const AtmosphericQuery& query :
                 {AtmosphericQuery::solarIrradiance(altitude_m, sun_),
                  AtmosphericQuery::downwardFlux(altitude_m, sun_),
                  AtmosphericQuery::upwardFlux(altitude_m, sun_)})
                places[i]->second.push_back(air_.values(query));
        });
    }

    std::size_t ownCount() const { return own_.size(); }
    double ambient_W_m2_sr() const { return ambient_W_m2_sr_; }

    /// Calls `take(Case)` for all along a path; with the spectra of the scene where `withOwn`.
    template <typename Take>
    void along(const AtmosphericPath& path, bool withOwn, Take take) const {
        const std::vector<double> transmittance =
            air_.values(AtmosphericQuery::transmittance(path));
        if (transmittance.empty())
            return;
        const auto seen = [&](const std::vector<Source>& sources) {
            for (const Source& source : sources)
                take(Case{source.integrated, &source.sampled, transmittance,
                          opaque * source.inBand});
        };
        seen(surfaces_);
        if (withOwn)
            seen(own_);
        // Across the sun, where its light is scattered as much as on the average over azimuths.
        AtmosphericPath across = path;
        across.azimuth_rad = sun_.azimuth_rad + 0.5 * std::numbers::pi;
        ofLight(air_.values(AtmosphericQuery::pathRadiance(across, sun_)),
                opaque * ambient_W_m2_sr_, take);

        ofReflection(path, transmittance, take);
    }
    /// The same of a path that is asked for its transmittance alone: every second surface, by its
    /// place among the paths, and the emission of air of one temperature.
    template <typename Take>
    void shade(const AtmosphericPath& path, std::size_t place, bool withOwn, Take take) const {
        std::vector<double> transmittance = air_.values(AtmosphericQuery::transmittance(path));
        if (transmittance.empty())
            return;
        for (std::size_t s = place % 2; s < surfaces_.size(); s += 2)
            take(Case{surfaces_[s].integrated, &surfaces_[s].sampled, transmittance,
                      opaque * surfaces_[s].inBand});
        if (withOwn)
            for (const Source& source : own_)
                take(Case{source.integrated, &source.sampled, transmittance,
                          opaque * source.inBand});
        ofReflection(path, transmittance, take);
        for (double& value : transmittance)
            value = 1.0 - value;
        constexpr std::size_t cold = 0, warm = 2; // 220 and 300 K
        for (const Source* source : {&surfaces_[cold], &surfaces_[warm]})
            take(
                Case{source->integrated, &source->sampled, transmittance, opaque * source->inBand});
    }
    template <typename Take>
    void ofSight(const LineOfSight& sight, Take take) const {
        ofLight(air_.values(AtmosphericQuery::backgroundRadiance(sight, sun_)),
                opaque * opaque * ambient_W_m2_sr_, take);
    }

  private:
    /// Light that a surface at the target reflects has been through the air twice.
    template <typename Take>
    void ofReflection(const AtmosphericPath& path, const std::vector<double>& transmittance,
                      Take take) const {
        for (std::vector<double> light : lightNear(path.targetAltitude_m)) {
            const double all =
                std::inner_product(light.begin(), light.end(), air_.nodes.ones().begin(), 0.0);
            for (std::size_t i = 0; i < light.size(); ++i)
                light[i] *= transmittance[i];
            ofLight(light, opaque * all, take);
        }
    }
    /// What falls on a target at the altitude that is nearest among those of all paths.
    const std::vector<std::vector<double>>& lightNear(double altitude_m) const {
        auto above = lights_.lower_bound(altitude_m);
        if (above == lights_.end() ||
            (above != lights_.begin() &&
             altitude_m - std::prev(above)->first < above->first - altitude_m))
            --above;
        return above->second;
    }
    template <typename Take>
    void ofLight(const std::vector<double>& values, double least, Take take) const {
        if (!values.empty()) // the air knows of it
            take(Case{air_.nodes.ones(), nullptr, values, least});
    }

    const CkAtmosphere& air_;
    SunPosition sun_;
    std::vector<Source> surfaces_, own_;
    double ambient_W_m2_sr_;
    std::map<double, std::vector<std::vector<double>>> lights_; ///< by altitude
};

/// Of points along the held-out paths, against the sums over all nodes.
CkErrors errorsHeldOut(const CkAtmosphere& air, const Cases& cases, const SparseWeights& chosen) {
    std::vector<std::vector<double>> errors(air.heldOut.size());
    parallelFor(errors.size(), [&](std::size_t i) {
        const bool withOwn = cases.ownCount() <= 8 || i % 4 == 0;
        cases.along(air.heldOut[i], withOwn, [&](const Case& one) {
            double integral = 0.0, scale = 0.0;
            if (!one.isAny(integral, scale))
                return;
            double found = 0.0;
            for (std::size_t c = 0; c < chosen.columns.size(); ++c)
                found += chosen.weights[c] * one.atPoint(chosen.columns[c]);
            errors[i].push_back((found - integral) / scale);
        });
    });
    CkErrors all;
    std::size_t count = 0;
    for (const std::vector<double>& some : errors)
        for (const double error : some) {
            all.largest = std::max(all.largest, std::abs(error));
            all.rms += error * error;
            ++count;
        }
    all.rms = count > 0 ? std::sqrt(all.rms / static_cast<double>(count)) : 0.0;
    return all;
}

} // namespace

SparseWeights trainedPoints(const CkAtmosphere& air, const CkRequest& request, CkErrors* heldOut) {
    if (air.nodes.size() == 0)
        throw InputError(Diagnostic{"band " + request.band.name(), "", "no spectral node",
                                    "a band within the atmosphere's table"});
    std::vector<AtmosphericPath> paths = request.paths;
    paths.insert(paths.end(), air.paths.begin(), air.paths.end());
    const Cases cases = heldOut != nullptr ? Cases(air, request, {paths, air.heldOut})
                                           : Cases(air, request, {paths});
    const std::size_t full = paths.size() + air.sights.size();
    std::vector<Rows> parts(full + air.shades.size(), Rows(air.nodes.size()));
    parallelFor(parts.size(), [&](std::size_t i) {
        const auto take = [&](const Case& one) { parts[i].add(one); };
        if (i >= full) {
            cases.shade(air.shades[i - full], i - full, cases.ownCount() <= 8 || i % 4 == 0, take);
            return;
        }
        if (i >= paths.size()) {
            cases.ofSight(air.sights[i - paths.size()], take);
            return;
        }
        // Where there are many spectra, their rows on every fourth path of the spread are enough.
        const bool withOwn = cases.ownCount() <= 8 || i < request.paths.size() || i % 4 == 0;
        cases.along(paths[i], withOwn, take);
    });
    SparseWeights chosen = solved(air.nodes, parts, request.largestError, request.mostPoints);
    if (chosen.columns.empty())
        throw InputError(Diagnostic{"band " + request.band.name(), "", "no light in it",
                                    "a band with a response where the atmosphere answers"});
    if (heldOut != nullptr)
        *heldOut = errorsHeldOut(air, cases, chosen);
    return chosen;
}
} // namespace irsg
