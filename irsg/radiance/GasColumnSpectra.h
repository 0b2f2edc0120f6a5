#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"
#include "irsg/radiance/GasZones.h"
#include "irsg/radiometry/AxisToNodes.h"
#include "irsg/radiometry/SpectralSampling.h"
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

/// The gases of an entity on some wavenumbers.
class GasesOnWavenumbers;

/// What columns of gas send and let through on the nodes of a scene: evaluated when they are first
/// asked for, by any thread. What of it depends on neither nodes nor air is shared by all of them.
class GasColumnSpectra {
  public:
    /// The nodes of a band. Those of a source take the gas before the air, others as lines of the
    /// air change it.
    struct Nodes {
        std::shared_ptr<const SpectralSampling> sampling;
        bool hasAir = true;
    };
    struct OfEntity {
        std::map<IrCodes, GasLayer> gases;
        std::optional<AirBeforeGas> air; ///< none: no lines of it are known
    };
    /// `range`: of all nodes.
    GasColumnSpectra(const std::map<int, OfEntity>& entities, const SpectralRange& range,
                     std::vector<Nodes> bands);

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
        std::shared_ptr<GasesOnWavenumbers> gases;
        std::vector<double> air; ///< transmittance, line by line; empty: none is known
        std::map<int, std::unique_ptr<Column>> byNumber;
    };
    std::unique_ptr<Column> make(const Known& entity, int number) const;
    Values sampled(const std::vector<double>& plain, const std::vector<double>& throughAir) const;

    std::vector<double> wavelengths_um_; ///< ascending, of wavenumbers descending
    std::vector<Nodes> bands_;
    std::vector<std::shared_ptr<const AxisToNodes>> toNodes_; ///< by band; null: sampled() of it
    mutable std::mutex mutex_;
    mutable std::map<int, Known> entities_;
};

/// Places at which the spectra of a gas have kinks, within 1 to 200 um.
const Spectrum& gasKinks();

} // namespace irsg
