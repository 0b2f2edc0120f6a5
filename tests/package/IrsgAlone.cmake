# Configures irsg alone with Qt and Qwt hidden, and looks whether the build names them all the same.
file(REMOVE_RECURSE "${WORK}")
execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}" -G "${GENERATOR}"
            "-DCMAKE_CXX_COMPILER=${COMPILER}" -DSMAT_BUILD_WORKBENCH=OFF
            -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_Qwt=ON
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "irsg does not configure alone:\n${output}")
endif()
file(STRINGS "${WORK}/compile_commands.json" named REGEX "[Qq]t6|[Qq]wt")
if(named)
    message(FATAL_ERROR "the build of irsg alone names Qt: ${named}")
endif()
