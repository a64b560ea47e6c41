# counterpoint_test(<target> SOURCES ... DEPENDS <rooms> [LIBRARIES ...] [LABELS ...] [TIMEOUT seconds] [LAUNCHER script])
#
# One GoogleTest program is one ctest entry; `./dev test` and the trace gate count the cases from its XML.
find_package(GTest REQUIRED GLOBAL)

function(counterpoint_test target)
  cmake_parse_arguments(TEST "" "TIMEOUT;LAUNCHER" "SOURCES;DEPENDS;LIBRARIES;LABELS" ${ARGN})
  add_executable(${target} ${TEST_SOURCES})
  target_link_libraries(${target} PRIVATE ${TEST_DEPENDS} ${TEST_LIBRARIES} verification_trace GTest::gtest_main)
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_compile_options(${target} PRIVATE ${COUNTERPOINT_WARNINGS} ${COUNTERPOINT_TEST_OPTIONS})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # In tests these are noise: constants that fit, constants kept for the reader, calls inside the library (see Room.cmake).
    target_compile_options(${target} PRIVATE -Wno-implicit-int-conversion -Wno-unused-const-variable
                           -Wno-deprecated-declarations)
  endif()
  add_test(NAME ${target} COMMAND ${TEST_LAUNCHER} $<TARGET_FILE:${target}>)
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  set_tests_properties(${target} PROPERTIES TIMEOUT ${TEST_TIMEOUT} LABELS "${TEST_LABELS}")
endfunction()
