# Finds the active Emscripten, an activated emsdk (EMSDK) before a system package, and includes its
# toolchain file.
if(NOT EMSCRIPTEN_ROOT_PATH)
  find_program(SEAMWISE_EM_CONFIG em-config HINTS $ENV{EMSDK}/upstream/emscripten)
  if(NOT SEAMWISE_EM_CONFIG)
    message(FATAL_ERROR "Emscripten is missing: install the package 'emscripten' or activate an emsdk")
  endif()
  execute_process(COMMAND ${SEAMWISE_EM_CONFIG} EMSCRIPTEN_ROOT
                  OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES EMSCRIPTEN_ROOT_PATH)

# Full paths keep the build's compiler independent of a later shell's PATH.
get_filename_component(tools "${SEAMWISE_EM_CONFIG}" DIRECTORY)
foreach(pair "C_COMPILER emcc" "CXX_COMPILER em++" "AR emar" "RANLIB emranlib")
  string(REPLACE " " ";" pair "${pair}")
  list(GET pair 0 variable)
  list(GET pair 1 tool)
  if(EXISTS ${tools}/${tool})
    set(CMAKE_${variable} ${tools}/${tool} CACHE FILEPATH "Emscripten ${tool}")
  endif()
endforeach()

include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
