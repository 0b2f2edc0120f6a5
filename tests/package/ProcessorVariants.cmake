# Builds two libraries and a program by cmake/ProcessorVariants.cmake and holds what the program says against what the
# processor can, in the build tree and installed elsewhere: of each library the variant is loaded, or all are plain where the
# loader is told that the processor lacks something. The variant is made anew with the plain library.
#
# SOURCE is the project's folder, WORK one that is made anew, COMPILER and GENERATOR are the project's.

function(run_step what)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status
                    OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${what} failed (${status}):\n${output}${errors}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect program expected)
    run_step("Running ${program}" "${CMAKE_COMMAND}" -E env ${ARGN} "${program}")
    if(NOT output STREQUAL expected)
        message(FATAL_ERROR "${program} with '${ARGN}': found ${output}, expected ${expected}")
    endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
file(WRITE "${WORK}/CMakeLists.txt" [=[
cmake_minimum_required(VERSION 3.25)
project(variants LANGUAGES CXX)
set(BUILD_SHARED_LIBS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
include(GNUInstallDirs)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN")
include(${SOURCE}/cmake/ProcessorVariants.cmake)
add_library(lightly OBJECT lightly.cpp)
add_library(lower lower.cpp $<TARGET_OBJECTS:lightly>)
add_library(upper upper.cpp)
target_link_libraries(upper PRIVATE lower)
target_compile_definitions(upper PRIVATE FACTOR=10)
add_executable(program program.cpp)
target_link_libraries(program PRIVATE upper)
set_target_properties(lower upper PROPERTIES VERSION 2.1 SOVERSION 2)
install(TARGETS lower upper program COMPONENT all)
smat_add_processor_variant(lower COMPONENT all)
smat_add_processor_variant(upper COMPONENT all)
file(CONFIGURE OUTPUT made.cmake CONTENT "set(VARIANTS ${SMAT_PROCESSOR_VARIANTS})")
]=])
set(level "
#ifdef __AVX2__
constexpr int level = 3;
#else
constexpr int level = 1;
#endif
")
file(WRITE "${WORK}/lightly.cpp" "${level} int lightly() { return level; }")
file(WRITE "${WORK}/lower.cpp" "${level} int lightly(); int calls = 0; int lower() { ++calls; return 10 * lightly() + level; }")
file(WRITE "${WORK}/upper.cpp" "${level} extern int calls; int lower(); int below() { return lower(); } int count() { return calls; }
int upper() { return FACTOR * lower() + level; }")
file(WRITE "${WORK}/program.cpp" [=[
#include <cstdio>
int upper();
int below();
int count();
int main() {
    const int one = upper(), other = below();
    std::printf("%d %d %d", one, other, count());
}
]=])

run_step("Configuring" "${CMAKE_COMMAND}" -S . -B build -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
         -DCMAKE_BUILD_TYPE=Release -DSMAT_PROCESSOR_VARIANTS=ON "-DSOURCE=${SOURCE}")
run_step("Building" "${CMAKE_COMMAND}" --build build --target program)
include("${WORK}/build/made.cmake")

# What the loader itself says that it searches.
file(GLOB loader /lib64/ld-linux-x86-64.so.2)
set(plain "111 11 2")
set(own "${plain}")
if(VARIANTS)
    run_step("Asking the loader" "${loader}" --help)
    if(output MATCHES "x86-64-v3 \\(supported")
        set(own "133 13 2")
    endif()
endif()
message(STATUS "expected: ${own}, plain: ${plain}")

run_step("Installing" "${CMAKE_COMMAND}" --install build --prefix "${WORK}/there" --component all)
file(RENAME "${WORK}/build" "${WORK}/moved")
expect("${WORK}/there/bin/program" "${own}")
expect("${WORK}/there/bin/program" "${plain}" GLIBC_TUNABLES=glibc.cpu.hwcaps=-MOVBE)
file(RENAME "${WORK}/moved" "${WORK}/build")
expect("${WORK}/build/bin/program" "${own}")
expect("${WORK}/build/bin/program" "${plain}" GLIBC_TUNABLES=glibc.cpu.hwcaps=-MOVBE)

# A change of a source reaches the variant when the program is built again.
file(WRITE "${WORK}/lower.cpp" "${level} int calls = 0; int lower() { ++calls; return 20 + level; }")
run_step("Building again" "${CMAKE_COMMAND}" --build build --target program)
if(own STREQUAL plain)
    set(changed "211 21 2")
else()
    set(changed "233 23 2")
endif()
expect("${WORK}/build/bin/program" "${changed}")
