# Tests of `counterpoint node`: orders and scripts, and devices as processes of their own in real time.
counterpoint_test(tools_node_test
  SOURCES node_attack_test.cpp node_configured_test.cpp node_emergency_test.cpp node_lost_bus_test.cpp node_order_test.cpp node_restart_test.cpp node_process.cpp node_process_test.cpp node_services_test.cpp
  DEPENDS tools_commands tests_tools canopen_cia306 hal_host simulator_judge simulator_report tests_hal
  LAUNCHER ${CMAKE_CURRENT_LIST_DIR}/live.sh)
target_compile_definitions(tools_node_test PRIVATE COUNTERPOINT_PROGRAM="$<TARGET_FILE:counterpoint>"
                           COUNTERPOINT_SOURCE="${Counterpoint_SOURCE_DIR}")
add_dependencies(tools_node_test counterpoint)
set_tests_properties(tools_node_test PROPERTIES RUN_SERIAL ON)
