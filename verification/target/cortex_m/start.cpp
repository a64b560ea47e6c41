// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Vectors and start of a program on an emulated Cortex-M board: what a port needs before its first line of C++. An
// exception ends the run as a failure.
#include "verification/target/target.hpp"

extern "C"
{
    std::uint32_t TargetMain() noexcept;
    [[noreturn]] void BoardReset() noexcept;
    [[noreturn]] void BoardException() noexcept;
    extern std::uint32_t board_data_start[];
    extern std::uint32_t board_data_end[];
    extern const std::uint32_t board_data_load[];
    extern std::uint32_t board_zero_start[];
    extern std::uint32_t board_zero_end[];
    extern std::uint32_t stack_main_top[];
}

extern "C" void BoardReset() noexcept
{
    const std::uint32_t* from = board_data_load;
    for (std::uint32_t* to = board_data_start; to != board_data_end; ++to)
    {
        *to = *from;
        ++from;
    }
    for (std::uint32_t* to = board_zero_start; to != board_zero_end; ++to)
    {
        *to = 0U;
    }
    counterpoint::target::Exit(TargetMain());
}

extern "C" void BoardException() noexcept
{
    counterpoint::target::Write("FAILURE: exception\n");
    counterpoint::target::Exit(1U);
}

namespace
{

using Entry = void (*)();

/// What the processor takes from the first address of its memory: stack, reset, the exceptions of the processor itself.
struct Vectors
{
    std::uint32_t* stack;
    Entry reset;
    Entry exceptions[14];
};

} // namespace

extern "C" [[gnu::section(".vectors")]] const Vectors board_vectors{
    stack_main_top,
    BoardReset,
    {BoardException, BoardException, BoardException, BoardException, BoardException, BoardException, BoardException,
     BoardException, BoardException, BoardException, BoardException, BoardException, BoardException, BoardException}};
