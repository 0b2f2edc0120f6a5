#include "apps/smat-batch/MtfCommand.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace smat::batch {

void addMtfBuildCommand(CLI::App& mtf, Context&) {
    CLI::App* command = mtf.add_subcommand("build", "Makes a database (not in this build)");
    // Before its options are looked at, of which it knows none here.
    command->preparse_callback([](std::size_t) {
        throw CLI::ValidationError("mtf build", irsg::whyNoScattering() +
                                                    ", expected a build with FFTW, "
                                                    "SMAT_BUILD_SCATTERING=ON");
    });
}

} // namespace smat::batch
