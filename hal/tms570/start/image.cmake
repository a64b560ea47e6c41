# counterpoint_firmware(<name> SILICON <board rooms> EMULATED <board rooms> DEPENDS <device rooms> [REGIONS ...] [VARIANT <controller>])
#
# Links one program twice from the same objects of core, channels and application:
#   <name>_be32.elf  for silicon: instructions big-endian (BE32), flash at 0, RAM at 0x08000000, with the board's drivers
#   <name>.elf       for the emulator: instructions little-endian (BE8), with what SILICON is replaced by; and <name>.bin,
#                    since the emulator loads no big-endian ELF
# No library of a compiler is linked. [SRS_FW_001, SRS_FW_003, SRS_FW_021]
set(COUNTERPOINT_FIRMWARE_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/tms570.ld)

# Flash and RAM in bytes, and the powers of two that cover them for the MPU. All have flash at 0 and RAM at 0x08000000.
# hal/tms570/chip/variant.hpp has the same lengths; the image test compares. The last one: groups of the RAM in the memory test
# hardware. LS12x and LS31x: groups 6, 21, 22 (and 28), as the start-up that the vendor's code generator writes for each has
# them; LC43x: groups 29 and 30, SPNS195C table 6-33; LS20x: not known here, 0 leaves the test out. [SRS_FW_017, SRS_FW_019]
set(COUNTERPOINT_MEMORY_LS20x 0x00200000 0x00028000 0x00200000 0x00040000 0)
set(COUNTERPOINT_MEMORY_LS12x 0x00140000 0x00030000 0x00200000 0x00040000 0x00300020)
set(COUNTERPOINT_MEMORY_LS31x 0x00300000 0x00040000 0x00400000 0x00040000 0x08300020)
set(COUNTERPOINT_MEMORY_LC43x 0x00400000 0x00080000 0x00400000 0x00080000 0x30000000)
set(COUNTERPOINT_VARIANTS LS20x LS12x LS31x LC43x)
set(COUNTERPOINT_VARIANT LS31x CACHE STRING "Controller: LS20x, LS12x, LS31x or LC43x")
if(NOT COUNTERPOINT_VARIANT IN_LIST COUNTERPOINT_VARIANTS)
  message(FATAL_ERROR "COUNTERPOINT_VARIANT is '${COUNTERPOINT_VARIANT}', expected LS20x, LS12x, LS31x or LC43x")
endif()
foreach(variant IN LISTS COUNTERPOINT_VARIANTS)
  list(GET COUNTERPOINT_MEMORY_${variant} 0 flash_length)
  list(GET COUNTERPOINT_MEMORY_${variant} 1 ram_length)
  list(GET COUNTERPOINT_MEMORY_${variant} 2 flash_region)
  list(GET COUNTERPOINT_MEMORY_${variant} 3 ram_region)
  list(GET COUNTERPOINT_MEMORY_${variant} 4 ram_groups)
  set(COUNTERPOINT_FIRMWARE_${variant} flash_length=${flash_length} ram_origin=0x08000000 ram_length=${ram_length}
      region_flash_length=${flash_region} region_ram=0x08000000 region_ram_length=${ram_region} pbist_ram_groups=${ram_groups})
endforeach()
set(COUNTERPOINT_FIRMWARE_EMULATED flash_length=0x00400000 ram_origin=0x00800000 ram_length=0x00080000
    region_flash_length=0x00400000 region_ram=0x00800000 region_ram_length=0x00080000)
# Regions of the MPU and stacks; an image with more SRDOs gives greater ones by REGIONS.
set(COUNTERPOINT_FIRMWARE_REGIONS region_channel_length=0x800 region_core_length=0x400 region_non_safety_length=0x400
    stack_main_length=0xC00 stack_exception_length=0x100 stack_interrupt_length=0x200 stack_non_safety_length=0x200)

function(counterpoint_firmware name)
  cmake_parse_arguments(IMAGE "" "VARIANT" "SILICON;EMULATED;DEPENDS;REGIONS" ${ARGN})
  if(NOT IMAGE_VARIANT)
    set(IMAGE_VARIANT ${COUNTERPOINT_VARIANT})
  endif()
  foreach(order be8 be32)
    if(order STREQUAL be8)
      set(image ${name})
      set(flags -Wl,--be8)
      set(memory ${COUNTERPOINT_FIRMWARE_EMULATED})
      set(board ${IMAGE_EMULATED})
    else()
      set(image ${name}_be32)
      set(flags -mbe32)
      set(memory ${COUNTERPOINT_FIRMWARE_${IMAGE_VARIANT}})
      set(board ${IMAGE_SILICON})
      if(board)
        list(APPEND board firmware_variant_${IMAGE_VARIANT})
      endif()
    endif()
    if(NOT board)
      continue()
    endif()
    list(TRANSFORM memory PREPEND "--defsym=")
    set(regions ${COUNTERPOINT_FIRMWARE_REGIONS} ${IMAGE_REGIONS})
    list(TRANSFORM regions PREPEND "--defsym=")
    list(JOIN memory "," memory)
    list(JOIN regions "," regions)
    add_executable(${image} $<TARGET_OBJECTS:hal_tms570_vectors>)
    set_target_properties(${image} PROPERTIES SUFFIX .elf LINK_DEPENDS ${COUNTERPOINT_FIRMWARE_SCRIPT} LINKER_LANGUAGE CXX)
    target_link_libraries(${image} PRIVATE ${board} ${IMAGE_DEPENDS} hal_tms570_start hal_tms570_runtime version)
    target_link_options(${image} PRIVATE -nostdlib -nostartfiles ${flags}
        -Wl,--gc-sections,--fatal-warnings,--no-warn-execstack,-Map=$<TARGET_FILE:${image}>.map
        -Wl,-u,FirmwareVectors,-u,FirmwareMain,-u,HardwareInitialiseRam,-u,HardwareCutOff,-u,FirmwareInterrupt,-u,CounterpointVersion,${memory},${regions},-T,${COUNTERPOINT_FIRMWARE_SCRIPT})
  endforeach()
  if(NOT TARGET ${name})
    return()
  endif()
  add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_OBJCOPY} -O binary $<TARGET_FILE:${name}> $<TARGET_FILE_DIR:${name}>/${name}.bin
      BYPRODUCTS ${CMAKE_CURRENT_BINARY_DIR}/${name}.bin VERBATIM)
endfunction()
