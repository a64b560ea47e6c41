# Any Cortex-M from the M3 on, little-endian: core and channel A by GCC, channel B by Clang, both freestanding.
#
#   cmake -S . -B build/cortex-m4 --toolchain cmake/toolchain-cortex-m.cmake -DCOUNTERPOINT_HOST=OFF
#         -DCOUNTERPOINT_CHANNEL_B_COMPILER=clang++-19 [-DCOUNTERPOINT_CORTEX_M=cortex-m4] [-DCOUNTERPOINT_CORTEX_M_FLOAT=soft]
#   cmake --build build/cortex-m4 --target safety_core_kernel channel_a channel_b
#
# COUNTERPOINT_CORTEX_M        cortex-m3, cortex-m4, cortex-m7, cortex-m33, ...: what -mcpu of both compilers takes
# COUNTERPOINT_CORTEX_M_FLOAT  ABI of the program that links the kernel: soft, softfp or hard; the kernel computes nothing in floating point
#
# Both compilers take the standard's headers (<cstdint>, <cstddef>) from the packages libstdc++-arm-none-eabi-dev and
# libnewlib-dev; nothing of their libraries is linked.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES COUNTERPOINT_CORTEX_M COUNTERPOINT_CORTEX_M_FLOAT)

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)

set(COUNTERPOINT_CORTEX_M cortex-m4 CACHE STRING "The processor, as -mcpu names it")
set(COUNTERPOINT_CORTEX_M_FLOAT soft CACHE STRING "ABI of floating point: soft, softfp or hard")
set(cpu "-mcpu=${COUNTERPOINT_CORTEX_M} -mthumb -mfloat-abi=${COUNTERPOINT_CORTEX_M_FLOAT}")
# Paths of this machine do not reach an object, so that its digest is the same wherever it was built.
get_filename_component(source_folder ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(CMAKE_CXX_FLAGS_INIT "${cpu} -O2 -gdwarf-4 -ffile-prefix-map=${CMAKE_BINARY_DIR}=build -ffile-prefix-map=${source_folder}=.")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")

# Clang takes GCC's flags for this processor as they are and needs these on top: its name of the target; the short enumerations
# of GCC's ABI, without which an enumeration of the contract has another size in channel B; the headers of GCC's library.
set(newlib /usr/include/newlib)
set(gcc_headers ${newlib}/c++/12.2.1)
set(COUNTERPOINT_CHANNEL_B_FLAGS --target=arm-none-eabi -fshort-enums
    -isystem${gcc_headers} -isystem${gcc_headers}/arm-none-eabi -isystem${newlib}
    CACHE STRING "Flags of channel B's compiler that the compiler of the rest does not know")
