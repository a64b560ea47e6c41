// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/own_device/inverse_port.hpp"

namespace counterpoint::firmware
{

CanPortId InversePort() noexcept
{
    return CanPortId::kFirst;
}

} // namespace counterpoint::firmware
