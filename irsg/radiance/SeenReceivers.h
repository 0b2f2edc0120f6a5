#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/radiance/exchange/LightExchange.h"
#include "irsg/radiance/exchange/ReceiverSums.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Sums over samples of the receivers of light at the places that are seen, by kind: a row behind a
/// front. Behind gas a place is seen behind many fronts at once, of which its receivers are looked
/// for once; else samples that follow each other in one triangle are joined.
class SeenReceivers {
  public:
    /// `exchange` must live as long; null where nothing will be added.
    explicit SeenReceivers(const LightExchange* exchange) : exchange_(exchange) {}

    /// Of a kind, by a number of the caller's, of a row: what a sample counts without and with the
    /// cosine off axis at a place of that row's surface.
    void add(std::size_t kind, std::size_t row, double plain, double cosine,
             const GeometrySamples::Place& at) {
        if (at_.cell != at.cell || at_.u != at.u || at_.v != at.v) {
            endPlace();
            at_ = at;
        }
        if (kind >= kinds_.size())
            kinds_.resize(kind + 1);
        Kind& own = kinds_[kind];
        if (own.row == none)
            make(own, row);
        rowHere(static_cast<std::size_t>(own.row)).push_back({own.front, plain, cosine});
        ++countHere_;
    }

    /// By number of kinds, empty for those of which nothing was seen. Nothing is left.
    std::vector<ReceiverSums> take();

  private:
    static constexpr std::int32_t none = -1;
    /// Kinds that see a place up to which samples of a triangle are joined.
    static constexpr std::size_t mostRuns = 4;

    /// Where its sums are: of which row, and of which front there.
    struct Kind {
        std::int32_t row = none;
        std::size_t front = 0;
    };
    struct Seen {
        std::size_t front = 0;
        double plain = 0.0, cosine = 0.0;
    };
    /// Few: a place lies between two slices, and has some lobes.
    struct RowHere {
        std::size_t row = 0;
        std::vector<Seen> all;
    };
    /// Samples in one triangle, by the weights of its corners.
    struct Run {
        std::size_t row = 0, front = 0;
        std::array<double, 3> plain{}, cosine{};
    };
    struct PartOf {
        std::uint32_t receiver;
        double part;
    };

    void make(Kind& kind, std::size_t row);
    std::vector<Seen>& rowHere(std::size_t row) {
        std::size_t number = 0;
        while (number < rowsHere_ && here_[number].row != row)
            ++number;
        if (number == rowsHere_) {
            if (++rowsHere_ > here_.size())
                here_.emplace_back();
            here_[number].row = row;
        }
        return here_[number].all;
    }
    void endPlace();
    void addToRuns();
    Run& runOf(std::size_t row, std::size_t front);
    void endRuns();
    void addAtOnce();

    const LightExchange* exchange_;
    std::vector<Kind> kinds_;
    std::vector<std::int32_t> numbers_; // by row: place in the next
    std::vector<ReceiverSumsMaker> rows_;

    GeometrySamples::Place at_; // of the present sample
    std::vector<RowHere> here_;
    std::size_t rowsHere_ = 0, countHere_ = 0; // of these, and in all of them
    std::vector<PartOf> parts_;
    std::uint32_t cell_ = GeometrySamples::Place::none; // of the runs
    std::vector<Run> runs_;
};

} // namespace irsg
