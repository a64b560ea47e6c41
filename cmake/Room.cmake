# One CMake target a room, so that the target graph is the architecture.
#
# A room sees only itself and the rooms it names in DEPENDS: every room stages a link to its own folder under
# <build>/include/<room>/, and only the staged folders of the named rooms are on its include path. An include that the
# architecture forbids therefore does not compile; verification/gates proves it with fixtures.

set(COUNTERPOINT_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wcast-qual
    -Wold-style-cast -Woverloaded-virtual -Wnon-virtual-dtor -Wundef -Wswitch-enum -Wdouble-promotion
    -Wformat=2 -Wnull-dereference)
if(COUNTERPOINT_WERROR)
  list(APPEND COUNTERPOINT_WARNINGS -Werror)
endif()
# Tests are not measured; a preset may have them compiled in less time than the rooms that they test.
set(COUNTERPOINT_TEST_OPTIONS "" CACHE STRING "Options of test programs alone, after those of everything")
# Debug information of rooms that are no part of a device takes a third of their compile time; a preset may ask for less.
set(COUNTERPOINT_HOST_OPTIONS "" CACHE STRING "Options of rooms without KERNEL alone, after those of everything")
include(${CMAKE_CURRENT_LIST_DIR}/Batch.cmake)
# What a kernel object may not contain: exceptions, RTTI, guards of static locals, calls of a hosted library.
set(COUNTERPOINT_KERNEL_FLAGS -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-stack-protector
    -fno-asynchronous-unwind-tables -fno-common -ffunction-sections -fdata-sections)

# counterpoint_room(<target> [KERNEL] [CLANG] [INTERFACE] [MADE] SOURCES ... DEPENDS ...)
#   KERNEL     freestanding flags of the certified part
#   CLANG      compiled by Clang even where the rest is compiled by GCC (diversity of channel B)
#   INTERFACE  headers only
#   MADE       its headers are made in the build, in <build>/include/<room>/<room>, instead of standing in its folder
function(counterpoint_room target)
  cmake_parse_arguments(ROOM "KERNEL;CLANG;INTERFACE;MADE" "" "SOURCES;DEPENDS" ${ARGN})
  file(RELATIVE_PATH room_path ${Counterpoint_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set(stage ${Counterpoint_BINARY_DIR}/include/${target})
  get_filename_component(stage_parent ${stage}/${room_path} DIRECTORY)
  file(MAKE_DIRECTORY ${stage_parent})
  if(NOT ROOM_MADE)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${stage}/${room_path} SYMBOLIC)
  endif()
  if(ROOM_INTERFACE)
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${stage}>)
    target_link_libraries(${target} INTERFACE ${ROOM_DEPENDS})
    target_compile_features(${target} INTERFACE cxx_std_17)
  else()
    add_library(${target} STATIC ${ROOM_SOURCES})
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${stage}>)
    target_link_libraries(${target} PUBLIC ${ROOM_DEPENDS})
    target_compile_features(${target} PUBLIC cxx_std_17)
    target_compile_options(${target} PRIVATE ${COUNTERPOINT_WARNINGS})
    if(ROOM_KERNEL)
      target_compile_options(${target} PRIVATE ${COUNTERPOINT_KERNEL_FLAGS})
    else()
      # std::stable_sort of GCC 12's library uses what it itself marks as deprecated, and Clang tells.
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations> ${COUNTERPOINT_HOST_OPTIONS})
      counterpoint_batch(${target} "${COUNTERPOINT_HOST_BATCH}")
    endif()
    if(ROOM_CLANG AND COUNTERPOINT_CHANNEL_B_COMPILER)
      # The launcher is handed the whole command line of the main compiler and puts Clang in its first place.
      set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
        "${Counterpoint_SOURCE_DIR}/cmake/compile_with;${COUNTERPOINT_CHANNEL_B_COMPILER}")
      # Only Clang sees these (a cross build sets them): its name of the target, its way to the headers.
      target_compile_options(${target} PRIVATE ${COUNTERPOINT_CHANNEL_B_FLAGS})
    else()
      target_compile_options(${target} PRIVATE ${COUNTERPOINT_MAIN_FLAGS})
    endif()
  endif()
  add_library(Counterpoint::${target} ALIAS ${target})
  if(NOT Counterpoint_IS_TOP_LEVEL)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endif()
endfunction()
