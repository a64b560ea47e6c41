// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_PARTS_HPP
#define CHANNEL_B_PARTS_HPP

#include "channel_b/faults.hpp"
#include "channel_b/mapping.hpp"
#include "channel_b/settings.hpp"

namespace counterpoint::channel_b
{

/// What consumers and producers stand on.
struct Parts
{
    const Settings& settings;
    const Mappings& mappings;
    Faults& faults;
};

} // namespace counterpoint::channel_b

#endif
