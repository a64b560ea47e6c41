// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "verification/target/zynqmp/two_cpu/own_channel.hpp"

namespace
{

/// Its name is known to the runner, which flips bits in it.
counterpoint::channel_b::StorageFor<2U> two_cpu_storage;

} // namespace

namespace counterpoint::two_cpu
{

Channel& OwnChannel() noexcept
{
    static channel_b::Channel channel{two_cpu_storage.Handle()};
    return channel;
}

PeerRole OwnRole() noexcept
{
    return PeerRole::kB;
}

} // namespace counterpoint::two_cpu
