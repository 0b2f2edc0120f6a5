#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/exchange/LightExchange.h"

namespace irsg {

/// What a column of sources gives every sender of a drawn row.
/// What is passed comes through transparent surfaces, or by the ground, to the receivers of the
/// row's body.
enum class LightPattern { emission, sun, sky, ground, passedSky, passedGround, passedSun };

/// Light of one kind that the surfaces of one drawn row send of themselves, or that those of some
/// rows which reflect alike reflect at first.
struct LightColumn {
    int row = 0;
    std::size_t term = 0; ///< of RadianceTerms
    LightPattern pattern = LightPattern::emission;
    int component = -1;       ///< emission that this one of a directional surface takes away
    std::vector<int> alike{}; ///< drawn rows beside the first
    bool isOf(int drawn) const {
        return drawn == row || std::ranges::find(alike, drawn) != alike.end();
    }
    bool isPassed() const {
        return pattern == LightPattern::passedSky || pattern == LightPattern::passedGround ||
               pattern == LightPattern::passedSun;
    }
    bool operator==(const LightColumn&) const = default;
};

/// By drawn row, and by material of LightExchange::panes. Of each column of gas among these, how
/// much of the light each of LightExchange::gasSenders takes away and sends in its place.
struct LightKnot {
    std::vector<double> reflectivities, transmissivities, shares;
    bool operator==(const LightKnot&) const = default;
};

/// An exchange at the transmissivities of its panes and gases.
class LightFactors {
  public:
    /// `exchange` must live as long.
    LightFactors(const LightExchange& exchange, const LightKnot& knot);

    const LightExchange& exchange() const { return exchange_; }
    /// As the exchange has them, of receivers and between senders.
    const WeightedPairs& pairs() const { return pairs_; }
    const WeightedPairs& between() const { return between_; }
    /// How much passes each set of LightExchange::through.
    std::span<const double> passing() const { return passing_; }
    /// Whether anything comes through transparent surfaces or gas.
    bool hasPassed() const { return !passing_.empty() || !throughGas_.empty(); }
    /// What a column of sources gives a sender.
    double patternOf(std::size_t sender, LightPattern pattern) const;
    /// What a sender's surface receives of a column that none sends: sky and ground.
    double passedOn(std::size_t sender, const LightColumn& column) const;
    /// What gas changes of what senders receive: of what these send, and of that.
    const LightPairs* changesByGas() const { return changesByGas_.get(); }
    double passedByGas(std::size_t sender, const LightColumn& column) const;
    /// What a receiver gets of it that no sender sends.
    double passedTo(std::size_t receiver, const LightColumn& column) const;

  private:
    /// What gas takes away of what comes from behind it (below 0), and what each of its senders
    /// sends where it emits.
    struct ThroughGas {
        double passing = 0.0;
        std::vector<double> sent;
    };
    /// Adds what gas changes of the pairs of a receiver, or a sender.
    void addGas(std::uint32_t receiver, std::shared_ptr<const LightPairs> LightBalance::*which,
                std::vector<float> LightThroughGas::*emitting, std::vector<LightPart>& parts) const;
    bool isBodyOf(std::size_t sender, const LightColumn& column) const;
    /// Of what surfaces send each other through nothing, the rest added.
    WeightedPairs withPassed(std::shared_ptr<const LightPairs> LightBalance::*which,
                             const LightPairs& base,
                             std::vector<float> LightThroughGas::*emitting) const;
    void takeGas(const LightKnot& knot);

    const LightExchange& exchange_;
    std::vector<double> passing_;
    std::vector<ThroughGas> throughGas_;
    WeightedPairs pairs_, between_;
    std::shared_ptr<const LightPairs> changesByGas_;
};

/// What receivers get of each column, at a radiance of 1: directly, after some reflections, or
/// after all of them. With F the view factors, rho the reflectivities of the rows and S a column,
///   L = S + rho F L,  G = F L,
/// the linear system of pairs, by iteration. Reflectivities and transmissivities come as knots,
/// between which G is linear.
class LightSolution {
  public:
    /// `bounces`: 1 is light that comes from where it was sent or first reflected; -1 is all.
    /// `error`: of all, as a part of the largest.
    LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                  const std::vector<LightKnot>& knots, int bounces, double error);
    /// The solution of LightExchange::alone() of a body, and the numbers that its columns have
    /// among all, ascending.
    struct OfBody {
        std::shared_ptr<const LightSolution> solution;
        std::vector<std::size_t> columns;
    };
    LightSolution(const LightExchange& exchange, const std::vector<LightColumn>& columns,
                  const std::vector<LightKnot>& knots, std::span<const OfBody> ofBodies);

