#include "irsg/radiance/exchange/LightThroughGas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

namespace irsg {

namespace {

/// Rays by how long they are in each gas: roots of lengths, as parts of the greatest.
struct GasLengths {
    std::vector<IrCodes> codes;
    std::vector<double> lengths_m, roots; // by ray, then by gas

    explicit GasLengths(const std::vector<GasOnRay>& rays) {
        std::map<IrCodes, std::size_t> numbers;
        for (const GasOnRay& ray : rays)
            for (const GasColumnKey::Stretch& stretch : ray.stretches)
                numbers.try_emplace(stretch.codes, 0);
        for (auto& [of, number] : numbers) {
            number = codes.size();
            codes.push_back(of);
        }
        lengths_m.assign(rays.size() * codes.size(), 0.0);
        std::vector<double> longest_m(codes.size(), 0.0);
        for (std::size_t r = 0; r < rays.size(); ++r)
            for (const GasColumnKey::Stretch& stretch : rays[r].stretches) {
                const std::size_t gas = numbers.at(stretch.codes);
                double& own_m = lengths_m[r * codes.size() + gas];
                own_m += stretch.length_m;
                longest_m[gas] = std::max(longest_m[gas], own_m);
            }
        for (std::size_t i = 0; i < lengths_m.size(); ++i)
            roots.push_back(std::sqrt(lengths_m[i] / longest_m[i % codes.size()]));
    }
};

struct RayGroup {
    std::vector<std::size_t> rays;
    std::size_t axis = 0; ///< gas whose lengths differ most
    double mean = 0.0, spread = 0.0;
};

/// Sums of squares about the means, each ray as it weighs.
void measure(const GasLengths& lengths, const std::vector<GasOnRay>& rays, RayGroup& group) {
    const std::size_t gases = lengths.codes.size();
    double most = -1.0;
    group.spread = 0.0;
    for (std::size_t gas = 0; gas < gases; ++gas) {
        double weight = 0.0, sum = 0.0, squares = 0.0;
        for (const std::size_t r : group.rays) {
            const double at = lengths.roots[r * gases + gas];
            weight += rays[r].weight;
            sum += rays[r].weight * at;
            squares += rays[r].weight * at * at;
        }
        const double mean = weight > 0.0 ? sum / weight : 0.0;
        const double spread = std::max(squares - mean * sum, 0.0);
        group.spread += spread;
        if (spread > most) {
            most = spread;
            group.axis = gas;
            group.mean = mean;
        }
    }
}

/// The column of the ray in the middle of a group, with the lengths of the mean.
GasColumnKey columnOf(const GasLengths& lengths, const std::vector<GasOnRay>& rays,
                      const RayGroup& group) {
    const std::size_t gases = lengths.codes.size();
    std::vector<double> means_m(gases), roots(gases);
    double weight = 0.0;
    for (const std::size_t r : group.rays) {
        weight += rays[r].weight;
        for (std::size_t gas = 0; gas < gases; ++gas) {
            means_m[gas] += rays[r].weight * lengths.lengths_m[r * gases + gas];
            roots[gas] += rays[r].weight * lengths.roots[r * gases + gas];
        }
    }
    for (std::size_t gas = 0; gas < gases && weight > 0.0; ++gas) {
        means_m[gas] /= weight;
        roots[gas] /= weight;
    }
    const auto offOf = [&](std::size_t r) {
        double off = 0.0;
        for (std::size_t gas = 0; gas < gases; ++gas)
            off += std::pow(lengths.roots[r * gases + gas] - roots[gas], 2.0);
        return off;
    };
    const std::size_t middle = *std::ranges::min_element(group.rays, {}, offOf);
    GasColumnKey column{rays[middle].stretches, 0};
    for (std::size_t gas = 0; gas < gases; ++gas) {
        const double own_m = lengths.lengths_m[middle * gases + gas];
        if (own_m > 0.0) {
            for (GasColumnKey::Stretch& stretch : column.stretches)
                if (stretch.codes == lengths.codes[gas])
                    stretch.length_m *= means_m[gas] / own_m;
        } else if (means_m[gas] > 0.0) {
            column.stretches.push_back({lengths.codes[gas], means_m[gas]});
        }
    }
    return column;
}

} // namespace

FewGasColumns::FewGasColumns(const std::vector<GasOnRay>& rays, std::size_t most) {
    constexpr double alike = 1e-5; // mean square of roots
    if (rays.empty())
        return;
    const GasLengths lengths(rays);
    std::vector<RayGroup> groups(1);
    groups[0].rays.resize(rays.size());
    std::iota(groups[0].rays.begin(), groups[0].rays.end(), std::size_t{0});
    measure(lengths, rays, groups[0]);
    double whole = 0.0;
    for (const GasOnRay& ray : rays)
        whole += ray.weight;
    while (groups.size() < most) {
        const auto widest = std::ranges::max_element(groups, {}, &RayGroup::spread);
        if (widest->spread <= alike * whole)
            break;
        const auto isShort = [&, axis = widest->axis, mean = widest->mean](std::size_t r) {
            return lengths.roots[r * lengths.codes.size() + axis] < mean;
        };
        RayGroup others;
        const auto behind = std::ranges::stable_partition(widest->rays, isShort);
        others.rays.assign(behind.begin(), behind.end());
        widest->rays.erase(behind.begin(), behind.end());
        if (others.rays.empty() || widest->rays.empty()) {
            widest->rays.insert(widest->rays.end(), others.rays.begin(), others.rays.end());
            widest->spread = 0.0;
            continue;
        }
        measure(lengths, rays, *widest);
        measure(lengths, rays, others);
        groups.push_back(std::move(others));
    }
    columnOf_.resize(rays.size());
    for (const RayGroup& group : groups) {
        for (const std::size_t r : group.rays)
            columnOf_[r] = columns_.size();
        columns_.push_back(irsg::columnOf(lengths, rays, group));
    }
}

} // namespace irsg
