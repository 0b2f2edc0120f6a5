#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace irsg {

/// Sums of the weights of the receivers of a row, of those alone that were seen: a part of a view
/// sees about one in a hundred. Receivers go by their number among those of the row.
class ReceiverSums {
  public:
    /// Without and with the cosine off axis.
    using Weights = std::array<double, 2>;
    struct Entry {
        std::uint32_t receiver;
        Weights weights;
    };

    ReceiverSums() = default;
    /// In any order, each receiver once.
    explicit ReceiverSums(std::vector<Entry> entries);

    bool isEmpty() const { return entries_.empty(); }
    /// By receiver, in their order, so that what is made of them does not depend on where a view
    /// was divided.
    const std::vector<Entry>& entries() const { return entries_; }
    void addScaled(const ReceiverSums& other, double scale);

  private:
    std::vector<Entry> entries_;
};

/// Such sums by front and row: what the light between surfaces needs of a view; it knows neither
/// wavelengths nor reflectivities.
using LightSums = std::map<std::pair<int, int>, ReceiverSums>;

/// Adds sums times a scale.
void addLight(const LightSums& light, double scale, LightSums& to);

/// Makes such sums of a row behind several fronts, a receiver at a time: all fronts see the same
/// receivers, which are looked for once.
class ReceiverSumsMaker {
  public:
    bool isEmpty() const { return receivers_.empty(); }
    /// Of one more front, the number of its sums; 0 is the first.
    std::size_t addFront();
    /// Of a receiver by front, 0 at first; valid until another receiver or front comes.
    ReceiverSums::Weights* of(std::uint32_t receiver) {
        if (2 * receivers_.size() >= places_.size())
            grow();
        std::size_t place = placeOf(receiver);
        for (; places_[place] != none; place = (place + 1) & (places_.size() - 1))
            if (receivers_[places_[place]] == receiver)
                return &weights_[places_[place] * width_];
        places_[place] = static_cast<std::uint32_t>(receivers_.size());
        receivers_.push_back(receiver);
        weights_.resize(weights_.size() + width_);
        return &weights_[weights_.size() - width_];
    }
    /// What was added behind a front; receivers without any are left out.
    ReceiverSums sumsOf(std::size_t front) const;

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// Neighbours lie in the same places of mesh and list: they are spread by Knuth's
    /// multiplicative hash (The Art of Computer Programming 3, 6.4).
    std::size_t placeOf(std::uint32_t receiver) const {
        return static_cast<std::size_t>(receiver * 2654435769u >> shift_);
    }
    void grow();

    std::vector<std::uint32_t> receivers_;
    std::vector<ReceiverSums::Weights> weights_; ///< by receiver and front
    std::size_t fronts_ = 0, width_ = 1;         ///< that there are, and that there is room for
    std::vector<std::uint32_t> places_; ///< of receivers, as many as a power of two; linear probing
    int shift_ = 32;                    ///< leaves as many bits as places have
};

} // namespace irsg
