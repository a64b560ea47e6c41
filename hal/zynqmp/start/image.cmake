# counterpoint_zynqmp_image(<name> [CORE 0|1] [MEMORY <word>] SOURCES ... DEPENDS <rooms> [REGIONS ...])
#   CORE     which of the two processors (0 unless told)
#   MEMORY   tcm: as on a board, code in the A-TCM and data in the B-TCM of the processor, vectors at 0;
#            emulated (unless told): the emulator's one memory, the core's part of it, vectors by way of FFFF0000h
#   REGIONS  greater regions of the MPU or stacks than the usual ones
#
# <name>.elf, without any library of a compiler. Vectors, start-up and exceptions are those of hal/zynqmp/start.
set(COUNTERPOINT_ZYNQMP_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/zynqmp.ld)
# The two directions of the link between the processors, in OCM: written by processor 0, by processor 1.
set(COUNTERPOINT_ZYNQMP_LINK image_link_0=0xFFFC0000 image_link_1=0xFFFC1000)
# A processor of a split pair: 64 KiB A-TCM at 0, 64 KiB B-TCM at 00020000h, both its own (UG1085, RPU address map).
set(COUNTERPOINT_ZYNQMP_TCM_0 code_origin=0x00000000 code_length=0x00010000 ram_origin=0x00020000 ram_length=0x00010000)
set(COUNTERPOINT_ZYNQMP_TCM_1 ${COUNTERPOINT_ZYNQMP_TCM_0})
# The emulator has RAM where a board has TCM, once for both: a part for each processor. 8 MiB of code, 8 MiB of data.
set(COUNTERPOINT_ZYNQMP_EMULATED_0 code_origin=0x01000000 code_length=0x00800000 ram_origin=0x01800000 ram_length=0x00800000)
set(COUNTERPOINT_ZYNQMP_EMULATED_1 code_origin=0x02000000 code_length=0x00800000 ram_origin=0x02800000 ram_length=0x00800000)
set(COUNTERPOINT_ZYNQMP_REGIONS region_channel_length=0x800 region_core_length=0x400 region_non_safety_length=0x400
    stack_main_length=0x2000 stack_exception_length=0x400 stack_interrupt_length=0x400 stack_non_safety_length=0x200)

function(counterpoint_zynqmp_image name)
  cmake_parse_arguments(IMAGE "" "CORE;MEMORY" "SOURCES;DEPENDS;REGIONS" ${ARGN})
  if(NOT IMAGE_CORE)
    set(IMAGE_CORE 0)
  endif()
  if(NOT IMAGE_MEMORY)
    set(IMAGE_MEMORY emulated)
  endif()
  string(TOUPPER ${IMAGE_MEMORY} memory)
  math(EXPR core_symbol "${IMAGE_CORE} + 1") # To a compiler no symbol has the address 0.
  set(symbols ${COUNTERPOINT_ZYNQMP_${memory}_${IMAGE_CORE}} ${COUNTERPOINT_ZYNQMP_LINK} ${COUNTERPOINT_ZYNQMP_REGIONS} ${IMAGE_REGIONS} image_core=${core_symbol})
  list(TRANSFORM symbols PREPEND "--defsym=")
  list(JOIN symbols "," symbols)
  if(IMAGE_MEMORY STREQUAL tcm)
    set(vectors hal_zynqmp_low_vectors)
  else()
    set(vectors target_zynqmp_vectors)
  endif()
  add_executable(${name} $<TARGET_OBJECTS:hal_zynqmp_vectors> ${IMAGE_SOURCES})
  set_target_properties(${name} PROPERTIES SUFFIX .elf LINKER_LANGUAGE CXX LINK_DEPENDS ${COUNTERPOINT_ZYNQMP_SCRIPT})
  target_link_libraries(${name} PRIVATE ${IMAGE_DEPENDS} ${vectors} hal_zynqmp_start hal_zynqmp_runtime)
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:${COUNTERPOINT_WARNINGS}> $<$<COMPILE_LANGUAGE:CXX>:${COUNTERPOINT_KERNEL_FLAGS}>)
  target_link_options(${name} PRIVATE -nostdlib -nostartfiles
      -Wl,--gc-sections,--fatal-warnings,--no-warn-execstack,-Map=$<TARGET_FILE:${name}>.map
      -Wl,-u,FirmwareVectors,-u,FirmwareMain,-u,HardwareSetVectors,-u,FirmwareInterrupt,${symbols},-T,${COUNTERPOINT_ZYNQMP_SCRIPT})
endfunction()
