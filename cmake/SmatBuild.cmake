# What every target of ours has in common: language level, warnings, sanitizers, ccache, precompiled
# headers, installation.

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
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/smat;$ORIGIN/smat")

find_program(SMAT_CCACHE ccache)
find_program(SMAT_ENV env)
if(SMAT_CCACHE AND SMAT_ENV AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Without this sloppiness ccache refuses to serve what uses precompiled headers.
    set(sloppiness pch_defines,time_macros,include_file_mtime,include_file_ctime)
    # What the compiler keeps in memory changes no object.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${SMAT_ENV}" "CCACHE_SLOPPINESS=${sloppiness}"
                                    "CCACHE_IGNOREOPTIONS=--param=ggc-*" "${SMAT_CCACHE}")
endif()

set(SMAT_SANITIZE "" CACHE STRING "Sanitizers, comma separated, for example address,undefined")
option(SMAT_FUZZ "Build fuzz-readers for libFuzzer (needs clang)" OFF)
option(SMAT_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" OFF)
option(SMAT_PRECOMPILE "Precompile the Qt, OpenSceneGraph and GoogleTest headers" ON)

# Files that are compiled together read the headers they share once and make what templates they share
# once, which takes a third of the time of a whole build; one in which single files change is quicker
# without. What stands in an unnamed namespace then meets that of other files: a name that is taken is an
# error of the compiler.
option(SMAT_UNITY "Compile SMAT_UNITY_FILES source files at a time" OFF)
set(SMAT_UNITY_FILES 130 CACHE STRING "Source files that are compiled together, at most")

# What reads, writes, checks and shows is compiled with -Og, which takes two fifths off the time of compiling
# it. LightSources.txt lists these sources: each has been measured to take no time that a user waits for
# (benchmarks/profile_sources.py). Any other source, and so every new one, keeps the optimisation of the preset.
option(SMAT_LIGHT "Compile what cmake/LightSources.txt lists with -Og" OFF)
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/LightSources.txt" SMAT_LIGHT_SOURCES)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/LightSources.txt")
foreach(source IN LISTS SMAT_LIGHT_SOURCES)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/${source}")
        message(FATAL_ERROR "cmake/LightSources.txt: found ${source}, expected a source that exists")
    endif()
endforeach()

