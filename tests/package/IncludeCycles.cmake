# cmake -DSOURCE=... -DWORK=... -DPYTHON=... -P IncludeCycles.cmake: no more than three rooms include each other, and
# the script that says so sees a ring of four, one link of which is in a source that does a part of its room.
set(script "${SOURCE}/scripts/include-cycles.py")
file(REMOVE_RECURSE "${WORK}")
foreach(link "Air;Body" "Body;Case" "Case;Draw")
    list(GET link 0 room)
    list(GET link 1 included)
    file(WRITE "${WORK}/gui/${room}.h" "#include \"gui/${included}.h\"\n")
endforeach()
file(WRITE "${WORK}/gui/Draw.h" "#pragma once\n")
foreach(ring "Body;3" "Air;4")
    list(GET ring 0 included)
    list(GET ring 1 rooms)
    file(WRITE "${WORK}/gui/DrawParts.cpp" "#include \"gui/${included}.h\"\n")
    execute_process(COMMAND "${PYTHON}" "${script}" "${WORK}" RESULT_VARIABLE status OUTPUT_VARIABLE output
                    ERROR_VARIABLE output)
    if(rooms EQUAL 3 AND NOT status EQUAL 0)
        message(FATAL_ERROR "a ring of three rooms is refused:\n${output}")
    endif()
    if(rooms EQUAL 4 AND (status EQUAL 0 OR NOT output MATCHES "4 rooms include each other.*DrawParts.cpp:1"))
        message(FATAL_ERROR "a ring of four rooms is not found:\n${output}")
    endif()
endforeach()

execute_process(COMMAND "${PYTHON}" "${script}" "${SOURCE}" RESULT_VARIABLE status OUTPUT_VARIABLE output
                ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
endif()
