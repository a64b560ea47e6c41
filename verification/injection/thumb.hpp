// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_THUMB_HPP
#define VERIFICATION_INJECTION_THUMB_HPP

#include "verification/injection/program.hpp"

#include <cstdint>
#include <vector>

/// What the injector reads in instructions of the image.
namespace counterpoint::injection
{

/// @brief Whether this half word is an IT instruction.
[[nodiscard]] bool IsIt(std::uint32_t half_word);
/// @brief Instructions that an IT instruction makes conditional: 1 to 4.
[[nodiscard]] std::uint32_t BlockLength(std::uint32_t half_word);
/// @brief The address behind the block of the IT instruction `half_word` at this address.
[[nodiscard]] std::uint32_t BlockEnd(const Program& program, std::uint32_t it, std::uint32_t half_word);
/// @brief Where a conditional branch leads to when it is taken.
[[nodiscard]] std::uint32_t Target(const Program& program, std::uint32_t address);
/// @brief The IT instruction whose block has the instruction number `count` of the trace; `count` itself where none.
[[nodiscard]] std::uint32_t FindBlock(const Program& program, const std::vector<std::uint32_t>& trace,
                                      std::uint32_t count);
/// @brief Whether the instruction decides: a conditional branch or an IT.
[[nodiscard]] bool IsDecision(const Program& program, std::uint32_t address);

} // namespace counterpoint::injection

#endif
