#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/gas/GasThroughAir.h"
#include "irsg/radiance/GasZones.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// The air before the gases of an entity.
struct AirBeforeGas {
    AtmosphericState state;
    double length_m = 0.0;
    bool operator==(const AirBeforeGas& other) const {
        return length_m == other.length_m && state.pressure_hPa == other.state.pressure_hPa &&
               state.temperature_K == other.state.temperature_K &&
               state.moleFraction == other.state.moleFraction;
    }
};

/// A gas as its material says, at a temperature; its length is 0.
GasLayer gasOf(const Material& material, double temperature_K);

/// What columns of gas send and let through on the nodes of a scene: evaluated when they are first
/// asked for, by any thread.
class GasColumnSpectra {
  public:
    /// Brings spectra to the nodes of all bands: of what counts before the air, and of the same as
    /// lines of the air change it, which bands of the source do not take.
    using Sampler =
        std::function<std::vector<double>(const Spectrum& plain, const Spectrum& throughAir)>;
    struct OfEntity {
        std::map<IrCodes, GasLayer> gases;
        std::optional<AirBeforeGas> air; ///< none: no lines of it are known
    };
    /// `range`: of all nodes.
    GasColumnSpectra(std::map<int, OfEntity> entities, const SpectralRange& range, Sampler sample);

    /// By node. What passes the air afterwards takes the second of a pair: its lines coincide with
    /// those of the gas.
    struct Values {
        std::vector<double> plain, throughAir;
    };
    struct Column {
        Values transmittance;
        std::map<IrCodes, Values>
            shares; ///< of the light, that each gas takes away: see GasColumns
    };
    const Column& of(int entity, int number) const;

  private:
    struct Known {
        std::map<IrCodes, std::size_t> numbers;
        std::unique_ptr<GasColumns> columns;
        std::unique_ptr<GasColumnsThroughAir> throughAir; ///< or null
        std::map<int, std::unique_ptr<Column>> byNumber;
    };
    std::unique_ptr<Column> make(const Known& entity, const GasColumnKey& key) const;
    Values sampled(const std::vector<double>& plain, const std::vector<double>& throughAir) const;

    std::vector<double> wavelengths_um_; ///< ascending, of wavenumbers descending
    Sampler sample_;
    mutable std::mutex mutex_;
    mutable std::map<int, Known> entities_;
};

/// Places at which the spectra of a gas have kinks, within 1 to 200 um.
const Spectrum& gasKinks();

} // namespace irsg
