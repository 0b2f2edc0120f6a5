#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/ScaledView.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/radiance/exchange/SceneLight.h"

namespace irsg {

/// The inputs that scale a drawn row; -1 for none.
struct ScaledRow {
    int temperatureInput = -1, emissivityInput = -1;
};

/// How light between the surfaces of a view changes with the scales of its signature databases.
///
/// A receiver's reflectivity times what falls on it, from each sender's emission and from what each
/// reflects first: products of both are taken as they are. What is reflected on the way changes
/// what falls on receivers to the first order in each reflectivity (LightResponse). Nodes of a band
/// are put together in bins of wavelengths that are a part of 0.025 wide, with means over each;
/// since it is a difference from the scales of 1, that error is of the second order: 1e-5 of the
/// change. The nodes of a spectrum stand alone.
class ScaledLight {
  public:
    /// Of nodes `first` to before `last`; `rows` by drawn row, `ranges_m` by entity. With `only`
    /// what falls on that entity alone is counted.
    ScaledLight(const ViewGeometry& view, const SceneRadiometry& radiometry,
                const SurfaceRadianceTable& radiances, SceneLight& light,
                const std::vector<ScaledRow>& rows, const std::vector<double>& ranges_m,
                std::pair<std::size_t, std::size_t> nodes, std::size_t inputs, bool isSpectrum,
                std::optional<int> only = {});

    /// What the scales add to values at scales of 1.
    void addTo(std::span<const double> scales, ScaledValues& values) const;

  private:
    /// Two sums: of intensity and of irradiance.
    using Pair = std::array<double, 2>;
    /// Rows that reflect alike, those of one input, or all that have none.
    struct Receivers {
        int input = -1;
        std::vector<double> emissivity, absorbedAtMost; ///< by bin; reflectivity is the difference
        std::vector<Pair> constant; ///< by bin: what no scale of a sender changes
    };
    struct Sender {
        ScaledRow inputs;
        bool isComponent = false;   ///< of a mirror: takes what it reflects of its emission
        double temperature_K = 0.0; ///< 0: a spectrum of its own
        std::vector<double> wavelength_um, emissivity, absorbedAtMost; ///< by bin
    };
    /// What receivers get of a sender, bin by bin: of its emission at scales of 1, of what it
    /// reflects first at a reflectivity of 1, and, until it is closed, more of what it reflects on
    /// the way at a reflectivity of 1 more than at scales of 1.
    struct Share {
        std::size_t receivers = 0, sender = 0;
        std::vector<Pair> emitted, perReflectivity, perChange;
    };
    struct Making;
    void makeBins(Making& making);
    void gather(Making& making, int stack, int row, const ReceiverSums& sums);
    void close(Making& making);
    void evaluate(std::span<const double> scales, std::vector<Pair>& byBin) const;

    bool isSpectrum_;
    std::size_t bins_ = 0;
    std::vector<Receivers> receivers_;
    std::vector<Sender> senders_;
    std::vector<Share> shares_;
    std::vector<std::size_t> binOf_; // by node; of a spectrum, the output
    std::vector<Pair> atOne_;        // by bin
};

} // namespace irsg
