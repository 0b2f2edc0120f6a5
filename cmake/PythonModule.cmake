# Whether the Python module smat is built. It needs the headers of Python and pybind11 2.13, of which Debian 12 has
# 2.10: scripts/test makes an environment with it (scripts/python-environment). Without them the build goes on without
# the module.

set(SMAT_BUILD_PYTHON AUTO CACHE STRING "Build the Python module smat: ON, OFF, or AUTO where pybind11 2.13 is found")
set_property(CACHE SMAT_BUILD_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(SMAT_PYTHON_ENVIRONMENT "$ENV{HOME}/.cache/smat/python" CACHE PATH
    "Virtual environment that is searched for Python and pybind11")
set(smat_has_python OFF)
if(NOT SMAT_BUILD_PYTHON STREQUAL OFF)
    if(NOT DEFINED Python_EXECUTABLE AND EXISTS "${SMAT_PYTHON_ENVIRONMENT}/bin/python")
        set(Python_EXECUTABLE "${SMAT_PYTHON_ENVIRONMENT}/bin/python" CACHE FILEPATH "Python of the module smat")
    endif()
    set(PYBIND11_FINDPYTHON NEW)
    find_package(Python 3.9 COMPONENTS Interpreter Development.Module QUIET)
    if(Python_Interpreter_FOUND AND Python_Development.Module_FOUND)
        execute_process(COMMAND "${Python_EXECUTABLE}" -m pybind11 --cmakedir OUTPUT_VARIABLE pybind11_ROOT
                        OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        find_package(pybind11 2.13 CONFIG QUIET)
        set(smat_has_python "${pybind11_FOUND}")
    endif()
    if(SMAT_BUILD_PYTHON STREQUAL ON AND NOT smat_has_python)
        message(FATAL_ERROR "SMAT_BUILD_PYTHON=ON needs the headers of Python (package python3-dev) and pybind11 2.13 "
                            "or later: pip install pybind11, and -DPython_EXECUTABLE=ENVIRONMENT/bin/python")
    endif()
endif()
