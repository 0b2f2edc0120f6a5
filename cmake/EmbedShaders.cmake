# smat_embed_shaders(irsg_scene FILES surface.vert.glsl surface.frag.glsl)
# puts the texts of shaders/*.glsl into the library, so that it needs no file when it runs; they are
# asked for by file name through irsg/render/opengl/ShaderSource.h. A shader that changes is embedded anew by
# the next build.

set(SMAT_EMBED_SHADERS_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")

function(smat_embed_shaders target)
    cmake_parse_arguments(ARG "" "" "FILES" ${ARGN})
    list(TRANSFORM ARG_FILES PREPEND "${PROJECT_SOURCE_DIR}/shaders/" OUTPUT_VARIABLE paths)
    set(generated "${CMAKE_CURRENT_BINARY_DIR}/EmbeddedShaders.cpp")
    add_custom_command(
        OUTPUT "${generated}"
        COMMAND "${CMAKE_COMMAND}" "-DFILES=${paths}" "-DOUTPUT=${generated}"
                -P "${SMAT_EMBED_SHADERS_SCRIPT}"
        DEPENDS ${paths} "${SMAT_EMBED_SHADERS_SCRIPT}"
        COMMENT "Embedding shaders"
        VERBATIM)
    target_sources(${target} PRIVATE "${generated}")
endfunction()

# Run as a script: writes the source file.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    set(entries "")
    foreach(path IN LISTS FILES)
        get_filename_component(name "${path}" NAME)
        file(READ "${path}" text)
        string(APPEND entries "    {\"${name}\", R\"GLSL(${text})GLSL\"},\n")
    endforeach()
    file(WRITE "${OUTPUT}"
"#include \"irsg/render/opengl/ShaderSource.h\"

namespace irsg {

const std::map<std::string, std::string>& embeddedShaders() {
    static const std::map<std::string, std::string> shaders{
${entries}    };
    return shaders;
}

} // namespace irsg
")
endif()
