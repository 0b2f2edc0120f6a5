# Does what a README tells its reader, with exactly the code that stands there: installs the packages
# into a folder of their own, builds the program against them with find_package, runs it on a sample, and
# holds what it prints against what is known.
#
# SOURCE and BUILD are the project's folders, WORK is a folder that is made anew. README is
# "irsg/README.md", "smatcore/README.md" or "docs/embedding.md".

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
    file(READ "${SOURCE}/${README}" text)
    string(FIND "${text}" "```${language}\n" start)
    if(start EQUAL -1)
        message(FATAL_ERROR "${README} has no block of ${language}")
    endif()
    string(LENGTH "```${language}\n" fence)
    math(EXPR start "${start} + ${fence}")
    string(SUBSTRING "${text}" ${start} -1 text)
    string(FIND "${text}" "```" end)
    string(SUBSTRING "${text}" 0 ${end} text)
    file(WRITE "${WORK}/${file}" "${text}")
endfunction()

if(README STREQUAL "irsg/README.md")
    set(packages irsg)
    set(program sphere)
    set(arguments "${SOURCE}/samples/sphere/sphere.flt" "${SOURCE}/samples/sphere/sphere.sigdb")
elseif(README STREQUAL "docs/embedding.md")
    set(packages irsg)
    set(program embedding)
    set(arguments "${SOURCE}/samples/box/box.flt" "${SOURCE}/samples/box/box.sigdb")
else()
    set(packages irsg smat)
    set(program frame)
    set(arguments "${SOURCE}/samples/flyby/flyby.json")
endif()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
extract_block(cpp ${program}.cpp)
extract_block(cmake CMakeLists.txt)

foreach(package ${packages})
    foreach(component ${package} ${package}-dev)
        run_step("Installing" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix" --component ${component})
    endforeach()
endforeach()
run_step("Configuring" "${CMAKE_COMMAND}" -S . -B build -G "${GENERATOR}"
         "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${CONFIGURATION}"
         "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run_step("Building" "${CMAKE_COMMAND}" --build build)
run_step("Running" ./build/${program} ${arguments})
message(STATUS "${output}")

if(README STREQUAL "irsg/README.md")
    # The closed form of a grey sphere, 0.9 times the band radiance of 320 K in 3 to 5 um, and pi r^2 times
    # that less what facets and raster cost.
    if(NOT output MATCHES "centre pixel 3\\.3252[456789][0-9]* W m-2 sr-1, intensity 10\\.4[345][0-9]* W sr-1")
        message(FATAL_ERROR "expected: centre pixel 3.32525 W m-2 sr-1, intensity 10.4466 W sr-1")
    endif()
    if(NOT EXISTS "${WORK}/sphere.exr")
        message(FATAL_ERROR "the program wrote no sphere.exr")
    endif()
elseif(README STREQUAL "docs/embedding.md")
    # Area times Planck's radiance of nose, starboard, tail and port, each 1 or 2 m nearer than the
    # centre is at 500 m.
    foreach(row "0,3\\.7[567]" "90,27\\.2" "180,7\\.4[345]" "270,4(6\\.9|7\\.0)")
        if(NOT output MATCHES "\n${row}")
            message(FATAL_ERROR "expected a row like ${row}:\n${output}")
        endif()
    endforeach()
    if(NOT EXISTS "${WORK}/image.exr")
        message(FATAL_ERROR "the program wrote no image.exr")
    endif()
else()
    # What the program that we ship writes of the same frame.
    string(REGEX MATCH "^[^ ]+" printed "${output}")
    run_step("Simulating" "${BUILD}/bin/smat-batch" simulate ${arguments} --sensor mwir --from 5 --to 5
             --out "${WORK}/out")
    file(READ "${WORK}/out/mwir.csv" table)
    string(FIND "${table}" ",${printed}," found)
    if(found EQUAL -1)
        message(FATAL_ERROR "smat-batch simulate gives other numbers than ${printed}:\n${table}")
    endif()
endif()
