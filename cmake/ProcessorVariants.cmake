# Processors of the level x86-64-v3 (AVX2; most of Intel since 2013, of AMD since 2015) may have a library of their own,
# which glibc's loader takes in place of the plain one: lib/glibc-hwcaps/x86-64-v3/libirsg_radiance.so.0 beside
# lib/libirsg_radiance.so.0.

option(SMAT_PROCESSOR_VARIANTS
       "Build the hottest libraries for x86-64-v3, too (x86-64 with glibc 2.33, shared libraries)" OFF)

if(SMAT_PROCESSOR_VARIANTS)
    include(CheckCXXSourceCompiles)
    set(CMAKE_REQUIRED_FLAGS -march=x86-64-v3)
    check_cxx_source_compiles("#include <features.h>
#if !defined __x86_64__ || !defined __GLIBC_PREREQ
#error
#elif !__GLIBC_PREREQ(2, 33)
#error
#endif
int main() {}" SMAT_LOADER_CHOOSES_VARIANTS)
    unset(CMAKE_REQUIRED_FLAGS)
    if(NOT SMAT_LOADER_CHOOSES_VARIANTS OR NOT BUILD_SHARED_LIBS)
        message(STATUS "SMAT_PROCESSOR_VARIANTS: no library is built for x86-64-v3, which asks for shared libraries, "
                       "x86-64 and glibc 2.33")
        set(SMAT_PROCESSOR_VARIANTS OFF)
    endif()
endif()

# smat_add_processor_variant(irsg_radiance COMPONENT irsg) builds the sources of a library for x86-64-v3, too; those that
# it compiles lightly are shared. It is called after all that says what the library is made of and how. Without
# contraction, results are equal to the last bit. Who links the library links the plain one; a program knows the name
# that both have and loads one of them.
function(smat_add_processor_variant target)
    cmake_parse_arguments(ARG "" "COMPONENT" "" ${ARGN})
    if(NOT SMAT_PROCESSOR_VARIANTS)
        return()
    endif()
    set(variant ${target}_v3)
    set(folder glibc-hwcaps/x86-64-v3)
    get_target_property(sources ${target} SOURCES)
    add_library(${variant} SHARED ${sources})
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(libraries)
        target_link_libraries(${variant} PRIVATE ${libraries})
    endif()
    foreach(property INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS LINK_OPTIONS)
        set_property(TARGET ${variant} PROPERTY ${property} $<TARGET_PROPERTY:${target},${property}>)
    endforeach()
    foreach(property SOVERSION UNITY_BUILD UNITY_BUILD_BATCH_SIZE)
        get_target_property(value ${target} ${property})
        if(NOT value MATCHES "NOTFOUND$")
            set_property(TARGET ${variant} PROPERTY ${property} ${value})
        endif()
    endforeach()
    target_compile_options(${variant} PRIVATE -march=x86-64-v3 -ffp-contract=off)
    set_target_properties(${variant} PROPERTIES
        OUTPUT_NAME ${target} LIBRARY_OUTPUT_DIRECTORY "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${folder}"
        INSTALL_RPATH "$ORIGIN/../..")
    # One that is older than the plain library would take its place.
    add_dependencies(${target} ${variant})
    install(TARGETS ${variant} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/${folder}" NAMELINK_SKIP
            COMPONENT ${ARG_COMPONENT})
endfunction()
