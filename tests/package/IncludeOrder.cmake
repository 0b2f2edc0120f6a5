# cmake -DSOURCE=... -DWORK=... -DPYTHON=... -P IncludeOrder.cmake: no folder includes what lies above it, and the script
# that says so sees an include that goes up, one of OpenSceneGraph, a header that leads there and a folder that it does
# not know.
set(script "${SOURCE}/scripts/include-order.py")
foreach(one "irsg/radiometry/Band.h;irsg/core/Errors.h;0;." "irsg/core/Errors.h;irsg/radiometry/Band.h;1;lies above"
            "irsg/radiance/Term.h;osg/Node;1;does without" "irsg/render/rays/Term.cpp;osg/Node;1;does without"
            "irsg/geometry/model/Term.h;osg/Node;1;leads to" "irsg/geometry/model/Term.cpp;osg/Node;0;."
            "irsg/geometry/conversion/Term.h;osg/Node;0;." "irsg/attic/Box.h;irsg/core/Errors.h;1;no place")
    list(GET one 0 file)
    list(GET one 1 included)
    list(GET one 2 expected)
    list(GET one 3 word)
    file(REMOVE_RECURSE "${WORK}")
    if(included MATCHES "^osg")
        file(WRITE "${WORK}/${file}" "#include <${included}>\n")
    else()
        file(WRITE "${WORK}/${file}" "#include \"${included}\"\n")
    endif()
    execute_process(COMMAND "${PYTHON}" "${script}" "${WORK}" RESULT_VARIABLE status OUTPUT_VARIABLE output
                    ERROR_VARIABLE output)
    if(NOT status EQUAL expected OR (NOT word STREQUAL "." AND NOT output MATCHES "${word}"))
        message(FATAL_ERROR "${file} with ${included}: ${status}, ${expected} expected, with \"${word}\":\n${output}")
    endif()
endforeach()

execute_process(COMMAND "${PYTHON}" "${script}" "${SOURCE}" RESULT_VARIABLE status OUTPUT_VARIABLE output
                ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
endif()
