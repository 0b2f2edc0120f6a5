# cmake -DLIBRARY=... -DFORBIDDEN=regex -P Links.cmake: fails where ldd of LIBRARY names a match.
execute_process(COMMAND ldd "${LIBRARY}" OUTPUT_VARIABLE links RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "ldd cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "(${FORBIDDEN})[^ ]*" found "${links}")
if(found)
    message(FATAL_ERROR "${LIBRARY} links ${found}")
endif()
