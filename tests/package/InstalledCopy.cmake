# Installs everything into a folder of its own and looks at it: every program and library finds what it links
# below that folder or in the system's, samples, airs, guide, licences and desktop file are there, and the programs
# work on the installed samples.
#
# SOURCE and BUILD are the project's folders, WORK is a folder that is made anew, WINDOW whether smat is built.

file(REMOVE_RECURSE "${WORK}")
set(prefix "${WORK}/prefix")
function(run_step what)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status
                    OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${what} failed (${status}):\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY "${WORK}")
run_step("Installing" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

foreach(file share/doc/smat/LICENSE share/doc/smat/README.md share/smat/atmosphere)
    if(NOT EXISTS "${prefix}/${file}")
        message(FATAL_ERROR "${file} was not installed")
    endif()
endforeach()
if(WINDOW)
    foreach(file share/applications/smat.desktop share/mime/packages/smat.xml share/metainfo/smat.metainfo.xml
                 share/icons/hicolor/scalable/apps/smat.svg
                 share/smat/samples/ship/ship.smat share/smat/docs/user-guide/README.md
                 share/smat/resources/atmospheres share/smat/resources/scattering share/smat/resources/sensors)
        if(NOT EXISTS "${prefix}/${file}")
            message(FATAL_ERROR "${file} was not installed")
        endif()
    endforeach()
endif()

file(GLOB_RECURSE installed "${prefix}/bin/*" "${prefix}/lib/*.so*" "${prefix}/libexec/*")
list(LENGTH installed count)
if(count LESS 5)
    message(FATAL_ERROR "only ${count} programs and libraries were installed")
endif()
foreach(binary ${installed})
    file(READ_ELF "${binary}" RPATH rpath RUNPATH runpath CAPTURE_ERROR trouble)
    foreach(path ${rpath} ${runpath})
        if(NOT path MATCHES "^\\$ORIGIN")
            message(FATAL_ERROR "${binary} looks for libraries in ${path}")
        endif()
    endforeach()
    run_step("Linking ${binary}" ldd "${binary}")
    string(REPLACE "${prefix}" "" output "${output}")
    if(output MATCHES "not found|${BUILD}|/\\.cache/")
        message(FATAL_ERROR "${binary} links libraries of where it was built, or none:\n${output}")
    endif()
endforeach()

run_step("smat-batch" "${prefix}/bin/smat-batch" model info "${SOURCE}/samples/box/box.flt")
if(WINDOW)
    file(GLOB projects "${prefix}/share/smat/samples/*/*.smat")
    foreach(project ${projects})
        run_step("What ${project} needs" "${prefix}/bin/smat-batch" run "${project}" --dry-run)
    endforeach()
    run_step("smat-batch image" "${prefix}/bin/smat-batch" image "${prefix}/share/smat/samples/ship/ship.smat"
             --width 64 --height 48 --out ship.exr)
    run_step("smat-batch polar" "${prefix}/bin/smat-batch" polar "${prefix}/share/smat/samples/sphere/sphere.smat"
             --step 90 --out sphere.csv)
    run_step("smat plot" "${prefix}/bin/smat" plot sphere.csv -o sphere.svg)
    run_step("smat --version" "${CMAKE_COMMAND}" -E env QT_QPA_PLATFORM=offscreen "${prefix}/bin/smat" --version)
endif()

# Haze is there with the library that links FFTW (GPL), and refused by name without it; all else stays.
file(GLOB_RECURSE transforms "${prefix}/lib/*/libirsg_fftw.so" "${prefix}/lib/libirsg_fftw.so")
if(WINDOW AND transforms)
    set(hazy "${prefix}/bin/smat-batch" image "${prefix}/share/smat/samples/fog/fog.smat" --width 64 --height 48
             --out fog.csv)
    run_step("smat-batch image with haze" ${hazy})
    file(STRINGS "${WORK}/fog.csv" build REGEX "^# build:")
    file(REMOVE ${transforms})
    execute_process(COMMAND ${hazy} WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status ERROR_VARIABLE output)
    if(NOT status EQUAL 2 OR NOT output MATCHES "libirsg_fftw.so" OR NOT output MATCHES "irsg-scattering")
        message(FATAL_ERROR "without libirsg_fftw.so haze was not refused by name (${status}):\n${output}")
    endif()
    run_step("smat-batch image without FFTW" ${hazy} --set render.scattering=false)
    file(STRINGS "${WORK}/fog.csv" other REGEX "^# build:")
    if(NOT build STREQUAL other)
        message(FATAL_ERROR "whether FFTW is loaded changes the build that results name: ${build}, ${other}")
    endif()
    run_step("smat-batch selftest without FFTW" "${prefix}/bin/smat-batch" selftest --only scattering)
    if(NOT output MATCHES "1 not possible here")
        message(FATAL_ERROR "without libirsg_fftw.so the self-test says:\n${output}")
    endif()
endif()
