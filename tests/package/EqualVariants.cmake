# The libraries that are built for processors of x86-64-v3, too, give what the plain ones give, to the last byte: a polar
# with inter-reflection, rays and OpenGL, an image, a Monte Carlo. Passed over on a processor without them. For the preset
# release, which has no tests, by hand:
#     cmake -DSOURCE=. -DBUILD=build/release -DWORK=build/release/variants -P tests/package/EqualVariants.cmake
#
# SOURCE and BUILD are the project's folders, WORK is a folder that is made anew.

cmake_minimum_required(VERSION 3.25)
foreach(folder SOURCE BUILD WORK)
    get_filename_component(${folder} "${${folder}}" ABSOLUTE)
endforeach()
set(program "${BUILD}/bin/smat-batch")
set(plain_only GLIBC_TUNABLES=glibc.cpu.hwcaps=-MOVBE)

function(run_step what)
    execute_process(COMMAND "${CMAKE_COMMAND}" -E env ${ARGN} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status
                    OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${what} failed (${status}):\n${output}${errors}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run_step("Asking the loader" /lib64/ld-linux-x86-64.so.2 --help)
if(NOT output MATCHES "x86-64-v3 \\(supported")
    message(STATUS "This processor is below x86-64-v3: nothing to compare.")
    return()
endif()

# Which libraries are there, and which of them are loaded.
set(folder "${BUILD}/lib/glibc-hwcaps/x86-64-v3")
file(GLOB variants RELATIVE "${folder}" "${folder}/lib*.so.*")
if(NOT variants)
    message(FATAL_ERROR "found no library in ${folder}, expected those of SMAT_PROCESSOR_VARIANTS")
endif()
foreach(choice own plain)
    if(choice STREQUAL plain)
        set(environment ${plain_only})
    endif()
    run_step("Listing libraries" LD_TRACE_LOADED_OBJECTS=1 ${environment} "${program}")
    foreach(library IN LISTS variants)
        string(REGEX MATCHALL "[^\n]*=> [^\n]*/${library} " loaded "${output}")
        list(LENGTH loaded count)
        if(NOT count EQUAL 1)
            message(FATAL_ERROR "${library} is loaded ${count} times, expected once:\n${output}")
        endif()
        if((choice STREQUAL own AND NOT loaded MATCHES "glibc-hwcaps") OR
           (choice STREQUAL plain AND loaded MATCHES "glibc-hwcaps"))
            message(FATAL_ERROR "found ${loaded}, expected the ${choice} one")
        endif()
    endforeach()

    file(MAKE_DIRECTORY "${WORK}/${choice}")
    set(samples "${SOURCE}/samples")
    foreach(command "polar;${samples}/turboprop4/turboprop4.smat;--step;60;--steps;fixed;--out;polar.csv"
                    "polar;${samples}/corvette/corvette.smat;--step;120;--steps;fixed;--out;rays.csv;--set;render.engine=rays"
                    "image;${samples}/turboprop4/turboprop4.smat;--width;160;--height;120;--out;image.csv"
                    "montecarlo;${samples}/turboprop4/turboprop4.smat;--analysis=polar;--samples=16;--set;polar.step=90;--set;polar.steps=fixed;--out;draws.csv")
        run_step("smat-batch ${command}" "SMAT_CACHE=${WORK}/${choice}/cache" ${environment}
                 "${CMAKE_COMMAND}" -E chdir "${WORK}/${choice}" "${program}" ${command})
    endforeach()
endforeach()

file(GLOB written RELATIVE "${WORK}/own" "${WORK}/own/*.csv")
list(LENGTH written count)
if(count LESS 4)
    message(FATAL_ERROR "found ${written}, expected four results at least")
endif()
foreach(file IN LISTS written)
    file(STRINGS "${WORK}/own/${file}" own)
    file(STRINGS "${WORK}/plain/${file}" plain)
    # What says when and how long is no result.
    foreach(choice own plain)
        list(FILTER ${choice} EXCLUDE REGEX "^#")
    endforeach()
    if(NOT own STREQUAL plain)
        message(FATAL_ERROR "${file} differs between the libraries for x86-64-v3 and the plain ones")
    endif()
endforeach()
message(STATUS "${written}: equal")
