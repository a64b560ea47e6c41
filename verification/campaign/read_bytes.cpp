// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/read_bytes.hpp"

namespace counterpoint::campaign
{
std::vector<ReadBytes> WhatIsRead(Device& device)
{
    std::vector<ReadBytes> read;
    for (const FlatPair& pair : device.Pairs())
    {
        for (const VariablePlace& place : {pair.normal, pair.inverse})
        {
            if (pair.is_consumer)
            {
                read.push_back({device.Memory().OffsetOf(place.place), (place.length_bits + 7U) / 8U});
            }
        }
    }
    return read;
}
} // namespace counterpoint::campaign
