#include "irsg/gas/GasColumnBasis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "irsg/core/ParallelFor.h"
#include "irsg/gas/GasStrengths.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr std::size_t keptOut = 6; ///< one of so many lines
constexpr std::size_t mostColumns = 32;
constexpr double closest = 5e-4; ///< of a line: columns that leave less are enough
/// Lines count by their relative error, down to this part of the strongest.
constexpr double faint = 0.02;
constexpr double ridge = 1e-5;
constexpr std::size_t mostFronts = 14;
constexpr double closestFronts = 2e-4; ///< of 1, rms over wavenumbers
constexpr std::size_t mostReflectionFronts = 10;
constexpr std::size_t mostPlaces = 24, mostStrengths = 48;
/// Of the mean absorption at a place: of strong lines and of what lies between them.
constexpr std::array<double, 4> strengthsOfPlace = {0.1, 0.5, 2.0, 10.0};

double square(const double* values, std::size_t count) {
    return std::inner_product(values, values + count, values, 0.0);
}

/// Takes from every vector its part along one of them, of which this is a copy.
void project(std::vector<double> along, std::vector<std::vector<double>>& vectors) {
    const double size = square(along.data(), along.size());
    if (!(size > 0.0))
        return;
    for (std::vector<double>& other : vectors) {
        const double part =
            std::inner_product(along.begin(), along.end(), other.begin(), 0.0) / size;
        for (std::size_t i = 0; i < along.size(); ++i)
            other[i] -= part * along[i];
    }
}

/// The vectors that all others are nearest to weighted sums of: until what is left of each is no
/// longer than this.
std::vector<std::size_t> pivots(std::vector<std::vector<double>> rest, std::size_t most,
                                double longest) {
    const auto sizeOf = [](const std::vector<double>& vector) {
        return square(vector.data(), vector.size());
    };
    std::vector<std::size_t> pivots;
    while (pivots.size() < std::min(most, rest.size())) {
        const auto largest = std::ranges::max_element(rest, {}, sizeOf);
        if (!(sizeOf(*largest) > longest * longest))
            break;
        pivots.push_back(static_cast<std::size_t>(largest - rest.begin()));
        project(*largest, rest);
    }
    return pivots;
}

} // namespace

/// What lines do at the wavenumbers: radiances as parts of those of the hottest gas, then what they
/// stop.
class GasColumnBasis::Fit {
  public:
    Fit(const std::vector<GasLayer>& gases, const std::vector<double>& wavenumbers_per_cm,
        const std::vector<GasLine>& lines)
        : columns_(gases, wavenumbers_per_cm) {
        hottest_ = static_cast<std::size_t>(
            std::ranges::max_element(gases, {}, &GasLayer::temperature_K) - gases.begin());
        std::vector<double> wavelengths_um;
        for (const double wavenumber_per_cm : wavenumbers_per_cm)
            wavelengths_um.push_back(wavelengthFromWavenumber_um(wavenumber_per_cm));
        for (std::size_t g = 0; g < gases.size(); ++g)
            planckRadiances_W_m2_sr_um(wavelengths_um, gases[g].temperature_K,
                                       planck_.emplace_back(wavelengths_um.size()));
        for (std::size_t i = 0; i < places(); ++i)
            perWavenumber_.push_back(planck_[hottest_][i] * wavelengths_um[i] * wavelengths_um[i]);
        for (std::size_t i = 0; i < lines.size(); ++i)
            ((i + 1) % keptOut == 0 ? others_ : lines_).push_back(lines[i]);
        done_ = doneBy(lines_);
        emissionCounts_ = emissionCounts(gases);
    }

