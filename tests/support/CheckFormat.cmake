# Fails where clang-format would change a C++ file.
#   CLANG_FORMAT  the program, or NOTFOUND
#   SOURCES       the repository's root

# Versions differ in what they decide; this is Debian 12's.
set(VERSION 14)
if(CLANG_FORMAT)
    execute_process(COMMAND "${CLANG_FORMAT}" --version OUTPUT_VARIABLE found_version)
endif()
if(NOT found_version MATCHES "version ${VERSION}\\.")
    message("Skipped: clang-format ${VERSION} is missing")
    return()
endif()

foreach(folder osgWaterReflect applications tests)
    file(GLOB_RECURSE found "${SOURCES}/${folder}/*.cpp" "${SOURCES}/${folder}/*.h")
    list(APPEND files ${found})
endforeach()
# Public headers have no extension.
file(GLOB headers "${SOURCES}/osgWaterReflect/*")
foreach(header IN LISTS headers)
    get_filename_component(extension "${header}" EXT)
    if(NOT extension AND NOT IS_DIRECTORY "${header}")
        list(APPEND files "${header}")
    endif()
endforeach()

execute_process(COMMAND "${CLANG_FORMAT}" --dry-run -Werror --style=file ${files}
    RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "clang-format would change the files named above")
endif()
