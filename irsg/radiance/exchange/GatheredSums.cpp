#include "irsg/radiance/exchange/GatheredSums.h"

#include <algorithm>

namespace irsg {

GatheredSums::GatheredSums(const std::vector<std::span<const double>>& integrals, std::size_t first)
    : kinds_(integrals.size()), count_(integrals.empty() ? 0 : integrals.front().size() - first) {
    interleaved_.assign((kinds_ + lanes - 1) / lanes * lanes * count_, 0.0);
    for (std::size_t k = 0; k < kinds_; ++k)
        for (std::size_t i = 0; i < count_; ++i)
            interleaved_[(k / lanes * count_ + i) * lanes + k % lanes] = integrals[k][first + i];
}

void GatheredSums::add(const std::array<std::span<const float>, together>& gathered,
                       std::span<double> sums) const {
    thread_local std::vector<float> zeros;
    zeros.resize(std::max(zeros.size(), count_));
    std::array<const float*, together> from{};
    for (std::size_t r = 0; r < together; ++r)
        from[r] = gathered[r].empty() ? zeros.data() : gathered[r].data();
    for (std::size_t k = 0; k < kinds_; k += lanes) {
        const std::size_t own = std::min(lanes, kinds_ - k);
        std::array<std::array<double, lanes>, together> all{};
        for (std::size_t r = 0; r < together; ++r)
            for (std::size_t l = 0; l < own; ++l)
                all[r][l] = sums[r * kinds_ + k + l];
        const double* integral = interleaved_.data() + k * count_;
        for (std::size_t i = 0; i < count_; ++i, integral += lanes)
            for (std::size_t r = 0; r < together; ++r) {
                const auto weight = static_cast<double>(from[r][i]);
                for (std::size_t l = 0; l < lanes; ++l)
                    all[r][l] += weight * integral[l];
            }
        for (std::size_t r = 0; r < together; ++r)
            for (std::size_t l = 0; l < own; ++l)
                sums[r * kinds_ + k + l] = all[r][l];
    }
}

} // namespace irsg
