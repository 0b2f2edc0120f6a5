#include "apps/smat-batch/AirInput.h"

#include "smatcore/project/EnvironmentInput.h"

namespace smat::batch {

AirInput::AirInput(CLI::App& command) {
    command
        .add_option("ATMOSPHERE", inputs_,
                    "Atmosphere or Environment file, or none; of several the first that has the "
                    "asked quantity in the band answers")
        ->required()
        ->type_name("");
}

std::optional<irsg::SunPosition> AirInput::addTo(irsg::Environment& environment,
                                                 std::optional<int> resolution_per_cm) const {
    return addAir(environment, {inputs_.begin(), inputs_.end()}, resolution_per_cm);
}

} // namespace smat::batch
