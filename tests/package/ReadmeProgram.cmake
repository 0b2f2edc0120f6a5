# Does what irsg/README.md tells its reader, with exactly the code that stands there: installs irsg
# into a folder of its own, builds the program against it with find_package, and runs it on the
# sample sphere.
#
# SOURCE and BUILD are the project's folders, WORK is a folder that is made anew.

function(run_step what)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status
                    OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${what} failed (${status}):\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

# Writes the only block of a language in the README to a file.
function(extract_block language file)
    file(READ "${SOURCE}/irsg/README.md" text)
    string(FIND "${text}" "```${language}\n" start)
    if(start EQUAL -1)
        message(FATAL_ERROR "irsg/README.md has no block of ${language}")
    endif()
    string(LENGTH "```${language}\n" fence)
    math(EXPR start "${start} + ${fence}")
    string(SUBSTRING "${text}" ${start} -1 text)
    string(FIND "${text}" "```" end)
    string(SUBSTRING "${text}" 0 ${end} text)
    file(WRITE "${WORK}/${file}" "${text}")
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
extract_block(cpp sphere.cpp)
extract_block(cmake CMakeLists.txt)

run_step("Installing" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix" --component irsg)
run_step("Configuring" "${CMAKE_COMMAND}" -S . -B build -G "${GENERATOR}"
         "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${CONFIGURATION}"
         "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run_step("Building" "${CMAKE_COMMAND}" --build build)
run_step("Running" ./build/sphere "${SOURCE}/samples/sphere/sphere.flt"
         "${SOURCE}/samples/sphere/sphere.sigdb")

# The closed form of a grey sphere, 0.9 times the band radiance of 320 K in 3 to 5 um, and pi r^2 times
# that less what facets and raster cost.
message(STATUS "${output}")
if(NOT output MATCHES "centre pixel 3\\.3252[456789][0-9]* W m-2 sr-1, intensity 10\\.4[345][0-9]* W sr-1")
    message(FATAL_ERROR "expected: centre pixel 3.32525 W m-2 sr-1, intensity 10.4466 W sr-1")
endif()
if(NOT EXISTS "${WORK}/sphere.exr")
    message(FATAL_ERROR "the program wrote no sphere.exr")
endif()