    std::size_t places() const { return columns_.wavenumbers_per_cm().size(); }
    const std::vector<GasLine>& lines() const { return lines_; }
    const std::vector<GasLine>& others() const { return others_; }
    const std::vector<std::vector<double>>& done() const { return done_; }
    /// The same, as errors count.
    std::vector<double> counted(std::size_t line) const {
        std::vector<double> done = done_[line];
        for (std::size_t i = 0; i < places(); ++i)
            done[i] *= emissionCounts_;
        return done;
    }
    double planck(std::size_t gas, std::size_t place) const {
        return planck_[gas][place] / planck_[hottest_][place];
    }
    std::vector<std::vector<double>> doneBy(const std::vector<GasLine>& lines) const {
        std::vector<std::vector<double>> done(lines.size());
        parallelFor(lines.size(), [&](std::size_t l) {
            const std::vector<std::vector<double>> shares = columns_.shares(lines[l]);
            done[l].assign(2 * places(), 0.0);
            for (std::size_t g = 0; g < shares.size(); ++g)
                for (std::size_t i = 0; i < places(); ++i) {
                    done[l][i] += shares[g][i] * planck(g, i);
                    done[l][places() + i] += shares[g][i];
                }
        });
        return done;
    }
    /// Of all wavenumbers, with the weights of Planck's law.
    double radiance(const double* done) const {
        return std::inner_product(perWavenumber_.begin(), perWavenumber_.end(), done, 0.0);
    }
    /// Absorption of each gas at each wavenumber, 1/m, in thin layers.
    std::vector<std::vector<double>> absorption_per_m() const {
        constexpr double thin_m = 1e-7;
        std::vector<std::vector<double>> all;
        for (std::size_t g = 0; g < columns_.gases(); ++g) {
            const GasStretch stretch{g, thin_m};
            all.push_back(columns_.shares(std::span(&stretch, 1))[g]);
            for (double& value : all.back())
                value /= thin_m;
        }
        return all;
    }
    /// By line: what its errors count by.
    std::vector<double> weights() const {
        std::vector<double> weights;
        double largest = 0.0;
        for (std::size_t l = 0; l < done_.size(); ++l) {
            const std::vector<double> line = counted(l);
            weights.push_back(std::sqrt(square(line.data(), line.size())));
            largest = std::max(largest, weights.back());
        }
        for (double& weight : weights)
            weight = largest > 0.0 ? 1.0 / (weight + faint * largest) : 0.0;
        return weights;
    }
    /// The lines that the others are nearest to weighted sums of, by relative errors.
    std::vector<std::size_t> pivots() const {
        std::vector<std::vector<double>> rest;
        const std::vector<double> weights = this->weights();
        for (std::size_t l = 0; l < done_.size(); ++l)
            for (double& value : rest.emplace_back(counted(l)))
                value *= weights[l];
        return irsg::pivots(std::move(rest), mostColumns, closest);
    }
    /// The metres of gas of the line that has most of it.
    double longest_m() const {
        double longest_m = 0.0;
        for (const GasLine& line : lines_)
            longest_m = std::max(longest_m, std::accumulate(line.begin(), line.end(), 0.0,
                                                            [](double sum, const GasStretch& one) {
                                                                return sum + one.length_m;
                                                            }));
        return longest_m;
    }

  private:
    /// What emission counts more than transmittance. Cold gas about a hot core emits little of what
    /// the hottest would, so that an error of a part of 1, of which the background would hardly
    /// change, is more than all it emits.
    double emissionCounts(const std::vector<GasLayer>& gases) const {
        constexpr double most = 30.0;
        const auto coldest = static_cast<std::size_t>(
            std::ranges::min_element(gases, {}, &GasLayer::temperature_K) - gases.begin());
        double logarithms = 0.0;
        for (std::size_t i = 0; i < places(); ++i)
            logarithms += std::log(planck(coldest, i));
        return std::min(most, std::exp(-0.4 * logarithms / static_cast<double>(places())));
    }

    GasColumns columns_;
    double emissionCounts_ = 1.0;
    std::vector<std::vector<double>> planck_; ///< by gas
    std::vector<double> perWavenumber_;
    std::size_t hottest_ = 0;
    std::vector<GasLine> lines_, others_;
    std::vector<std::vector<double>> done_;
};

namespace {

/// Wavenumbers at which gases absorb unlike each other, the strongest first: the logarithms of
/// their absorption are far from those of all that were taken before.
std::vector<std::size_t> unlikePlaces(const std::vector<std::vector<double>>& absorption_per_m,
                                      double least_per_m) {
    const std::size_t places = absorption_per_m.front().size();
    std::vector<std::vector<double>> logarithms(places);
    std::vector<double> apart(places, 1e300), sums(places);
    for (std::size_t i = 0; i < places; ++i)
        for (const std::vector<double>& gas : absorption_per_m) {
            logarithms[i].push_back(std::log(gas[i] + least_per_m));
            sums[i] += gas[i];
        }
    std::vector<std::size_t> taken{
        static_cast<std::size_t>(std::ranges::max_element(sums) - sums.begin())};
    while (taken.size() < std::min(mostPlaces, places)) {
        for (std::size_t i = 0; i < places; ++i) {
            double distance = 0.0;
            for (std::size_t g = 0; g < absorption_per_m.size(); ++g)
                distance += std::pow(logarithms[i][g] - logarithms[taken.back()][g], 2.0);
            apart[i] = std::min(apart[i], distance);
        }
        taken.push_back(static_cast<std::size_t>(std::ranges::max_element(apart) - apart.begin()));
    }
    return taken;
}

/// Which of some pairs of vectors, the second half of the list behind the first, differ most from
/// what the others can be combined to.
std::vector<std::size_t> pairsApart(std::vector<std::vector<double>> vectors, std::size_t most) {
    const std::size_t pairs = vectors.size() / 2;
    for (std::vector<double>& vector : vectors) {
        const double size = std::sqrt(square(vector.data(), vector.size()));
        for (double& value : vector)
            value /= size > 0.0 ? size : 1.0;
    }
    std::vector<std::size_t> taken;
    std::vector<char> isTaken(pairs, 0);
    while (taken.size() < std::min(most, pairs)) {
        std::size_t best = pairs;
        double largest = 1e-20;
        for (std::size_t p = 0; p < pairs; ++p) {
            const std::vector<double>&one = vectors[p], &other = vectors[pairs + p];
            const double size = square(one.data(), one.size()) + square(other.data(), other.size());
            if (isTaken[p] == 0 && size > largest) {
                largest = size;
                best = p;
            }
        }
        if (best == pairs)
            break;
        isTaken[best] = 1;
        taken.push_back(best);
        for (const std::size_t of : {best, pairs + best})
            project(vectors[of], vectors);
    }
    return taken;
}

} // namespace

