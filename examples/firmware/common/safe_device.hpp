// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_SAFE_DEVICE_HPP
#define EXAMPLES_FIRMWARE_COMMON_SAFE_DEVICE_HPP

#include "canopen/device/app_device.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/firmware/common/cell.hpp"
#include "examples/firmware/common/device.hpp"
#include "examples/firmware/common/guarded_channel.hpp"
#include "examples/firmware/common/memory_protection.hpp"

namespace counterpoint::firmware
{

/// Memory of channel A: storage and state.
template <std::uint8_t kSrdos> struct MemoryA
{
    channel_a::StorageFor<kSrdos> storage{};
    channel_a::Channel channel{storage.Handle()};
};

template <std::uint8_t kSrdos> struct MemoryB
{
    channel_b::StorageFor<kSrdos> storage{};
    channel_b::Channel channel{storage.Handle()};
};

/// The kernel and what it calls the channels through.
struct CoreMemory
{
    CoreMemory(const Hardware& hardware, Channel& channel_a, Channel& channel_b, Application& application,
               CauseWindows* const windows) noexcept
        : a{channel_a, hardware.protection, hal::MemoryOwner::kChannelA},
          b{channel_b, hardware.protection, hal::MemoryOwner::kChannelB},
          kernel{KernelParts{a, b, hardware.can, hardware.output, hardware.watchdog, application, nullptr, windows}}
    {
    }

    GuardedChannel a;
    GuardedChannel b;
    Kernel kernel;
};

/// The three regions of a device, each cell in its own section; and the windows of the told causes, which decide
/// nothing and stand with the rest of the memory.
template <std::uint8_t kSrdos> struct Regions
{
    Cell<MemoryA<kSrdos>>& a;
    Cell<MemoryB<kSrdos>>& b;
    Cell<CoreMemory>& core;
    CauseWindows (&windows)[kSrdos];
};

/// @brief Builds a device in its regions and protects them; the application is built already. What no party may keep to
/// itself is in `rest`. [SRS_FW_022]
template <class App, std::uint8_t kSrdos>
[[nodiscard]] DrivenDevice Build(const Hardware& hardware, const Regions<kSrdos>& regions,
                                 Cell<device::AppDevice<App, kSrdos>>& rest, App& application) noexcept
{
    MemoryA<kSrdos>& a = regions.a.Make();
    MemoryB<kSrdos>& b = regions.b.Make();
    CoreMemory& core =
        regions.core.Make(hardware, a.channel, b.channel, static_cast<Application&>(application), &regions.windows[0]);
    device::AppDevice<App, kSrdos>& device = rest.Make(core.kernel, &hardware.can, application);
    return DrivenDevice{device.Whole(), core.kernel, ProtectRegions(hardware.protection)};
}

} // namespace counterpoint::firmware

#endif
