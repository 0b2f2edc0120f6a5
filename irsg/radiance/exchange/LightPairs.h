#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace irsg {

/// What a receiver gets of others: receiver numbers of the senders, ascending, and view factors.
struct LightPair {
    std::uint32_t sender;
    float factor;
};

/// A view factor, or a part of one.
struct LightPart {
    std::uint32_t receiver, sender;
    float factor;
};

/// Puts equal pairs of a list together, in the order of receivers and senders.
void mergeParts(std::vector<LightPart>& parts);

/// Lists of pairs, one for each receiver.
class LightPairs {
  public:
    LightPairs() = default;
    /// Parts of factors that belong together are added in the order in which they come.
    LightPairs(std::size_t receivers, std::vector<std::vector<LightPart>> parts);
    /// Receivers of another list, whose senders have numbers that are higher by `addToSenders`
    /// here, or those of `numbers`; null: so many that get nothing.
    struct Block {
        const LightPairs* pairs = nullptr;
        std::size_t first = 0, count = 0;
        std::uint32_t addToSenders = 0;
        const std::vector<std::uint32_t>* numbers = nullptr; ///< ascending, by sender
    };
    /// Those of blocks, one behind the other.
    explicit LightPairs(std::span<const Block> blocks);
    /// Calls archive(list) for all lists that it is made of, to read or to write them.
    template <typename Pairs, typename Archive>
    static void visitKept(Pairs& pairs, Archive& archive) {
        archive(pairs.first_);
        archive(pairs.pairs_);
    }
    std::size_t receivers() const { return first_.empty() ? 0 : first_.size() - 1; }
    std::size_t size() const { return pairs_.size(); }
    std::pair<const LightPair*, const LightPair*> of(std::size_t receiver) const {
        return {pairs_.data() + first_[receiver], pairs_.data() + first_[receiver + 1]};
    }
    /// What arrives at a receiver of what senders send, `width` columns by receiver, of which the
    /// first `count` are wanted; of each column the pairs are added in their order.
    void gather(std::size_t receiver, std::span<const float> sent, std::size_t width,
                std::size_t count, float* arrives) const;
    /// Of all factors of a receiver: the part of its hemisphere in which others stand.
    double sumOf(std::size_t receiver) const;
    /// Puts `factorOf(receiver, pair)` in the place of each factor.
    template <typename FactorOf>
    void scale(const FactorOf& factorOf) {
        for (std::size_t r = 0; r < receivers(); ++r)
            for (std::size_t i = first_[r]; i < first_[r + 1]; ++i)
                pairs_[i].factor = factorOf(static_cast<std::uint32_t>(r), pairs_[i]);
    }
    bool isEmpty(std::size_t receiver) const { return first_[receiver] == first_[receiver + 1]; }

  private:
    std::vector<std::size_t> first_;
    std::vector<LightPair> pairs_;
};

/// Lists of as many receivers that are gathered together, all but the first times a factor each.
class WeightedPairs {
  public:
    explicit WeightedPairs(std::shared_ptr<const LightPairs> first) : first_(std::move(first)) {}
    void add(std::shared_ptr<const LightPairs> pairs, float factor) {
        if (factor != 0.0f && pairs->size() > 0)
            others_.emplace_back(std::move(pairs), factor);
    }
    /// As LightPairs.
    void gather(std::size_t receiver, std::span<const float> sent, std::size_t width,
                std::size_t count, float* arrives) const;
    bool isEmpty(std::size_t receiver) const {
        return first_->isEmpty(receiver) && std::ranges::all_of(others_, [&](const auto& other) {
                   return other.first->isEmpty(receiver);
               });
    }

  private:
    std::shared_ptr<const LightPairs> first_;
    std::vector<std::pair<std::shared_ptr<const LightPairs>, float>> others_;
};

} // namespace irsg
