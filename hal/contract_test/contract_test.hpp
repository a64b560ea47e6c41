// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_CONTRACT_TEST_CONTRACT_TEST_HPP
#define HAL_CONTRACT_TEST_CONTRACT_TEST_HPP

#include "hal/contract_test/port_under_test.hpp"

#include <cstdint>

namespace counterpoint::hal::contract
{

/// What the checks came to.
struct ContractCount
{
    std::uint32_t held;
    std::uint32_t broken;
    std::uint32_t not_shown;
};

/// @brief Examines a port part by part, and writes one line for each check: `part: check: held`, `broken: what:
/// expected ..., got ...` or `not shown: why`; the last line is the count. Needs no heap and no library; ends after a
/// bounded number of calls. A line that stops after the check's name tells which call did not come back. The last
/// check cuts the outputs off. [SRS_HAL_030, SRS_HAL_031, SRS_HAL_037]
[[nodiscard]] ContractCount RunContractTest(const PortUnderTest& port) noexcept;

} // namespace counterpoint::hal::contract

#endif
