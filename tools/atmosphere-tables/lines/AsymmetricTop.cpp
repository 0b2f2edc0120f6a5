#include "tools/atmosphere-tables/lines/AsymmetricTop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>

#include "tools/atmosphere-tables/lines/AngularMomentum.h"
#include "tools/atmosphere-tables/lines/SymmetricEigen.h"

namespace irsg::lbl {

namespace {

/// <k + 1 | J+ | k>
double raised(int J, int k) {
    return std::sqrt(std::max(0.0, J * (J + 1.0) - k * (k + 1.0)));
}

/// <k' | Jx^2 - Jy^2 | k> where k' = k + 2 or k - 2.
double rhombic(int J, int kBra, int kKet) {
    const int low = std::min(kBra, kKet);
    return 0.5 * raised(J, low) * raised(J, low + 1);
}

/// (|k> + sign |-k>) / sqrt 2
struct WangFunction {
    std::size_t state;
    int K, sign;

    double of(int k) const {
        if (K == 0)
            return k == 0 ? 1.0 : 0.0;
        return k == K ? std::sqrt(0.5) : k == -K ? sign * std::sqrt(0.5) : 0.0;
    }
};

int parity(int number) {
    return number % 2 == 0 ? 1 : -1;
}

} // namespace

double AsymmetricTop::element(std::size_t bra, std::size_t ket, int J, int kBra, int kKet) const {
    const double N = J * (J + 1.0);
    const int distance = std::abs(kBra - kKet);
    if (bra == ket) {
        const TopState& s = states_[bra];
        const double k2 = static_cast<double>(kKet) * kKet;
        if (distance == 0)
            return s.origin + N * (s.mean + N * (-s.deltaJ + N * s.HJ)) +
                   k2 * (s.axial - N * s.deltaJK + N * N * s.HJK +
                         k2 * (-s.deltaK + N * s.HKJ + k2 * (s.HK - N * s.LKKJ - k2 * s.LK)));
        if (distance != 2)
            return 0.0;
        const double other2 = static_cast<double>(kBra) * kBra;
        return rhombic(J, kBra, kKet) *
               (s.half - 2.0 * N * s.smallDeltaJ + 2.0 * N * N * s.hJ +
                (k2 + other2) * (-s.smallDeltaK + N * s.hJK) + (k2 * k2 + other2 * other2) * s.hK);
    }
    for (const TopCoupling& c : couplings_) {
        const bool isForward = c.first == bra && c.second == ket;
        if (!isForward && (c.first != ket || c.second != bra))
            continue;
        if (distance == 0)
            return c.anharmonic;
        if (distance != 1)
            return 0.0;
        const int to = isForward ? kBra : kKet, from = isForward ? kKet : kBra;
        const double root = 0.5 * raised(J, std::min(kBra, kKet));
        return root * ((to > from ? 1.0 : -1.0) * c.coriolis + (to + from) * c.tilt);
    }
    return 0.0;
}

std::vector<TopLevel> AsymmetricTop::levels(int J) const {
    std::vector<TopLevel> all;
    const auto width = static_cast<std::size_t>(2 * J + 1);
    for (const int block :
         {0, 1}) { // couplings change the parity of K where they change the species
        std::vector<WangFunction> basis;
        for (std::size_t s = 0; s < states_.size(); ++s) {
            const int odd = states_[s].isAntisymmetric ? 1 : 0;
            const int sign = parity(J + odd);
            for (int K = sign > 0 ? 0 : 1; K <= J; ++K)
                if ((K + odd) % 2 == block)
                    basis.push_back({s, K, sign});
        }
        const std::size_t n = basis.size();
        SquareMatrix matrix(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const WangFunction &a = basis[i], &b = basis[j];
                if (std::abs(a.K - b.K) > 2 && a.K + b.K > 2)
                    continue;
                double sum = 0.0;
                for (const int kBra : {a.K, -a.K}) {
                    for (const int kKet : {b.K, -b.K}) {
                        if (std::abs(kBra - kKet) <= 2)
                            sum +=
                                a.of(kBra) * b.of(kKet) * element(a.state, b.state, J, kBra, kKet);
                        if (b.K == 0)
                            break;
                    }
                    if (a.K == 0)
                        break;
                }
                matrix(i, j) = sum;
            }
        const EigenSystem system = eigenSystem(std::move(matrix));

        // Levels are named after the state that they have most of, the purest first, and within a
        // state by energy.
        std::vector<std::tuple<double, std::size_t, std::size_t>> shares; // -share, level, state
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double> share(states_.size(), 0.0);
            for (std::size_t f = 0; f < n; ++f)
                share[basis[f].state] += system.vectors[i][f] * system.vectors[i][f];
            for (std::size_t s = 0; s < share.size(); ++s)
                shares.emplace_back(-share[s], i, s);
        }
        std::ranges::sort(shares);
        std::vector<std::vector<int>> places(states_.size()); // K of each level of a state
        for (const WangFunction& f : basis)
            places[f.state].push_back(f.K);
        std::vector<std::size_t> owner(n, states_.size()), taken(states_.size(), 0);
        for (const auto& [share, level, state] : shares)
            if (owner[level] == states_.size() && taken[state] < places[state].size()) {
                owner[level] = state;
                ++taken[state];
            }
        std::vector<std::size_t> next(states_.size(), 0);
        for (std::size_t i = 0; i < n; ++i) {
            TopLevel level;
            level.energy_per_cm = system.values[i];
            level.state = owner[i];
            level.J = J;
            level.Ka = places[owner[i]][next[owner[i]]++];
            // Rotation about c by half a turn: Kc is even where the sign is that of (-1)^(J + Ka).
            const int sign = parity(J + (states_[owner[i]].isAntisymmetric ? 1 : 0));
            level.Kc = J - level.Ka;
            if (level.Ka > 0 && (parity(level.Kc) > 0) != (sign == parity(J + level.Ka)))
                ++level.Kc;
            level.amplitudes.assign(states_.size() * width, 0.0);
            for (std::size_t f = 0; f < n; ++f)
                for (const int k : {basis[f].K, -basis[f].K})
                    level.amplitudes[basis[f].state * width + static_cast<std::size_t>(J + k)] =
                        system.vectors[i][f] * basis[f].of(k);
            all.push_back(std::move(level));
        }
    }
    return all;
}

