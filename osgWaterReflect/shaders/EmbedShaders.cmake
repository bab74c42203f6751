# Shader files compiled into a program, as a C++ map of text by file name, whatever folder it is in.
#
#   embed_shaders(output map header files...)
#
#     output  the C++ file to write
#     map     its name, qualified: a const std::map<std::string, std::string>
#     header  what declares it, as the C++ file includes it
#
# Run as a script, this file writes that C++ file.
function(embed_shaders output map header)
    add_custom_command(
        OUTPUT "${output}"
        COMMAND ${CMAKE_COMMAND} "-DSOURCES=${ARGN}" "-DOUTPUT=${output}" "-DMAP=${map}"
                "-DHEADER=${header}" -P "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
        DEPENDS ${ARGN} "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
        COMMENT "Embedding the shaders of ${map}"
        VERBATIM)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
    set(content "// Written by shaders/EmbedShaders.cmake from shader files.\n")
    string(APPEND content "#include \"${HEADER}\"\n\n")
    string(APPEND content "const std::map<std::string, std::string> ${MAP} = {\n")
    foreach(source IN LISTS SOURCES)
        get_filename_component(name "${source}" NAME)
        list(FIND names "${name}" index)
        if(NOT index EQUAL -1)
            message(FATAL_ERROR "embed_shaders: expected one file ${name}, got two")
        endif()
        list(APPEND names "${name}")
        file(READ "${source}" text)
        string(APPEND content "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
    endforeach()
    string(APPEND content "};\n")
    file(WRITE "${OUTPUT}" "${content}")
endif()
