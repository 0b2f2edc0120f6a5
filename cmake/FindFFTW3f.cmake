# Finds FFTW 3 in single precision with its threads, and makes the target FFTW3::fftw3f.
#
# Debian's libfftw3-dev brings no CMake package. The hook for other people's threads came with
# version 3.3.9, which is looked for by its name in the header.

find_path(FFTW3f_INCLUDE_DIR fftw3.h)
find_library(FFTW3f_LIBRARY fftw3f)
find_library(FFTW3f_THREADS_LIBRARY fftw3f_threads)
mark_as_advanced(FFTW3f_INCLUDE_DIR FFTW3f_LIBRARY FFTW3f_THREADS_LIBRARY)

set(FFTW3f_THREADS_HOOK "")
if(FFTW3f_INCLUDE_DIR)
    file(STRINGS "${FFTW3f_INCLUDE_DIR}/fftw3.h" FFTW3f_THREADS_HOOK REGEX "threads_set_callback")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFTW3f
    REQUIRED_VARS FFTW3f_LIBRARY FFTW3f_THREADS_LIBRARY FFTW3f_INCLUDE_DIR FFTW3f_THREADS_HOOK
    REASON_FAILURE_MESSAGE
        "Install libfftw3-dev (3.3.9 or later), or configure with -D SMAT_BUILD_SCATTERING=OFF.")

if(FFTW3f_FOUND AND NOT TARGET FFTW3::fftw3f)
    add_library(FFTW3::fftw3f UNKNOWN IMPORTED)
    set_target_properties(FFTW3::fftw3f PROPERTIES
        IMPORTED_LOCATION "${FFTW3f_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${FFTW3f_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${FFTW3f_THREADS_LIBRARY}")
endif()
