# Big-endian Cortex-R4F (TI TMS570): core and channel A by GCC, channel B by Clang, both freestanding.
#
#   cmake -S . -B build/target --toolchain cmake/toolchain-armeb.cmake -DCOUNTERPOINT_HOST=OFF
#         -DCOUNTERPOINT_CHANNEL_B_COMPILER=clang++-19 [-DCOUNTERPOINT_TARGET_OPTIMISE=-Os]
#
# Debian's arm-none-eabi has no big-endian library: nothing is linked but what this repository compiles. Both compilers
# take the standard's headers (<cstdint>, <cstddef>) from the packages libstdc++-arm-none-eabi-dev and libnewlib-dev.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR armeb)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# A compiler cache brings objects back without the call graphs that the analysis of the stack reads.
unset(ENV{CMAKE_CXX_COMPILER_LAUNCHER})

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)

set(COUNTERPOINT_TARGET_OPTIMISE -O2 CACHE STRING "Optimisation of the product; -Os measures the smallest code")
set(COUNTERPOINT_TARGET_CPU -mcpu=cortex-r4f -mbig-endian -mfpu=vfpv3-d16 -mfloat-abi=hard)
list(JOIN COUNTERPOINT_TARGET_CPU " " cpu)
# Paths of this machine do not reach an object, so that its digest is the same wherever it was built.
get_filename_component(source_folder ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
# -fstack-usage leaves beside each object how many bytes of stack each of its functions takes.
set(CMAKE_CXX_FLAGS_INIT "${cpu} -mthumb ${COUNTERPOINT_TARGET_OPTIMISE} -gdwarf-4 -fstack-usage")
string(APPEND CMAKE_CXX_FLAGS_INIT " -ffile-prefix-map=${CMAKE_BINARY_DIR}=build -ffile-prefix-map=${source_folder}=.")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")

# Drivers and what defines their registers need each other: the archives are searched until nothing is found any more.
set(CMAKE_CXX_LINK_EXECUTABLE
    "<CMAKE_CXX_COMPILER> <FLAGS> <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <OBJECTS> -o <TARGET> -Wl,--start-group <LINK_LIBRARIES> -Wl,--end-group")

# Clang takes GCC's flags for this processor as they are and needs these on top; GCC's ABI has short enumerations.
set(newlib /usr/include/newlib)
set(gcc_headers ${newlib}/c++/12.2.1)
set(COUNTERPOINT_CHANNEL_B_FLAGS --target=armebv7r-none-eabihf -fshort-enums -fomit-frame-pointer
    -isystem${gcc_headers} -isystem${gcc_headers}/arm-none-eabi -isystem${newlib}
    CACHE STRING "Flags of channel B's compiler that the compiler of the rest does not know")
# Stack usage again, by the names that the linker knows: only GCC has this, and needs it.
set(COUNTERPOINT_MAIN_FLAGS -fcallgraph-info=su CACHE STRING "Flags that the compiler of channel B does not know")
