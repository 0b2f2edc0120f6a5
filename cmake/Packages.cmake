# Debian packages of what is installed: cpack -G DEB in a build folder, or scripts/make-packages. The components of
# install() become irsg (libraries, tables of the atmosphere), irsg-scattering (the Fourier transforms of haze, GPL),
# irsg-dev and smat-dev (headers, find_package), smat (programs, window, samples, with Qwt where Debian has none), smat-mpi
# (smat-batch-mpi) and python3-smat, for the Python that it was built with.

if(DEFINED SKBUILD)
    return() # a wheel
endif()
set(CPACK_PACKAGE_VENDOR "SMAT")
set(SMAT_PACKAGE_CONTACT "SMAT maintainers <maintainers@example.org>" CACHE STRING "Who makes the packages")
set(CPACK_PACKAGE_CONTACT "${SMAT_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_COMPONENTS_ALL irsg irsg-dev)
if(TARGET irsg_fftw)
    list(APPEND CPACK_COMPONENTS_ALL irsg-scattering)
endif()
if(SMAT_BUILD_WORKBENCH)
    list(APPEND CPACK_COMPONENTS_ALL smat smat-dev)
    if(TARGET smat-batch-mpi)
        list(APPEND CPACK_COMPONENTS_ALL smat-mpi)
    endif()
    if(smat_has_python)
        list(APPEND CPACK_COMPONENTS_ALL python)
    endif()
endif()

# smat_describe_package(COMPONENT NAME "Summary" "Text" OTHER_COMPONENT...)
macro(smat_describe_package component name summary text)
    string(TOUPPER "${component}" upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${text}")
    set(CPACK_COMPONENT_${upper}_DEPENDS ${ARGN})
    # Debian wants both of every package.
    if("${component}" IN_LIST CPACK_COMPONENTS_ALL)
        install(FILES "${PROJECT_SOURCE_DIR}/resources/packages/copyright" DESTINATION share/doc/${name} COMPONENT ${component})
        install(FILES "${PROJECT_BINARY_DIR}/changelog.gz" DESTINATION share/doc/${name} COMPONENT ${component})
        # What lintian warns of for a reason.
        if(EXISTS "${PROJECT_SOURCE_DIR}/resources/packages/lintian/${name}")
            install(FILES "${PROJECT_SOURCE_DIR}/resources/packages/lintian/${name}" DESTINATION share/lintian/overrides
                    COMPONENT ${component})
        endif()
    endif()
endmacro()

# smat_compress(FROM TO): as Debian wants it, without name and time.
find_program(SMAT_GZIP gzip REQUIRED)
function(smat_compress from to)
    execute_process(COMMAND "${SMAT_GZIP}" -9nc "${from}" OUTPUT_FILE "${to}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
# The changes themselves are in CHANGELOG.md. SOURCE_DATE_EPOCH sets the day.
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/changelog" @ONLY CONTENT [[
smat (@PROJECT_VERSION@) unstable; urgency=medium

  * The changes are in /usr/share/doc/smat/CHANGELOG.md.

 -- @SMAT_PACKAGE_CONTACT@  @day@
]])
smat_compress("${PROJECT_BINARY_DIR}/changelog" "${PROJECT_BINARY_DIR}/changelog.gz")
foreach(program smat smat-batch smat-batch-mpi)
    if(TARGET ${program})
        smat_compress("${PROJECT_SOURCE_DIR}/resources/packages/man/${program}.1" "${PROJECT_BINARY_DIR}/${program}.1.gz")
        set(component smat)
        if(program STREQUAL smat-batch-mpi)
            set(component smat-mpi)
        endif()
        install(FILES "${PROJECT_BINARY_DIR}/${program}.1.gz" DESTINATION share/man/man1 COMPONENT ${component})
    endif()
endforeach()
smat_describe_package(irsg irsg "Infrared scene generator, libraries"
    " Images in physical units, radiant intensity and spectra\n of models with infrared codes.")
smat_describe_package(irsg-scattering irsg-scattering "Infrared scene generator, scattering in haze"
    " Fourier transforms by FFTW, under the GPL.\n Without this package irsg and smat are free of that licence and refuse haze." irsg)
smat_describe_package(irsg-dev irsg-dev "Infrared scene generator, headers"
    " Headers and find_package(irsg) for programs that render infrared scenes." irsg)
smat_describe_package(smat smat "Infrared signature modelling workbench"
    " The window smat, the command line smat-batch, and samples to start from." irsg)
smat_describe_package(smat-mpi smat-mpi "Infrared signature modelling, sweeps on many machines"
    " The command line smat-batch-mpi, for jobs of MPI." smat)
smat_describe_package(smat-dev smat-dev "Infrared signature modelling, headers"
    " Headers and find_package(smat) for programs that run analyses of projects." smat irsg-dev)
smat_describe_package(python python3-smat "Infrared signatures from Python"
    " Projects, analyses and scenes as NumPy arrays." smat)
# Libraries are new to the loader. Which package has one: CPack would list those twice that are built for two processors.
get_property(floors GLOBAL PROPERTY SMAT_FLOORS)
foreach(package irsg smat)
    set(lines "")
    foreach(floor IN LISTS floors)
        get_property(owner TARGET ${floor} PROPERTY SMAT_PACKAGE)
        if(owner STREQUAL package)
            string(APPEND lines "lib$<TARGET_FILE_BASE_NAME:${floor}> ${PROJECT_VERSION_MAJOR} ${package} (= ${PROJECT_VERSION})\n")
        endif()
    endforeach()
    file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/packages/${package}/shlibs" CONTENT "${lines}")
    string(TOUPPER "${package}" upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA
        "${PROJECT_SOURCE_DIR}/resources/packages/triggers;${PROJECT_BINARY_DIR}/packages/${package}/shlibs")
endforeach()
# What is opened at run time alone.
set(CPACK_DEBIAN_IRSG_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_IRSG_PACKAGE_SUGGESTS "irsg-scattering")
set(CPACK_DEBIAN_SMAT_PACKAGE_SUGGESTS "irsg-scattering, smat-mpi, python3-smat")
if(smat_has_python)
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_IRSG-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_SMAT-DEV_PACKAGE_SECTION libdevel)
include(CPack)
