#include "irsg/core/ParallelFor.h"
#include "irsg/core/ProgramVersion.h"
#include "python/src/Bindings.h"

PYBIND11_MODULE(_core, module) {
    using namespace smat::python;
    module.doc() = "Classes and functions of SMAT; use the module smat, which offers them.";
    module.attr("__version__") = irsg::programVersion();
    addErrors(module);
    addRadiometry(module);
    addImages(module);
    addTables(module);
    addAtmospheres(module);
    addModels(module);
    addSignatures(module);
    addScenes(module);
    addProjects(module);

    module.def(
        "set_threads",
        [](int threads) {
            if (threads < 0 || threads > 1024)
                throw badArgument("threads", std::to_string(threads),
                                  "a whole number from 1 to 1024, or 0 for all cores");
            irsg::setMostThreads(static_cast<unsigned>(threads));
        },
        py::arg("threads"), R"(Limit the threads that one computation uses.

Results do not depend on it.

Parameters
----------
threads : int
    1 to 1024; 0 for as many as the machine has cores.

Raises
------
InputError
    For another number.
)");
}
