# Finds Qwt for Qt 6, from version 6.3 on, and makes the target Qwt::Qwt.
#
# Looked for, in this order: the folder QWT_ROOT (cache or environment variable, with include/ and
# lib/ below it), the system's package (libqwt-qt6-dev), and what scripts/build-qwt left in the
# user's cache. Sets Qwt_FOUND and Qwt_VERSION.

if(DEFINED ENV{XDG_CACHE_HOME} AND NOT "$ENV{XDG_CACHE_HOME}" STREQUAL "")
    set(_qwt_cache "$ENV{XDG_CACHE_HOME}/smat")
else()
    set(_qwt_cache "$ENV{HOME}/.cache/smat")
endif()
file(GLOB _qwt_built "${_qwt_cache}/qwt-*")
list(SORT _qwt_built COMPARE NATURAL ORDER DESCENDING)
set(_qwt_own ${QWT_ROOT} $ENV{QWT_ROOT})

# The plain names "qwt" below the system's folders are Qwt for Qt 5, so these are never asked for.
find_path(Qwt_INCLUDE_DIR qwt_polar_plot.h HINTS ${_qwt_own}
          PATH_SUFFIXES include include/qwt NO_DEFAULT_PATH)
find_library(Qwt_LIBRARY qwt HINTS ${_qwt_own} PATH_SUFFIXES lib lib64 NO_DEFAULT_PATH)
find_library(Qwt_LIBRARY NAMES qwt-qt6 qwt6-qt6)
if(Qwt_LIBRARY)
    find_path(Qwt_INCLUDE_DIR qwt_polar_plot.h
              PATH_SUFFIXES qwt-qt6 qwt6-qt6 qt6/qwt qt6/qwt6 qwt6 qwt)
else()
    find_path(Qwt_INCLUDE_DIR qwt_polar_plot.h HINTS ${_qwt_built}
              PATH_SUFFIXES include NO_DEFAULT_PATH)
    find_library(Qwt_LIBRARY qwt HINTS ${_qwt_built} PATH_SUFFIXES lib NO_DEFAULT_PATH)
endif()
mark_as_advanced(Qwt_INCLUDE_DIR Qwt_LIBRARY)

if(Qwt_INCLUDE_DIR)
    file(STRINGS "${Qwt_INCLUDE_DIR}/qwt_global.h" _qwt_line REGEX "define QWT_VERSION_STR ")
    string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" Qwt_VERSION "${_qwt_line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qwt REQUIRED_VARS Qwt_LIBRARY Qwt_INCLUDE_DIR
                                  VERSION_VAR Qwt_VERSION)

if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
    find_package(Qt6 REQUIRED COMPONENTS Widgets Svg PrintSupport)
    add_library(Qwt::Qwt SHARED IMPORTED)
    set_target_properties(Qwt::Qwt PROPERTIES
        IMPORTED_LOCATION "${Qwt_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${Qwt_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS QWT_DLL
        INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::Svg;Qt6::PrintSupport")
endif()
