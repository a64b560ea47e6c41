# counterpoint_test(<target> SOURCES ... DEPENDS <rooms> [LIBRARIES ...] [LABELS ...] [COST seconds])
#
# One GoogleTest program is one ctest entry; `./dev test` and the trace gate count the cases from its XML.
#   COST       about how long it runs: the longest begin first, so that no core waits for them at the end
find_package(GTest REQUIRED GLOBAL)

# Each test program reads GoogleTest's headers first; they are compiled once for all of them.
function(counterpoint_test_options target)
  target_link_libraries(${target} PRIVATE GTest::gtest_main)
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_compile_options(${target} PRIVATE ${COUNTERPOINT_WARNINGS} ${COUNTERPOINT_TEST_OPTIONS})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # In tests these are noise: constants that fit, constants kept for the reader, calls inside the library (see Room.cmake).
    target_compile_options(${target} PRIVATE -Wno-implicit-int-conversion -Wno-unused-const-variable
                           -Wno-deprecated-declarations)
  endif()
endfunction()

file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/gtest_precompiled.cpp CONTENT "")
add_library(gtest_precompiled STATIC EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/gtest_precompiled.cpp)
counterpoint_test_options(gtest_precompiled)
target_precompile_headers(gtest_precompiled PRIVATE <gtest/gtest.h>)

function(counterpoint_test target)
  cmake_parse_arguments(TEST "" "COST" "SOURCES;DEPENDS;LIBRARIES;LABELS" ${ARGN})
  add_executable(${target} ${TEST_SOURCES})
  target_link_libraries(${target} PRIVATE ${TEST_DEPENDS} ${TEST_LIBRARIES} verification_trace)
  counterpoint_test_options(${target})
  target_precompile_headers(${target} REUSE_FROM gtest_precompiled)
  counterpoint_batch(${target} "${COUNTERPOINT_TEST_BATCH}")
  add_test(NAME ${target} COMMAND $<TARGET_FILE:${target}>)
  set_tests_properties(${target} PROPERTIES LABELS "${TEST_LABELS}")
  if(TEST_COST)
    set_tests_properties(${target} PROPERTIES COST ${TEST_COST})
  endif()
endfunction()
