// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CHIP_REGISTERS_HPP
#define HAL_ZYNQMP_CHIP_REGISTERS_HPP

#include "hal/tms570/chip/registers.hpp"

/// The one way from the drivers to the hardware is that of hal/tms570: a register is a word at an address, on either
/// family. [SRS_ZYN_041]
namespace counterpoint::zynqmp
{

using tms570::At;
using tms570::Bits;
using tms570::Both;
using tms570::kWholeWord;
using tms570::Looks;
using tms570::Outcome;
using tms570::Read;
using tms570::Register;
using tms570::RegisterBase;
using tms570::WaitFor;
using tms570::Write;
using tms570::WriteChecked;

} // namespace counterpoint::zynqmp

#endif