std::vector<TopTransition> transitions(const AsymmetricTop& lower, const AsymmetricTop& upper,
                                       const std::vector<TopMoment>& moments, int highestJ,
                                       double from_per_cm, double to_per_cm) {
    std::vector<TopTransition> found;
    std::map<int, std::vector<TopLevel>> uppers;
    auto bare = [](const TopLevel& level) {
        return TopLevel{level.energy_per_cm, level.state, level.J, level.Ka, level.Kc, {}};
    };
    for (int J = 0; J <= highestJ; ++J) {
        const std::vector<TopLevel> lowers = lower.levels(J);
        for (int upperJ = std::max(0, J - 1); upperJ <= J + 1; ++upperJ) {
            auto kept = uppers.find(upperJ);
            if (kept == uppers.end())
                kept = uppers.emplace(upperJ, upper.levels(upperJ)).first;
            const auto width = static_cast<std::size_t>(2 * J + 1),
                       upperWidth = static_cast<std::size_t>(2 * upperJ + 1);
            const double m = upperJ < J ? -J : upperJ > J ? J + 1.0 : 0.0;
            for (const TopLevel& from : lowers) {
                std::vector<double> image(upper.stateCount() * upperWidth, 0.0);
                for (const TopMoment& moment : moments) {
                    const double size = moment.debye *
                                        (1.0 + m * (moment.linear + m * moment.square)) *
                                        std::sqrt(static_cast<double>(width));
                    for (int k = -J; k <= J; ++k) {
                        const double amplitude =
                            from.amplitudes[moment.lower * width + static_cast<std::size_t>(J + k)];
                        if (amplitude == 0.0)
                            continue;
                        for (const int q : {-1, 0, 1}) {
                            if ((q == 0) != (moment.axis == TopMoment::Axis::a) ||
                                std::abs(k + q) > upperJ)
                                continue;
                            image[moment.upper * upperWidth +
                                  static_cast<std::size_t>(upperJ + k + q)] +=
                                size * amplitude * clebschGordan(J, k, q, upperJ) *
                                (q == 0 ? 1.0 : -q * std::sqrt(0.5));
                        }
                    }
                }
                for (const TopLevel& to : kept->second) {
                    const double distance = to.energy_per_cm - from.energy_per_cm;
                    if (distance < from_per_cm || distance >= to_per_cm)
                        continue;
                    double sum = 0.0;
                    for (std::size_t i = 0; i < image.size(); ++i)
                        sum += image[i] * to.amplitudes[i];
                    if (sum != 0.0)
                        found.push_back({bare(from), bare(to), sum * sum});
                }
            }
            if (upperJ == J - 1)
                uppers.erase(kept);
        }
    }
    return found;
}

} // namespace irsg::lbl
