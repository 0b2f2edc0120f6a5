// How often the 95 % intervals of Sobol' indices hold the truth, on functions whose indices are
// known.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "smatcore/analysis/SobolIndices.h"

namespace {

using namespace smat;

/// A function of numbers that are uniform in [0, 1], and what is known of it.
struct Analytic {
    std::string name;
    std::function<double(const std::vector<double>&)> at;
    std::vector<double> firstOrder, total;
};

/// The sum of weights times numbers: an index is a weight's part of the sum of squares.
Analytic additive(const std::string& name, const std::vector<double>& weights) {
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight * weight;
    Analytic made{name,
                  [weights](const std::vector<double>& x) {
                      double value = 0.0;
                      for (std::size_t i = 0; i < weights.size(); ++i)
                          value += weights[i] * x[i];
                      return value;
                  },
                  {},
                  {}};
    for (const double weight : weights)
        made.firstOrder.push_back(weight * weight / sum);
    made.total = made.firstOrder;
    return made;
}

/// sin x + 7 sin^2 y + 0.1 z^4 sin x with numbers in [-pi, pi] (Ishigami and Homma 1990).
Analytic ishigami() {
    constexpr double a = 7.0, b = 0.1, pi = std::numbers::pi;
    const double p4 = std::pow(pi, 4), p8 = p4 * p4;
    const double all = a * a / 8.0 + b * p4 / 5.0 + b * b * p8 / 18.0 + 0.5;
    const double x = 0.5 * std::pow(1.0 + b * p4 / 5.0, 2), y = a * a / 8.0;
    const double xz = b * b * p8 * (1.0 / 18.0 - 1.0 / 50.0);
    return {"Ishigami",
            [](const std::vector<double>& u) {
                const auto angle = [&](std::size_t i) { return pi * (2.0 * u[i] - 1.0); };
                return std::sin(angle(0)) + a * std::pow(std::sin(angle(1)), 2) +
                       b * std::pow(angle(2), 4) * std::sin(angle(0));
            },
            {x / all, y / all, 0.0},
            {(x + xz) / all, y / all, xz / all}};
}

/// The product of (|4 x - 2| + a) / (1 + a) (Saltelli and Sobol' 1995).
Analytic gFunction(const std::string& name, const std::vector<double>& a) {
    std::vector<double> parts;
    double all = 1.0;
    for (const double one : a) {
        parts.push_back(1.0 / (3.0 * (1.0 + one) * (1.0 + one)));
        all *= 1.0 + parts.back();
    }
    Analytic made{name,
                  [a](const std::vector<double>& x) {
                      double value = 1.0;
                      for (std::size_t i = 0; i < a.size(); ++i)
                          value *= (std::abs(4.0 * x[i] - 2.0) + a[i]) / (1.0 + a[i]);
                      return value;
                  },
                  {},
                  {}};
    for (const double part : parts) {
        made.firstOrder.push_back(part / (all - 1.0));
        made.total.push_back(part * all / (1.0 + part) / (all - 1.0));
    }
    return made;
}

std::vector<SceneScaling> unitScales(std::size_t count) {
    std::vector<SceneScaling> scales;
    for (std::size_t i = 0; i < count; ++i)
        scales.push_back({{0, irsg::ScalingKind::emissivity, static_cast<int>(i), 0.0, 1.0},
                          irsg::Distribution(irsg::DistributionKind::uniform, 0.0, 1.0),
                          "u"});
    return scales;
}

void study(const Analytic& function, RealisationSequence sequence, std::size_t pairs, int repeats) {
    const std::size_t d = function.firstOrder.size();
    std::vector<int> first(d), total(d);
    double firstWidth = 0.0, totalWidth = 0.0;
    const ScaledModel model = [&](const std::vector<double>& x) {
        return std::vector<double>{function.at(x)};
    };
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const ScalingRealisations realisations(unitScales(d), sequence,
                                               1000 + static_cast<std::uint64_t>(repeat), true);
        for (const RankedScaling& one : rankScalings(
                 realisations, sequence, pairs, [&] { return model; },
                 [](std::size_t) { return true; })) {
            const auto holds = [](const Estimate& found, double truth) {
                return found.low95 <= truth && truth <= found.high95;
            };
            first[one.scaling] += holds(one.firstOrder, function.firstOrder[one.scaling]);
            total[one.scaling] += holds(one.total, function.total[one.scaling]);
            firstWidth += one.firstOrder.high95 - one.firstOrder.low95;
            totalWidth += one.total.high95 - one.total.low95;
        }
    }
    const auto percents = [&](const std::vector<int>& held) {
        std::string text;
        for (const int one : held) {
            char word[16];
            std::snprintf(word, sizeof word, " %5.1f", 100.0 * one / repeats);
            text += word;
        }
        return text;
    };
    const double each = static_cast<double>(d) * repeats;
    std::printf("| %s | %s | %zu |%s | %.3f |%s | %.3f |\n", function.name.c_str(), name(sequence),
                pairs, percents(first).c_str(), firstWidth / each, percents(total).c_str(),
                totalWidth / each);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 1000;
    if (argc > 2 || repeats < 1) {
        std::fprintf(stderr, "usage: sobol-coverage [REPEATS]\n");
        return 2;
    }
    std::printf("%d repeats: one standard error of 95 %% is %.1f %%\n\n", repeats,
                std::sqrt(95.0 * 5.0 / repeats));
    std::printf("| function | sequence | pairs | first order, %% held | width | total, %% held | "
                "width |\n|---|---|---|---|---|---|---|\n");
    for (const Analytic& function :
         {additive("additive, 3", {4.0, 2.0, 1.0}),
          additive("additive, 8", {10.0, 3.0, 1.0, 0.5, 0.3, 0.1, 0.03, 0.01}), ishigami(),
          gFunction("g, 3", {0.0, 1.0, 9.0}), gFunction("g, 6", {0.0, 0.5, 3.0, 9.0, 99.0, 99.0})})
        for (const RealisationSequence sequence :
             {RealisationSequence::plain, RealisationSequence::sobol})
            for (const std::size_t pairs : {64, 256, 1024})
                study(function, sequence, pairs, repeats);
}
