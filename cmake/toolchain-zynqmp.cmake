# Little-endian Cortex-R5F of a Zynq UltraScale+: core and channel A by GCC, channel B by Clang, both freestanding.
#
#   cmake --preset zynqmp && cmake --build --preset zynqmp
#
# Debian's arm-none-eabi is asked for no library: nothing is linked but what this repository compiles. Both compilers take the
# standard's headers (<cstdint>, <cstddef>) from the packages libstdc++-arm-none-eabi-dev and libnewlib-dev.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR zynqmp)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)

# Both compilers take these: a Cortex-R5 with the sixteen registers of double precision, arguments in them.
set(cpu "-mcpu=cortex-r5 -mfpu=vfpv3-d16 -mfloat-abi=hard")
# Paths of this machine do not reach an object, so that its digest is the same wherever it was built.
get_filename_component(source_folder ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(CMAKE_CXX_FLAGS_INIT "${cpu} -mthumb -O2 -gdwarf-4 -ffile-prefix-map=${CMAKE_BINARY_DIR}=build -ffile-prefix-map=${source_folder}=.")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")

# Drivers and what defines their registers need each other: the archives are searched until nothing is found any more.
set(CMAKE_CXX_LINK_EXECUTABLE
    "<CMAKE_CXX_COMPILER> <FLAGS> <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET> -Wl,--start-group <LINK_LIBRARIES> -Wl,--end-group")

# Clang takes GCC's flags for this processor as they are and needs these on top: its name of the target; the short enumerations
# of GCC's ABI, without which an enumeration of the contract has another size in channel B; the headers of GCC's library.
set(newlib /usr/include/newlib)
set(gcc_headers ${newlib}/c++/12.2.1)
set(COUNTERPOINT_CHANNEL_B_FLAGS --target=armv7r-none-eabihf -fshort-enums -fomit-frame-pointer
    -isystem${gcc_headers} -isystem${gcc_headers}/arm-none-eabi -isystem${newlib}
    CACHE STRING "Flags of channel B's compiler that the compiler of the rest does not know")