# smat_compile_lightly(smat_core): of a target what LightSources.txt lists. smat_compile_lightly(test_core ALL): all of it.
# What is split off stays so where everything is compiled alike: files that are compiled together are the same in
# every preset.
function(smat_compile_lightly target)
    cmake_parse_arguments(ARG "ALL" "" "" ${ARGN})
    set(light ${target})
    if(NOT ARG_ALL)
        smat_listed_lightly(${target} listed)
        if(NOT listed)
            return()
        endif()
        get_target_property(all ${target} SOURCES)
        if(NOT "${listed}" STREQUAL "${all}")
            smat_split_off(${target} light ${listed})
            set(light ${target}_light)
        endif()
    endif()
    if(SMAT_LIGHT)
        # What gcc then takes to be used uninitialised is set, on paths that it no longer follows.
        target_compile_options(${light} PRIVATE -Og $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
endfunction()

# Sets `listed` to the sources of a target that LightSources.txt lists.
function(smat_listed_lightly target listed)
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    get_target_property(all ${target} SOURCES)
    set(found "")
    foreach(source IN LISTS all)
        cmake_path(SET path NORMALIZE "${folder}/${source}")
        if(path IN_LIST SMAT_LIGHT_SOURCES)
            list(APPEND found "${source}")
        endif()
    endforeach()
    set(${listed} "${found}" PARENT_SCOPE)
endfunction()

# smat_split(irsg_atmosphere loops PATTERN...) makes of the sources that match a pattern an object library,
# irsg_atmosphere_loops, which stays a part of the target but may be compiled otherwise. A pattern that no source
# matches is an error: a file that was renamed would be compiled otherwise without a word.
function(smat_split target part)
    get_target_property(all ${target} SOURCES)
    set(own "")
    foreach(pattern ${ARGN})
        set(matching ${all})
        list(FILTER matching INCLUDE REGEX "${pattern}")
        if(NOT matching)
            message(FATAL_ERROR "no source of ${target} is left that matches ${pattern}, which is to be compiled in "
                                "${target}_${part}")
        endif()
        list(APPEND own ${matching})
    endforeach()
    list(REMOVE_DUPLICATES own)
    smat_split_off(${target} ${part} ${own})
endfunction()

# The same of sources by name.
function(smat_split_off target part)
    set(own ${ARGN})
    get_target_property(all ${target} SOURCES)
    list(REMOVE_ITEM all ${own})
    add_library(${target}_${part} OBJECT ${own})
    set_property(TARGET ${target} PROPERTY SOURCES ${all} $<TARGET_OBJECTS:${target}_${part}>)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL OBJECT_LIBRARY)
        # Who links an object library gets the objects that it compiles itself; these are given beside them.
        target_sources(${target} INTERFACE $<TARGET_OBJECTS:${target}_${part}>)
    endif()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(libraries)
        target_link_libraries(${target}_${part} PRIVATE ${libraries})
    endif()
    target_include_directories(${target}_${part} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_compile_definitions(${target}_${part} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
    smat_configure_target(${target}_${part})
endfunction()

# smat_add_rooms(smat_gui image plot): of a target the sources in these folders that are compiled lightly become object
# libraries of their own, smat_gui_image and smat_gui_plot. All others are compiled together.
function(smat_add_rooms target)
    smat_listed_lightly(${target} listed)
    get_target_property(swift ${target} SOURCES)
    list(REMOVE_ITEM swift ${listed})
    if(swift)
        smat_split_off(${target} swift ${swift})
    endif()
    foreach(room ${ARGN})
        string(REPLACE "/" "_" part "${room}")
        smat_split(${target} ${part} "^${room}/")
        smat_compile_lightly(${target}_${part})
    endforeach()
    smat_compile_lightly(${target})
endfunction()

# smat_compile_loops(irsg_radiometry PATTERN...): of a target the sources whose long loops the compiler is to make
# vectors of; of a target without patterns all sources. None of the flags changes a result; without contraction it is
# the same on processors with and without fused multiply-add. (No -fassociative-math: it would break VectorExp.h.)
function(smat_compile_loops target)
    set(loops ${target})
    if(ARGN)
        smat_split(${target} loops ${ARGN})
        set(loops ${target}_loops)
    endif()
    target_compile_options(${loops} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O3> -fno-math-errno
                                            -fno-trapping-math -ffp-contract=off)
endfunction()

# Applies the house rules to one target of ours.
function(smat_configure_target target)
    # In C++ the conversions that gcc warns of leave signs out.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion
                                             $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
    # Left to itself gcc looks for what it could free whenever 128 MB or more have doubled, which takes a tenth to a
    # seventh of its time in large units and saves up to a third of its memory; here it begins at 1.5 GB.
    target_compile_options(${target} PRIVATE
        $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=50;--param=ggc-min-heapsize=1048576>)
    get_target_property(type ${target} TYPE)
    if(type MATCHES LIBRARY)
        # No other library takes the place of functions of ours, so that gcc may inline them.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
    endif()
    if(SMAT_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${SMAT_UNITY_FILES})
        # An Impl whose members have types of its file's unnamed namespace is of that file alone.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
    if(SMAT_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
    if(SMAT_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${SMAT_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=undefined)
        target_link_options(${target} PUBLIC -fsanitize=${SMAT_SANITIZE})
        # What sanitizers add hides from gcc what is initialised.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
    if(SMAT_FUZZ)
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(SMAT_PRECOMPILE AND SMAT_CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        # The other half of what ccache asks for before it accepts precompiled headers.
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()

# smat_precompile(target gtest) precompiles the headers of one big library for a target that uses it:
# qt, osg, gtest, cli (CLI11) or core (JSON and the larger standard headers). Best where a target has
# four compilations or more; a target may ask for several. Not where files are compiled together, which
# read them too seldom. SMAT_PRECOMPILE=OFF switches all of it off.
function(smat_precompile target kind)
    get_target_property(unity ${target} UNITY_BUILD)
    if(NOT SMAT_PRECOMPILE OR unity)
        return()
    endif()
    set(qt <QtWidgets>)
    set(osg <osg/Geode> <osg/Geometry> <osg/MatrixTransform> <osg/NodeVisitor> <osgDB/ReadFile>)
    set(cli <CLI/CLI.hpp>)
    set(gtest <gmock/gmock.h> <gtest/gtest.h> <filesystem> <fstream> <string> <vector>)
    set(core <nlohmann/json.hpp> <filesystem> <functional> <map> <memory> <string> <vector>)
    if(NOT DEFINED ${kind})
        message(FATAL_ERROR "smat_precompile knows qt, osg, gtest, cli and core, but not ${kind}")
    endif()
    target_precompile_headers(${target} PRIVATE ${${kind}})
endfunction()

# smat_registry(target FILE Kinds.cpp HEADER a/Kind.h NAMESPACE smat TYPE Kind SUFFIX Analysis
#               FUNCTION "const std::vector<T>& all()" ELEMENT T AS "T(<>)" ITEMS image polar)
# writes a source that lists the objects `<item><SUFFIX>` of TYPE, which files of the target define,
# in this order, each as the expression AS. The list in CMake is the only one: what is added here is known everywhere.
function(smat_registry target)
    cmake_parse_arguments(ARG "" "FILE;HEADER;NAMESPACE;TYPE;SUFFIX;FUNCTION;ELEMENT;AS" "ITEMS" ${ARGN})
    set(names ${ARG_ITEMS})
    list(TRANSFORM names APPEND "${ARG_SUFFIX}")
    list(JOIN names ", " declared)
    set(listed "")
    foreach(name ${names})
        string(REPLACE "<>" "${name}" item "${ARG_AS}")
        list(APPEND listed "${item}")
    endforeach()
    list(JOIN listed ", " listed)
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    file(CONFIGURE OUTPUT "${ARG_FILE}" @ONLY CONTENT [[
// Made by CMake from a list in @folder@/CMakeLists.txt.
#include "@ARG_HEADER@"

namespace @ARG_NAMESPACE@ {

extern const @ARG_TYPE@ @declared@;

@ARG_FUNCTION@ {
    static const std::vector<@ARG_ELEMENT@> all = {@listed@};
    return all;
}

} // namespace @ARG_NAMESPACE@
]])
    target_sources(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${ARG_FILE}")
endfunction()

# smat_add_floor(irsg radiometry SOURCES a.cpp b.cpp DEPENDS other::target PRIVATE_DEPENDS x)
# makes the library irsg_radiometry with the alias irsg::radiometry. Includes are written from the
# top of the tree: #include "irsg/radiometry/Spectrum.h". With PACKAGED its headers are installed and
# other programs find it: find_package(irsg).
function(smat_add_floor house floor)
    cmake_parse_arguments(ARG "PACKAGED" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    set(name ${house}_${floor})
    add_library(${name} ${ARG_SOURCES})
    add_library(${house}::${floor} ALIAS ${name})
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
    target_compile_features(${name} PUBLIC cxx_std_20)
    # A copy of a template that another library compiled lightly must not take the place of this library's own.
    target_link_options(${name} PRIVATE $<$<PLATFORM_ID:Linux>:LINKER:-Bsymbolic-functions>)
    set_target_properties(${name} PROPERTIES EXPORT_NAME ${floor} SOVERSION ${PROJECT_VERSION_MAJOR})
    if(NOT DEFINED SKBUILD) # a wheel keeps no links, but a second file in place of each
        set_target_properties(${name} PROPERTIES VERSION ${PROJECT_VERSION})
    endif()
    smat_configure_target(${name})

    set_property(GLOBAL APPEND PROPERTY SMAT_FLOORS ${name})
    if(ARG_PACKAGED)
        set_property(TARGET ${name} PROPERTY SMAT_PACKAGE ${house})
        set_property(GLOBAL APPEND PROPERTY SMAT_PACKAGED_FLOORS ${name})
        install(TARGETS ${name} EXPORT ${house}Targets
                LIBRARY COMPONENT ${house} NAMELINK_COMPONENT ${house}-dev
                ARCHIVE COMPONENT ${house}-dev OBJECTS COMPONENT ${house}-dev)
        file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
        install(DIRECTORY ./ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}" COMPONENT ${house}-dev
                FILES_MATCHING PATTERN "*.h")
    else()
        set_property(TARGET ${name} PROPERTY SMAT_PACKAGE smat)
        install(TARGETS ${name} LIBRARY NAMELINK_SKIP)
    endif()
endfunction()

# smat_package(irsg FILES Find.cmake) makes the package of a house's PACKAGED floors out of
# cmake/irsgConfig.cmake.in.
function(smat_package house)
    cmake_parse_arguments(ARG "" "" "FILES" ${ARGN})
    include(CMakePackageConfigHelpers)
    set(folder "${CMAKE_INSTALL_LIBDIR}/cmake/${house}")
    install(EXPORT ${house}Targets NAMESPACE ${house}:: DESTINATION "${folder}" COMPONENT ${house}-dev)
    configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/${house}Config.cmake.in" ${house}Config.cmake
                                  INSTALL_DESTINATION "${folder}"
                                  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
    write_basic_package_version_file(${house}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${house}Config.cmake"
                  "${CMAKE_CURRENT_BINARY_DIR}/${house}ConfigVersion.cmake" ${ARG_FILES}
            DESTINATION "${folder}" COMPONENT ${house}-dev)
endfunction()
