#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/radiance/GasZones.h"
#include "irsg/radiance/exchange/LightPairs.h"
#include "irsg/radiance/exchange/LightThrough.h"

namespace irsg {

/// What gas changes of the light between surfaces: along some columns of it, one of each entity in
/// order from the receiver, behind some panes. With t the transmittances of all of these, panes
/// first, it takes t_panes (1 - t_gas) of what comes from behind, and sends what its columns emit.
struct LightThroughGas {
    std::vector<std::size_t> panes, columns; ///< numbers of LightExchange::panes
    LightBalance balance;                    ///< of receivers and senders behind the gas
    std::vector<OutsideLight> leaving;       ///< by receiver: sky and ground behind it
    std::vector<double> sky, ground;         ///< by sender, likewise
    /// Parts of the hemisphere in which the columns emit, by receiver and by sender; empty where
    /// others have it.
    std::vector<float> emitting, emittingToSenders;
};

/// A line of sight through the gas of an entity, from the receiver.
struct GasOnRay {
    std::vector<GasColumnKey::Stretch> stretches;
    double weight = 0.0;
};

/// A few columns that stand for many: each for those near it, with the mean of their lengths, so
/// that what is thin is right on the whole.
class FewGasColumns {
  public:
    FewGasColumns(const std::vector<GasOnRay>& rays, std::size_t most);
    const std::vector<GasColumnKey>& columns() const { return columns_; }
    /// By ray.
    std::size_t columnOf(std::size_t ray) const { return columnOf_[ray]; }

  private:
    std::vector<GasColumnKey> columns_;
    std::vector<std::size_t> columnOf_;
};

} // namespace irsg