void GasColumnBasis::Line::clear() {
    std::ranges::fill(passes_, 1.0);
    std::ranges::fill(emits_, 0.0);
}

void GasColumnBasis::Line::add(std::size_t gas, double length_m) {
    const std::size_t from = gas * passes_.size();
    addStretch(basis_->absorption_per_m_.data() + from, basis_->emission_.data() + from, length_m,
               passes_.size(), passes_.data(), emits_.data());
}

void GasColumnBasis::Line::fillValues(std::span<double> values) const {
    const std::size_t count = emits_.size();
    std::ranges::copy(emits_, values.begin());
    // Less what passes, by parts of 1: no gas has no weight.
    for (std::size_t i = 0; i < count; ++i)
        values[count + i] = 1.0 - passes_[i];
}

void GasColumnBasis::weightsOf(std::span<const double> values, std::span<double> weights) const {
    std::ranges::fill(weights, 0.0);
    addMapped(values.data(), values.size(), map_.data(), weights.size(), weights.data());
}

void GasColumnBasis::weightsOf(const Line& line, std::span<double> weights) const {
    std::vector<double> values(valuesOfLine());
    line.fillValues(values);
    weightsOf(values, weights);
}

void GasColumnBasis::Fronts::weightsOf(std::span<const double> values,
                                       std::span<double> weights) const {
    std::ranges::fill(weights, 0.0);
    addMapped(values.data(), values.size(), map.data(), weights.size(), weights.data());
}

GasColumnBasis::GasColumnBasis(const std::vector<GasLayer>& gases,
                               const std::vector<double>& wavenumbers_per_cm,
                               const std::vector<GasLine>& lines)
    : perGas_(gases.size()) {
    if (gases.empty() || lines.empty() || wavenumbers_per_cm.empty())
        return;
    take(Fit(gases, wavenumbers_per_cm, lines));
}

GasColumnBasis::Line GasColumnBasis::follow(const GasLine& line) const {
    Line followed(*this);
    for (const GasStretch& stretch : line)
        followed.add(stretch.gas, stretch.length_m);
    return followed;
}

