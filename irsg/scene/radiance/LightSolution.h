#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "irsg/scene/trace/LightExchange.h"

namespace irsg {

/// What a column of sources gives every sender of a drawn row.
enum class LightPattern { emission, sun, sky, ground };

/// Light of one kind that the surfaces of one drawn row send of themselves, or reflect at first.
struct LightColumn {
    int row = 0;
    std::size_t term = 0; ///< of RadianceTerms
    LightPattern pattern = LightPattern::emission;
};

/// What receivers get of each column, at a radiance of 1: directly, after some reflections, or
/// after all of them. With F the view factors, rho the reflectivities of the rows and S a column,
///   L = S + rho F L,  G = F L,
/// the linear system of pairs, by iteration. Reflectivities come as knots, sets of one for each row
/// between which G is linear.
class LightSolution {
  public:
    /// `bounces`: 1 is light that comes from where it was sent or first reflected; -1 is all.
    /// `error`: of all, as a part of the largest.
    LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                  const std::vector<std::vector<double>>& knots, int bounces, double error);

    std::size_t columns() const { return columns_; }
    std::size_t knots() const { return knots_; }
    /// Of a receiver, columns of the first knot first; empty where it gets nothing.
    std::span<const float> of(std::size_t receiver) const {
        const std::size_t at = places_[receiver];
        return at == none ? std::span<const float>()
                          : std::span(gathered_).subspan(at * columns_ * knots_, columns_ * knots_);
    }
    /// Iterations that the slowest knot took.
    int iterations() const { return iterations_; }

  private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    void solve(const LightExchange& exchange, std::size_t knot,
               const std::vector<double>& reflectivities, const std::vector<double>& sent,
               int bounces, double error);

    std::size_t columns_, knots_;
    std::vector<std::size_t> places_;   // by receiver
    std::vector<std::size_t> receiver_; // by place
    std::vector<float> gathered_;
    int iterations_ = 0;
};

} // namespace irsg
