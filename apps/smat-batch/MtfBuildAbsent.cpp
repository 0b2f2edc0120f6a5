#include "apps/smat-batch/MtfCommand.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace smat::batch {

void addMtfBuildCommand(CLI::App& mtf, Context& context) {
    CLI::App* command = mtf.add_subcommand("build", "Makes a database (not in this build)");
    command->prefix_command(); // whatever its options are
    command->callback([&context] {
        context.work = []() -> int {
            throw irsg::InputError({"mtf build", "", irsg::whyNoScattering(),
                                    "a build with FFTW, SMAT_BUILD_SCATTERING=ON"});
        };
    });
}

} // namespace smat::batch
