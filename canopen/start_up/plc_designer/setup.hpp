// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_PLC_DESIGNER_SETUP_HPP
#define CANOPEN_START_UP_PLC_DESIGNER_SETUP_HPP

#include "canopen/cia302/network/sdo_pool.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What the PLC Designer profile knows of a slave beside SlaveSetup, whose concise DCF holds the SDOs of the
/// configurator. A slave without a PlcSlave is neither optional nor reset.
struct PlcSlave
{
    bool is_optional{false};
    bool is_reset{false}; ///< "Reset nodes": 1011h:01 and a reset before it is configured.
};

/// Time-out and tries of the SDO pool for this profile. It repeats SDOs itself.
constexpr SdoTimes kPlcSdoTimes{500000U, 1U};

} // namespace counterpoint::cia302

#endif
