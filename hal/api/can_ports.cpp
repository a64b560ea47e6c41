// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/can_ports.hpp"

namespace counterpoint::hal
{

MissingGuarantee CheckGuarantees(const CanGuarantees& guarantees) noexcept
{
    if (guarantees.bus_order != Guarantee::kGiven)
    {
        return MissingGuarantee::kBusOrder;
    }
    if (guarantees.stamps != Guarantee::kGiven)
    {
        return MissingGuarantee::kStamps;
    }
    if (guarantees.confirmations != Guarantee::kGiven)
    {
        return MissingGuarantee::kConfirmations;
    }
    return MissingGuarantee::kNone;
}

} // namespace counterpoint::hal
