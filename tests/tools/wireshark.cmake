# The dissector, where tshark is; its fields and texts.
add_test(NAME wireshark_dissector COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/wireshark_test.sh ${Counterpoint_SOURCE_DIR})
set_tests_properties(wireshark_dissector PROPERTIES SKIP_RETURN_CODE 77 LABELS "SRS_MON_015;SRS_MON_170")