    /// The number of a receiver among those that get anything; `none` for one that gets nothing.
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t placeOf(std::size_t receiver) const { return places_[receiver]; }
    std::size_t places() const { return receiver_.size() + reflected_; }
    std::size_t columns() const { return columns_; }
    std::size_t knots() const { return knots_; }
    /// Of a receiver, columns of the first knot first; empty where it gets nothing.
    std::span<const float> of(std::size_t receiver) const {
        const std::size_t at = places_[receiver];
        return at == none ? std::span<const float>()
                          : std::span(gathered_).subspan(at * columns_ * knots_, columns_ * knots_);
    }
    /// The same of what a sender's surface receives as a whole.
    std::span<const float> ofSender(std::size_t sender) const {
        return std::span(ofSenders_).subspan(sender * columns_ * knots_, columns_ * knots_);
    }
    /// What arrives at the places, after `bounces` or after all, of columns that senders send, by
    /// sender; by place, columns first.
    std::vector<float> arriving(const LightExchange& exchange, const LightKnot& knot,
                                const std::vector<float>& sent, std::size_t width, int bounces,
                                double error) const;

  private:
    /// Numbers receivers, and makes room for their columns.
    void number(const LightExchange& exchange, const std::vector<LightColumn>& columns);
    /// Columns that the surfaces of a body may get anything of.
    using Columns = LightExchange::Columns;
    /// By body: where bodies are apart, those of each alone; else all.
    static std::vector<Columns> columnsOfBodies(const LightExchange& exchange,
                                                std::span<const LightColumn> sent);
    std::vector<float> arriving(const LightFactors& factors, const std::vector<float>& leaving,
                                std::size_t width, std::span<const Columns> ofBodies) const;
    /// What falls on what senders stand for, as they reflect it, by sender.
    static std::vector<float> arrivingAtSenders(const LightFactors& factors,
                                                const std::vector<float>& leaving,
                                                std::size_t width,
                                                std::span<const Columns> ofBodies);
    /// Fills in what lobes reflect, at a knot.
    void takeReflected(const LightFactors& factors, const std::vector<LightColumn>& columns,
                       std::size_t knot, const std::vector<float>& leaving);
    /// What leaves senders in the end, beginning with `leaving` unless it is empty.
    static void iterate(const LightFactors& factors, const std::vector<double>& reflectivities,
                        const std::vector<float>& sent, std::size_t width,
                        std::span<const Columns> ofBodies, int bounces, double error,
                        std::vector<float>& leaving);

    std::size_t columns_, knots_;
    std::size_t sent_ = 0;              // columns that senders send, the first
    std::vector<std::size_t> places_;   // by receiver
    std::vector<std::size_t> receiver_; // by place; those that lobes reflect follow
    std::size_t reflected_ = 0;
    std::vector<float> gathered_, ofSenders_;
};

/// Solutions that were asked for lately. They know neither bands nor temperatures: steps of time
/// and edited temperatures find the last one.
class LightSolutions {
  public:
    std::shared_ptr<const LightSolution> of(const std::shared_ptr<const LightExchange>& exchange,
                                            const std::vector<LightColumn>& columns,
                                            const std::vector<LightKnot>& knots, int bounces,
                                            double error);

  private:
    struct Asked {
        std::shared_ptr<const LightExchange> exchange;
        std::vector<LightColumn> columns;
        std::vector<LightKnot> knots;
        int bounces = 0;
        double error = 0.0;
        bool operator==(const Asked&) const = default;
    };
    struct Known {
        Asked asked;
        std::shared_ptr<const LightSolution> solution;
    };
    std::shared_ptr<const LightSolution> find(RecentlyUsed<Known>& known, Asked asked);
    std::shared_ptr<const LightSolution> solved(const Asked& asked);
    RecentlyUsed<Known> known_{4}, alone_{8};
};

} // namespace irsg
