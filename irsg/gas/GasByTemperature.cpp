#include "irsg/gas/GasByTemperature.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/gas/GasMean.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

double thinAbsorption(const GasLayer& gas) {
    constexpr double sootAsGas = 0.02; // a ppmv absorbs as so much of CO2
    const double fractions = gas.fraction(HotGas::CO2) + 0.3 * gas.fraction(HotGas::H2O) +
                             gas.fraction(HotGas::CO) + gas.fraction(HotGas::CH4) +
                             sootAsGas * gas.soot_ppmv;
    return fractions * gas.pressure_atm / gas.temperature_K;
}

GasByTemperature::GasByTemperature(std::vector<PlumePart> parts) {
    constexpr double at_um = 4.4;
    std::vector<double> emits;
    emits.reserve(parts.size());
    parts_.reserve(parts.size());
    double allAbsorbs = 0.0, allEmits = 0.0;
    for (const PlumePart& part : parts) {
        emits.push_back(part.absorbs * planckRadiance_W_m2_sr_um(at_um, part.gas.temperature_K));
        allAbsorbs += part.absorbs;
        allEmits += emits.back();
    }
    if (!(allEmits > 0.0))
        throw InputError({"plume", "", "no CO2, H2O, CO, CH4 or soot", "a gas that emits"});
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts_.push_back(
            {parts[i].gas, 0.5 * (parts[i].absorbs / allAbsorbs + emits[i] / allEmits)});
    std::ranges::sort(parts_, std::greater(), [](const Part& p) { return p.gas.temperature_K; });
    // What is colder than all that counts would be spread over much air.
    constexpr double countsNot = 1e-3;
    double rest = 0.0;
    while (parts_.size() > 1 && rest + parts_.back().counts < countsNot) {
        rest += parts_.back().counts;
        parts_.pop_back();
    }
    isAll_ = rest == 0.0;
}

GasLayer GasByTemperature::meanOf(std::size_t first, std::size_t end) const {
    GasMean mean;
    for (std::size_t i = first; i < end; ++i)
        mean.add(parts_[i].gas, parts_[i].counts);
    return mean.mean();
}

std::vector<std::size_t> GasByTemperature::endsOf(std::size_t count) const {
    constexpr double steps = 400.0;
    const auto rootOf = [&](const Part& part) {
        return std::sqrt(part.gas.temperature_K - coldest_K());
    };
    const double highest = rootOf(parts_.front()), lowest = rootOf(parts_.back());
    struct Sums {
        std::size_t end = 0; ///< part
        double weight = 0.0, first = 0.0, second = 0.0;
    };
    std::vector<Sums> sums(1); // of all parts before the end of each step
    double step = -1.0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const double root = rootOf(parts_[i]);
        const double own =
            highest > lowest ? std::floor(steps * (highest - root) / (highest - lowest)) : 0.0;
        if (std::exchange(step, own) != own)
            sums.push_back(sums.back());
        Sums& all = sums.back();
        all.end = i + 1;
        all.weight += parts_[i].counts;
        all.first += parts_[i].counts * root;
        all.second += parts_[i].counts * root * root;
    }
    const auto costOf = [&](std::size_t from, std::size_t to) {
        const double weight = sums[to].weight - sums[from].weight;
        const double first = sums[to].first - sums[from].first;
        return weight > 0.0 ? sums[to].second - sums[from].second - first * first / weight : 0.0;
    };
    const std::size_t all = sums.size() - 1, most = std::min(count, all);
    // Of the steps before each one in so many runs: the least cost, and where the last begins.
    std::vector<std::vector<std::pair<double, std::size_t>>> best(most + 1);
    best[0].assign(all + 1, {std::numeric_limits<double>::infinity(), 0});
    best[0][0].first = 0.0;
    for (std::size_t runs = 1; runs <= most; ++runs) {
        best[runs].assign(all + 1, best[0][1]);
        for (std::size_t to = runs; to <= all; ++to)
            for (std::size_t from = runs - 1; from < to; ++from) {
                const double cost = best[runs - 1][from].first + costOf(from, to);
                if (cost < best[runs][to].first)
                    best[runs][to] = {cost, from};
            }
    }
    std::vector<std::size_t> ends;
    for (std::size_t runs = most, to = all; runs > 0; to = best[runs--][to].second)
        ends.push_back(sums[to].end);
    std::ranges::reverse(ends);
    return ends;
}

std::vector<PlumeRun> GasByTemperature::parted(std::size_t count) const {
    std::vector<PlumeRun> runs;
    std::size_t first = 0;
    for (const std::size_t next : endsOf(count)) {
        const bool isAll = next == parts_.size() && isAll_;
        runs.push_back({meanOf(first, next), isAll ? 0.0 : parts_[next - 1].gas.temperature_K});
        first = next;
    }
    return runs;
}

} // namespace irsg
