#include "irsg/radiance/SeenReceivers.h"

#include <algorithm>

namespace irsg {

namespace {

std::array<double, 3> cornersOf(const GeometrySamples::Place& at) {
    const auto u = static_cast<double>(at.u), v = static_cast<double>(at.v);
    return {1.0 - u - v, u, v};
}

} // namespace

std::vector<ReceiverSums> SeenReceivers::take() {
    endPlace();
    endRuns();
    std::vector<ReceiverSums> all(kinds_.size());
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind)
        if (kinds_[kind].row != none)
            all[kind] =
                rows_[static_cast<std::size_t>(kinds_[kind].row)].sumsOf(kinds_[kind].front);
    kinds_.clear();
    numbers_.clear();
    rows_.clear();
    return all;
}

void SeenReceivers::make(Kind& kind, std::size_t row) {
    if (row >= numbers_.size())
        numbers_.resize(row + 1, none);
    std::int32_t& number = numbers_[row];
    if (number == none) {
        number = static_cast<std::int32_t>(rows_.size());
        rows_.emplace_back();
    }
    kind.row = number;
    kind.front = rows_[static_cast<std::size_t>(number)].addFront();
}

void SeenReceivers::endPlace() {
    if (countHere_ == 0)
        return;
    if (countHere_ <= mostRuns)
        addToRuns();
    else
        addAtOnce();
    for (std::size_t number = 0; number < rowsHere_; ++number)
        here_[number].all.clear();
    rowsHere_ = countHere_ = 0;
}

void SeenReceivers::addToRuns() {
    if (cell_ != at_.cell) {
        endRuns();
        cell_ = at_.cell;
    }
    const std::array<double, 3> corners = cornersOf(at_);
    for (std::size_t number = 0; number < rowsHere_; ++number)
        for (const Seen& one : here_[number].all) {
            Run& run = runOf(here_[number].row, one.front);
            for (std::size_t c = 0; c < corners.size(); ++c) {
                run.plain[c] += one.plain * corners[c];
                run.cosine[c] += one.cosine * corners[c];
            }
        }
}

SeenReceivers::Run& SeenReceivers::runOf(std::size_t row, std::size_t front) {
    for (Run& run : runs_)
        if (run.row == row && run.front == front)
            return run;
    return runs_.emplace_back(Run{row, front, {}, {}});
}

void SeenReceivers::endRuns() {
    if (!runs_.empty())
        exchange_->forEachReceiver(
            cell_, [&](std::uint32_t receiver, std::size_t corner, float part) {
                const std::uint32_t local = exchange_->localOf(receiver);
                for (const Run& run : runs_) {
                    ReceiverSums::Weights& own = rows_[run.row].of(local)[run.front];
                    own[0] += run.plain[corner] * static_cast<double>(part);
                    own[1] += run.cosine[corner] * static_cast<double>(part);
                }
            });
    runs_.clear();
    cell_ = GeometrySamples::Place::none;
}

void SeenReceivers::addAtOnce() {
    const std::array<double, 3> corners = cornersOf(at_);
    parts_.clear();
    exchange_->forEachReceiver(
        at_.cell, [&](std::uint32_t receiver, std::size_t corner, float part) {
            const std::uint32_t local = exchange_->localOf(receiver);
            const double own = corners[corner] * static_cast<double>(part);
            const auto known = std::ranges::find(parts_, local, &PartOf::receiver);
            if (known != parts_.end())
                known->part += own;
            else
                parts_.push_back({local, own});
        });
    for (std::size_t number = 0; number < rowsHere_; ++number) {
        ReceiverSumsMaker& sums = rows_[here_[number].row];
        for (const PartOf& one : parts_) {
            ReceiverSums::Weights* const own = sums.of(one.receiver);
            for (const Seen& seen : here_[number].all) {
                own[seen.front][0] += seen.plain * one.part;
                own[seen.front][1] += seen.cosine * one.part;
            }
        }
    }
}

} // namespace irsg
