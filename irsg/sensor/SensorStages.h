#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/sensor/SensorDescription.h"
#include "irsg/sensor/SensorTransfer.h"

namespace irsg {

/// The chain of a sensor in the order in which light becomes counts.
enum class SensorStage {
    optics,     ///< diffraction, defocus, aberration
    detector,   ///< active area, time constant
    motion,     ///< jitter, drift
    electronics ///< sampling, noise, counts; has no transfer function
};
inline constexpr std::array sensorStages = {SensorStage::optics, SensorStage::detector,
                                            SensorStage::motion, SensorStage::electronics};

/// The components of SensorTransfer that belong to a stage, in their order.
std::vector<SensorTransfer::Component>
componentsOf(SensorStage stage, const std::vector<SensorTransfer::Component>& components);

/// A piece of a scene in front of the sensor: `samples` x `samples` cells a pixel, row by row.
struct StageScene {
    std::size_t columns_px = 0, rows_px = 0; ///< at least 1
    int samples = 1;                         ///< at least 1
    std::vector<float> radiance_W_m2_sr;     ///< in the sensor's band
};

/// What is left of a scene behind each stage.
struct StagePictures {
    /// The scene, then behind optics, detector and motion: radiance in the cells of the scene. The
    /// detector's is what it would read with its pixel centred on each cell.
    std::array<std::vector<float>, 4> radiance_W_m2_sr;
    std::vector<float> counts; ///< behind the electronics, a value a pixel
    std::size_t saturated = 0; ///< pixels at the end of the well or of the converter
};

/// Blurs by the components of SensorTransfer, stage by stage; beyond the piece its outermost cells
/// go on. Counts are those of a SensorChain of so many pixels, of the first frame of `seed`.
/// `source_K` as of SensorTransfer. Throws InputError for a sensor that cannot be and LogicError
/// for another number of cells.
StagePictures stagePictures(const SensorDescription& sensor, const StageScene& scene,
                            double source_K = 300.0, std::uint64_t seed = 1);

} // namespace irsg
