# counterpoint_image(<name> [NO_SILICON] [KEEP_ALL] SOURCES ... DEPENDS <rooms>)
#   NO_SILICON  only for the emulator
#   KEEP_ALL    functions that nothing calls stay: the stack is computed for them, too
#
# Links one program twice from the same objects: <name>.elf with little-endian instructions (BE8) for the emulator, plus
# <name>.bin, since the emulator loads no big-endian ELF; and <name>_be32.elf with the order of a TMS570. No library of the
# compiler is linked. Vectors, start-up and exceptions are the object of the firmware (hal/tms570/start/start_up.S).
set(COUNTERPOINT_EMULATOR_MEMORY --defsym=target_rom_length=0x00800000 --defsym=target_ram_origin=0x00800000
    --defsym=target_ram_length=0x00800000 --defsym=target_stack_length=0x00010000)
# TMS570LS3137: 3 MB flash at 0, 256 KB RAM.
set(COUNTERPOINT_SILICON_MEMORY --defsym=target_rom_length=0x00300000 --defsym=target_ram_origin=0x08000000
    --defsym=target_ram_length=0x00040000 --defsym=target_stack_length=0x00002000)
set(COUNTERPOINT_LINKER_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/target.ld)

function(counterpoint_image name)
  cmake_parse_arguments(IMAGE "NO_SILICON;KEEP_ALL" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name}_objects OBJECT ${IMAGE_SOURCES})
  target_link_libraries(${name}_objects PRIVATE ${IMAGE_DEPENDS} target_platform)
  target_compile_options(${name}_objects PRIVATE ${COUNTERPOINT_WARNINGS} ${COUNTERPOINT_KERNEL_FLAGS}
      ${COUNTERPOINT_MAIN_FLAGS})
  set(orders be8)
  set(collect --gc-sections)
  if(IMAGE_KEEP_ALL)
    set(collect --no-gc-sections)
  endif()
  if(NOT IMAGE_NO_SILICON)
    list(APPEND orders be32)
  endif()
  foreach(order IN LISTS orders)
    if(order STREQUAL be8)
      set(image ${name})
      set(flags -Wl,--be8)
      set(memory ${COUNTERPOINT_EMULATOR_MEMORY})
    else()
      set(image ${name}_be32)
      set(flags -mbe32)
      set(memory ${COUNTERPOINT_SILICON_MEMORY})
    endif()
    list(JOIN memory "," memory)
    add_executable(${image} $<TARGET_OBJECTS:hal_tms570_vectors> $<TARGET_OBJECTS:${name}_objects>)
    set_target_properties(${image} PROPERTIES SUFFIX .elf LINK_DEPENDS ${COUNTERPOINT_LINKER_SCRIPT})
    target_link_libraries(${image} PRIVATE ${IMAGE_DEPENDS} target_platform)
    target_link_options(${image} PRIVATE -nostdlib -nostartfiles ${flags}
        -Wl,${collect},--fatal-warnings,--no-warn-execstack,-Map=$<TARGET_FILE:${image}>.map
        -Wl,-u,FirmwareVectors,${memory},-T,${COUNTERPOINT_LINKER_SCRIPT})
  endforeach()
  add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_OBJCOPY} -O binary $<TARGET_FILE:${name}> $<TARGET_FILE_DIR:${name}>/${name}.bin
      BYPRODUCTS ${CMAKE_CURRENT_BINARY_DIR}/${name}.bin VERBATIM)
endfunction()
