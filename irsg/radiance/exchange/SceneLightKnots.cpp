#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Light that passes a pane once is linear in its transmissivity: it is not divided as finely as
/// reflectivities, which light meets again and again.
constexpr double partOfPanes = 0.25;
/// Of transmissivities more than these are not told apart.
constexpr std::size_t mostKnotsOfPanes = 48;
/// With gas: each fills a small part of a receiver's hemisphere.
constexpr std::size_t mostKnotsOfGas = 24;

/// Divides a curve of vectors at the fewest places between which it is straight.
class CurveDivision {
  public:
    /// `curve[i]`: all of equal length. `off`: most distance from a straight line, `step`: most
    /// change along one, in any coordinate.
    CurveDivision(const std::vector<std::vector<double>>& curve, double off, double step)
        : curve_(&curve), off_(off), step_(step) {}

    std::vector<std::size_t> places() {
        places_.push_back(0);
        if (curve_->size() > 1)
            divide(0, curve_->size() - 1);
        return std::move(places_);
    }
    /// Where between two points of the curve another lies, 0 to 1.
    double partOf(std::size_t a, std::size_t b, std::size_t i) const {
        double along = 0.0, square = 0.0;
        for (std::size_t k = 0; k < (*curve_)[a].size(); ++k) {
            const double step = (*curve_)[b][k] - (*curve_)[a][k];
            along += step * ((*curve_)[i][k] - (*curve_)[a][k]);
            square += step * step;
        }
        return square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    }

  private:
    void divide(std::size_t a, std::size_t b) {
        double worst = 0.0, length = 0.0;
        std::size_t at = a + (b - a) / 2;
        for (std::size_t k = 0; k < (*curve_)[a].size(); ++k)
            length = std::max(length, std::abs((*curve_)[b][k] - (*curve_)[a][k]));
        for (std::size_t i = a + 1; i < b; ++i) {
            const double part = partOf(a, b, i);
            for (std::size_t k = 0; k < (*curve_)[i].size(); ++k) {
                const double line = (*curve_)[a][k] + part * ((*curve_)[b][k] - (*curve_)[a][k]);
                const double off = std::abs((*curve_)[i][k] - line);
                if (off > worst) {
                    worst = off;
                    at = i;
                }
            }
        }
        if (b - a > 1 && (worst > off_ || length > step_)) {
            if (worst <= off_)
                at = a + (b - a) / 2;
            divide(a, at);
            divide(at, b);
            return;
        }
        places_.push_back(b);
    }

    const std::vector<std::vector<double>>* curve_;
    double off_, step_;
    std::vector<std::size_t> places_;
};

/// How much columns of gas let through on the whole, by node; nothing without gas.
std::vector<double> gasStrengths(const LightExchange& exchange,
                                 const std::vector<std::vector<double>>& panes, std::size_t nodes) {
    if (exchange.throughGas().empty())
        return {};
    std::vector<double> sums(nodes, 0.0);
    for (std::size_t pane = exchange.firstGasPane(); pane < panes.size(); ++pane)
        for (std::size_t i = 0; i < nodes; ++i)
            sums[i] += panes[pane][i];
    return sums;
}

} // namespace