void GasColumnBasis::take(const Fit& fit) {
    const std::vector<std::size_t> pivots = fit.pivots();
    if (pivots.empty())
        return; // nothing absorbs here
    for (const std::size_t pivot : pivots)
        columns_.push_back(fit.lines()[pivot]);

    // Strengths of absorption: all that may count, then those that differ.
    const std::vector<std::vector<double>> absorption_per_m = fit.absorption_per_m();
    constexpr double thin = 1e-3;
    const std::vector<std::size_t> places = unlikePlaces(absorption_per_m, thin / fit.longest_m());
    std::vector<std::pair<std::size_t, double>> candidates; // place, factor
    for (const std::size_t place : places)
        for (const double factor : strengthsOfPlace)
            candidates.emplace_back(place, factor);
    const auto takeStrengths = [&](const std::vector<std::pair<std::size_t, double>>& of) {
        absorption_per_m_.clear();
        emission_.clear();
        for (std::size_t g = 0; g < perGas_; ++g)
            for (const auto& [place, factor] : of) {
                absorption_per_m_.push_back(factor * absorption_per_m[g][place]);
                emission_.push_back(fit.planck(g, place));
            }
    };
    const auto strengthsOf = [&](const GasLine& line) {
        const Line followed = follow(line);
        std::vector<double> all = followed.emits_;
        for (const double passes : followed.passes_)
            all.push_back(1.0 - passes);
        return all;
    };
    const std::vector<double> weights = fit.weights();
    const std::vector<GasLine>& lines = fit.lines();
    takeStrengths(candidates);
    std::vector<std::vector<double>> byStrength(2 * candidates.size(),
                                                std::vector<double>(lines.size()));
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const std::vector<double> all = strengthsOf(lines[l]);
        for (std::size_t i = 0; i < all.size(); ++i)
            byStrength[i][l] = weights[l] * all[i];
    }
    std::vector<std::pair<std::size_t, double>> taken;
    std::vector<std::size_t> numbers = pairsApart(byStrength, mostStrengths);
    for (const std::size_t number : numbers)
        taken.push_back(candidates[number]);
    takeStrengths(taken);

    // The weights that each line had best, and the map that comes nearest to them.
    const std::size_t values = 2 * fit.places();
    ColumnMatrix ofColumns(values, columns_.size()), ofLines(values, lines.size());
    for (std::size_t k = 0; k < pivots.size(); ++k)
        std::ranges::copy(fit.counted(pivots[k]), ofColumns.column(k));
    for (std::size_t l = 0; l < lines.size(); ++l)
        std::ranges::copy(fit.counted(l), ofLines.column(l));
    constexpr double ridgeOfColumns = 1e-4;
    const ColumnMatrix best = leastSquares(ofColumns, ofLines, ridgeOfColumns);
    ColumnMatrix ofStrengths(lines.size(), 2 * taken.size()), wanted(lines.size(), columns_.size());
    for (std::size_t i = 0; i < taken.size(); ++i)
        for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
            std::ranges::copy(byStrength[half * candidates.size() + numbers[i]],
                              ofStrengths.column(half * taken.size() + i));
    for (std::size_t l = 0; l < lines.size(); ++l)
        for (std::size_t k = 0; k < columns_.size(); ++k)
            wanted.at(l, k) = weights[l] * best.at(k, l);
    const ColumnMatrix map = leastSquares(ofStrengths, wanted, ridge);
    for (std::size_t i = 0; i < map.rows(); ++i)
        for (std::size_t k = 0; k < map.columns(); ++k)
            map_.push_back(map.at(i, k));
    std::vector<std::vector<double>> stopped; // by column
    for (const std::size_t pivot : pivots) {
        const std::vector<double>& done = fit.done()[pivot];
        stopped.emplace_back(done.begin() + static_cast<std::ptrdiff_t>(fit.places()), done.end());
    }
    fronts_ = frontsOf(stopped, mostFronts, closestFronts);
    reflectionFronts_ = frontsOf(stopped, mostReflectionFronts, closestFronts);

    // Lines that were kept out tell the error.
    const std::vector<std::vector<double>> truths = fit.doneBy(fit.others());
    std::vector<double> own(columns_.size());
    double sum = 0.0, errors = 0.0, squares = 0.0;
    for (std::size_t l = 0; l < truths.size(); ++l) {
        weightsOf(follow(fit.others()[l]), own);
        const double truth = fit.radiance(truths[l].data());
        double error = -truth;
        for (std::size_t k = 0; k < own.size(); ++k)
            error += own[k] * fit.radiance(fit.done()[pivots[k]].data());
        sum += truth;
        errors += error;
        squares += error * error;
    }
    if (sum > 0.0) {
        const auto count = static_cast<double>(truths.size());
        error_ = {errors / sum, std::sqrt(squares / count) / (sum / count)};
    }
}

GasColumnBasis::Fronts GasColumnBasis::frontsOf(const std::vector<std::vector<double>>& stopped,
                                                std::size_t most, double closest) const {
    const std::size_t places = stopped.front().size();
    Fronts fronts{irsg::pivots(stopped, most, closest * std::sqrt(static_cast<double>(places))),
                  {}};
    const std::size_t count = fronts.columns.size();
    ColumnMatrix ofFronts(places, count), ofColumns(places, stopped.size());
    for (std::size_t m = 0; m < count; ++m)
        std::ranges::copy(stopped[fronts.columns[m]], ofFronts.column(m));
    for (std::size_t k = 0; k < stopped.size(); ++k)
        std::ranges::copy(stopped[k], ofColumns.column(k));
    const ColumnMatrix best = leastSquares(ofFronts, ofColumns, ridge);
    std::vector<double> byColumn;
    for (std::size_t k = 0; k < stopped.size(); ++k)
        for (std::size_t m = 0; m < count; ++m)
            byColumn.push_back(best.at(m, k));
    const std::size_t values = map_.size() / stopped.size();
    fronts.map.assign(values * count, 0.0);
    for (std::size_t i = 0; i < values; ++i)
        addMapped(&map_[i * stopped.size()], stopped.size(), byColumn.data(), count,
                  &fronts.map[i * count]);
    return fronts;
}

} // namespace irsg
