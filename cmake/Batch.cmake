# counterpoint_batch(<target> <size>): so many files of the target are compiled at once, as one text.
#
# Most of the time in which a small file is compiled goes to the headers that it includes. Rooms with KERNEL are always compiled file by file.
# The preset clang compiles every file by itself: what only compiles behind another one is seen there.
set(COUNTERPOINT_TEST_BATCH 0 CACHE STRING "Files of a test program that are compiled at once; 0: each by itself")
set(COUNTERPOINT_HOST_BATCH 0 CACHE STRING "Files of a room without KERNEL that are compiled at once; 0: each by itself")

# What is never compiled at once with other files. Folders: programs link only some files of these rooms, and linker options lead
# their calls elsewhere; of what is compiled at once they would link all.
set(COUNTERPOINT_ALONE_FOLDERS runtime/device runtime/node verification/campaign verification/bench verification/target verification/twins verification/two_cpu verification/models)
# Files with a local name that stands in another file of their target, too, and those that replace operator new. Whoever gives a local name twice is told
# by the compiler, and renames it or adds the file here.
set(COUNTERPOINT_ALONE
  canopen/cia306/edit/new_device.cpp
  canopen/monitor/decoder.cpp
  canopen/monitor/pcap_reader.cpp
  canopen/monitor/pcapng_reader.cpp
  canopen/network_plan/expectation_maker.cpp
  canopen/network_plan/loaded_network.cpp
  canopen/network_plan/network_warnings.cpp
  canopen/network_plan/profile_maker.cpp
  hal/host/cross_link.cpp
  hal/host/live/error.cpp
  hal/host/live/socketcand/bus.cpp
  hal/host/live/udp_bus.cpp
  runtime/manager/objects.cpp
  runtime/manager/report/texts.cpp
  simulator/scenario/schema_world.cpp
  simulator/world/node/clock.cpp
  tests/canopen/cia302/flying_master/demo_test.cpp
  tests/canopen/cia302/network/network_objects_test.cpp
  tests/canopen/cia302/network/nmt_master_test.cpp
  tests/canopen/cia302/network/start_up_parts_test.cpp
  tests/canopen/cia302/network/text_dcf_test.cpp
  tests/canopen/cia302/safety_gate/gate_test.cpp
  tests/canopen/cia302/safety_gate/parallel_test.cpp
  tests/canopen/cia302/safety_gate/real_slave_test.cpp
  tests/canopen/cia306/check_srdo_test.cpp
  tests/canopen/cia306/device_types_test.cpp
  tests/canopen/cia306/signing_test.cpp
  tests/canopen/cia306/value_test.cpp
  tests/canopen/generate/text/rare_safety_test.cpp
  tests/canopen/generate/text/rare_test.cpp
  tests/canopen/monitor/network_test.cpp
  tests/canopen/monitor/recording_test.cpp
  tests/canopen/monitor/report_test.cpp
  tests/canopen/monitor/transfers_test.cpp
  tests/canopen/network_plan/warnings_test.cpp
  tests/canopen/start_up/cia302/boot_rewritten_test.cpp
  tests/canopen/start_up/cia302/boot_states_test.cpp
  tests/canopen/start_up/cia302/master_steps_test.cpp
  tests/canopen/start_up/el6751/by_hand_test.cpp
  tests/canopen/start_up/profile_rig.cpp
  tests/hal/api/output_gate_test.cpp
  tests/hal/host/allocations.cpp
  tests/hal/host/host_cross_link_test.cpp
  tests/hal/host/live_udp_bus_test.cpp
  tests/hal/host/system_calls.cpp
  tests/integration/always_good_test.cpp
  tests/integration/limit_rows_test.cpp
  tests/integration/self_test_faults_test.cpp
  tests/integration/unusual_devices_test.cpp
  tests/runtime/manager/run_test.cpp
  tests/runtime/node/identifiers_test.cpp
  tests/runtime/node/loaded_test.cpp
  tests/runtime/node/saved_node_id_test.cpp
  tests/runtime/yaml/map_test.cpp
  tests/safety_core/crosslink/acknowledge_skew_test.cpp
  tests/safety_core/crosslink/own_voice_test.cpp
  tests/safety_core/crosslink/remote_voice_test.cpp
  tests/safety_core/kernel/comparator_calls_test.cpp
  tests/safety_core/kernel/second_nmt_test.cpp
  tests/safety_core/kernel/status_test.cpp
  tests/simulator/two_cpu_scenario_test.cpp
  tests/tools/new_command_test.cpp
  tests/tools/srdo_command_test.cpp
  tools/node_command.cpp
  tools/srdo_command.cpp
  verification/proof/protocols/election_rig.cpp
  verification/proof/protocols/link_rig.cpp
  verification/proof/protocols/producer_rig.cpp
  verification/proof/world.cpp)

function(counterpoint_batch target size)
  if(size LESS 2)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  list(JOIN COUNTERPOINT_ALONE_FOLDERS "|" folders)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path ${source} ABSOLUTE)
    file(RELATIVE_PATH path ${Counterpoint_SOURCE_DIR} ${path})
    if(path MATCHES "^(${folders})/" OR path IN_LIST COUNTERPOINT_ALONE)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()