void SceneLight::findKnots(const RenderSettings& settings) {
    const std::size_t nodes = radiometry_.wavelengths_um().size();
    knotsOfNodes_.between.assign(nodes, {});
    knotsOfNodes_.parts.assign(nodes, 0.0);
    const std::vector<double> black(radiometry_.surfaces().size(), 0.0);
    std::vector<std::vector<double>> panes; // transmissivities
    for (const OccluderMaterial& pane : exchange_->panes())
        panes.push_back(passingOf(pane, *exchange_, radiometry_));
    if (settings.bounces == 1 && panes.empty()) {
        knots_.push_back({black, {}, {}});
        return;
    }
    // Rows that light is reflected at on its way, and how much of what they send comes back at
    // most.
    std::vector<double> most(exchange_->rows());
    for (std::size_t s = 0; s < exchange_->senders(); ++s)
        if (exchange_->isSeen(s)) {
            double& own = most[static_cast<std::size_t>(exchange_->rowOfSender(s))];
            double sum = exchange_->between().sumOf(s);
            for (const LightThrough& one : exchange_->through())
                sum += one.balance.between->sumOf(s);
            own = std::max(own, sum);
        }
    std::vector<std::pair<std::size_t, double>> rows;
    for (std::size_t row = 0; row < most.size(); ++row)
        if (most[row] > 0.0 && settings.bounces != 1)
            rows.emplace_back(row, std::min(most[row], 1.0));
    const auto reflectivity = [&](std::size_t row, std::size_t node) {
        return pi * radiometry_.surfaces()[row].reflectance[node];
    };
    const std::vector<std::vector<double>> shares = gasSharesOf(*exchange_, radiometry_);
    const std::vector<double> strengths = gasStrengths(*exchange_, panes, nodes);
    std::vector<std::size_t> order(nodes);
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Lines of gas come and go with the wavelength, but strong ones are alike.
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return strengths.empty() ? radiometry_.wavelengths_um()[i] : strengths[i];
    });
    const std::size_t firstOfGas =
        exchange_->throughGas().empty() ? panes.size() : exchange_->firstGasPane();
    // L grows as 1 / (1 - rho F): straight enough in the logarithm of that.
    std::vector<std::vector<double>> curve;
    std::vector<std::size_t> places(nodes), first;
    for (const std::size_t node : order) {
        std::vector<double> at;
        at.reserve(rows.size() + panes.size() + shares.size());
        for (const auto& [row, most] : rows)
            at.push_back(-std::log(1.0 - std::min(reflectivity(row, node), 0.9999) * most));
        for (std::size_t pane = 0; pane < panes.size(); ++pane)
            at.push_back((pane < firstOfGas ? partOfPanes : 1.0) * panes[pane][node]);
        if (exchange_->gasSenders().size() > 1)
            for (const std::vector<double>& share : shares)
                at.push_back(share[node]);
        if (curve.empty() || curve.back() != at) {
            curve.push_back(std::move(at));
            first.push_back(node);
        }
        places[node] = curve.size() - 1;
    }
    double off = 0.1 * settings.lightError, step = std::sqrt(settings.lightError);
    CurveDivision division(curve, off, step);
    std::vector<std::size_t> divided = division.places();
    // Gas may transmit otherwise at each wavelength.
    const std::size_t mostKnots =
        exchange_->throughGas().empty() ? mostKnotsOfPanes : mostKnotsOfGas;
    while (!panes.empty() && divided.size() > mostKnots) {
        division = CurveDivision(curve, off *= 2.0, step *= 2.0);
        divided = division.places();
    }
    std::vector<std::size_t> knotOf; // by division
    for (const std::size_t place : divided) {
        LightKnot own{black, {}, {}};
        for (const auto& [row, most] : rows)
            own.reflectivities[row] = reflectivity(row, first[place]);
        for (const std::vector<double>& passes : panes)
            own.transmissivities.push_back(passes[first[place]]);
        for (const std::vector<double>& share : shares)
            own.shares.push_back(share[first[place]]);
        const auto known = std::ranges::find(knots_, own);
        knotOf.push_back(static_cast<std::size_t>(known - knots_.begin()));
        if (known == knots_.end())
            knots_.push_back(std::move(own));
    }
    for (std::size_t node = 0; node < nodes; ++node) {
        const auto above = std::ranges::lower_bound(divided, places[node]);
        const auto high = static_cast<std::size_t>(above - divided.begin());
        const std::size_t low = high > 0 ? high - 1 : 0;
        knotsOfNodes_.between[node] = {knotOf[low], knotOf[high]};
        knotsOfNodes_.parts[node] = division.partOf(divided[low], divided[high], places[node]);
    }
}

} // namespace irsg
