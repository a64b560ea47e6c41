# The same target with everything compiled by Clang 19 and instrumented for MC/DC, branch and line coverage. Not the product:
# it shows that the tests reach on the target what they reach on the host. GNU ld links, as for the product.
#
#   cmake -S . -B build/target-coverage --toolchain cmake/toolchain-armeb-coverage.cmake -DCOUNTERPOINT_HOST=OFF
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR armeb)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)

set(cpu "-mcpu=cortex-r4f -mbig-endian -mfpu=vfpv3-d16 -mfloat-abi=hard")
set(newlib /usr/include/newlib)
set(gcc_headers ${newlib}/c++/12.2.1)
set(headers "-isystem${gcc_headers} -isystem${gcc_headers}/arm-none-eabi -isystem${newlib}")
set(CMAKE_CXX_FLAGS_INIT "--target=armebv7r-none-eabihf ${cpu} -mthumb -O1 -g0 -fshort-enums ${headers}")
string(APPEND CMAKE_CXX_FLAGS_INIT " -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")
set(CMAKE_AR arm-none-eabi-ar)
set(CMAKE_RANLIB arm-none-eabi-ranlib)
set(CMAKE_OBJCOPY arm-none-eabi-objcopy)
set(CMAKE_CXX_LINK_EXECUTABLE "arm-none-eabi-g++ ${cpu} -mthumb <LINK_FLAGS> <OBJECTS> -o <TARGET> -Wl,--start-group <LINK_LIBRARIES> -Wl,--end-group")
