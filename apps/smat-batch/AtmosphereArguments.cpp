#include "apps/smat-batch/AtmosphereArguments.h"

#include "smatcore/project/EnvironmentInput.h"

namespace smat::batch {

AtmosphereArguments::AtmosphereArguments(CLI::App& command) {
    command
        .add_option("ATMOSPHERE", inputs_,
                    "Atmosphere or Environment file, or none; of several, the first that provides "
                    "the quantity over the band is used")
        ->required()
        ->type_name("");
}

std::optional<irsg::SunPosition>
AtmosphereArguments::addTo(irsg::Environment& environment,
                           std::optional<int> resolution_per_cm) const {
    return addAtmosphere(environment, {inputs_.begin(), inputs_.end()}, resolution_per_cm);
}

} // namespace smat::batch
