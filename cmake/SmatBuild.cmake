# What every target of ours has in common: language level, warnings, sanitizers, ccache.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Build type" FORCE)
endif()

# Everything that runs lies in one place of the build tree; installed programs find their libraries
# relative to themselves.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN")

find_program(SMAT_CCACHE ccache)
if(SMAT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${SMAT_CCACHE}")
endif()

set(SMAT_SANITIZE "" CACHE STRING "Sanitizers, comma separated, for example address,undefined")
option(SMAT_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" OFF)
option(SMAT_PRECOMPILE "Precompile the Qt, OpenSceneGraph and GoogleTest headers" ON)

# Applies the house rules to one target of ours.
function(smat_configure_target target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion)
    if(SMAT_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(SMAT_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${SMAT_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=undefined)
        target_link_options(${target} PUBLIC -fsanitize=${SMAT_SANITIZE})
    endif()
    if(SMAT_PRECOMPILE AND SMAT_CCACHE)
        # ccache accepts precompiled headers only with this pair of settings.
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()

# smat_add_floor(irsg radiometry SOURCES a.cpp b.cpp DEPENDS other::target PRIVATE_DEPENDS x)
# makes the library irsg_radiometry with the alias irsg::radiometry. Includes are written from the
# top of the tree: #include "irsg/radiometry/Spectrum.h".
function(smat_add_floor house floor)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    set(name ${house}_${floor})
    add_library(${name} ${ARG_SOURCES})
    add_library(${house}::${floor} ALIAS ${name})
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
    set_target_properties(${name} PROPERTIES EXPORT_NAME ${floor}
                          VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
    smat_configure_target(${name})
endfunction()
