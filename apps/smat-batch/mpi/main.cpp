// smat-batch-mpi: the sweeps of smat-batch, Monte Carlo over them and the frames of scenarios,
// drawn by all ranks of an MPI job.
#include <fmt/format.h>
#include <mpi.h>

#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/Program.h"
#include "apps/smat-batch/mpi/MpiTeam.h"

namespace {

void addCommands(CLI::App& app, smat::batch::Context& context) {
    smat::batch::addSweepCommands(app, context);
    smat::batch::addMonteCarloCommand(app, context);
    smat::batch::addSimulateCommand(app, context);
}

int run(int argc, char** argv, smat::batch::MpiTeam& team) {
    smat::batch::Context context;
    context.team = &team;
    if (!team.isLeader())
        context.speaker = fmt::format("rank {}: ", team.rank());
    return smat::batch::runProgram({"smat-batch-mpi",
                                    "Runs sweeps of smat-batch on all ranks of an MPI job: mpirun "
                                    "-n 4 smat-batch-mpi table PROJECT --out FILE.",
                                    addCommands},
                                   argc, argv, context);
}

} // namespace

int main(int argc, char** argv) {
    // Only one thread of a process speaks MPI at a time.
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    if (provided < MPI_THREAD_SERIALIZED) {
        smat::batch::tell("error: MPI: found no support for threads, expected "
                          "MPI_THREAD_SERIALIZED\n");
        MPI_Abort(MPI_COMM_WORLD, smat::batch::refused);
    }
    int exitCode = smat::batch::ourFault;
    {
        smat::batch::MpiTeam team;
        exitCode = run(argc, argv, team);
    }
    // The others wait for cases or messages of one that will never come.
    if (exitCode != smat::batch::done)
        MPI_Abort(MPI_COMM_WORLD, exitCode);
    MPI_Finalize();
    return exitCode;
}
