// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_SAFE_DEVICE_HPP
#define EXAMPLES_FIRMWARE_COMMON_SAFE_DEVICE_HPP

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
    CoreMemory(const Hardware& hardware, Channel& channel_a, Channel& channel_b, Application& application) noexcept
        : a{channel_a, hardware.protection, hal::MemoryOwner::kChannelA},
          b{channel_b, hardware.protection, hal::MemoryOwner::kChannelB},
          kernel{KernelParts{a, b, hardware.can, hardware.output, hardware.watchdog, application}}
    {
    }

    GuardedChannel a;
    GuardedChannel b;
    Kernel kernel;
};

/// The three regions of a device. Each cell stands in its own section.
template <std::uint8_t kSrdos> struct Regions
{
    Cell<MemoryA<kSrdos>>& a;
    Cell<MemoryB<kSrdos>>& b;
    Cell<CoreMemory>& core;
};

/// A device without services in its regions, started and configured by its application, which is built already. What
/// the network says of NMT, canopen/device follows. [SRS_FW_022]
template <class App, std::uint8_t kSrdos> class SafeDevice final : private device::Owner
{
  public:
    SafeDevice(const Hardware& hardware, const Regions<kSrdos>& regions, App& application) noexcept
        : application_{application}, kernel_{regions.core
                                                 .Make(hardware, regions.a.Make().channel, regions.b.Make().channel,
                                                       static_cast<Application&>(application))
                                                 .kernel},
          is_protected_{ProtectRegions(hardware.protection)},
          services_{cia301::NodeId{application.Describe().node_id}, &hardware.can},
          device_{device::BareParts{kernel_, services_, *this, device::FrameRoom{frames_, kRoom}, kSrdos}}
    {
    }
    [[nodiscard]] DrivenDevice Driven() noexcept
    {
        return DrivenDevice{device_, kernel_};
    }

  private:
    static constexpr std::uint32_t kRoom = (2U * kSrdos) + 2U;

    [[nodiscard]] device::LoadResult OnResetNode() noexcept override
    {
        const bool is_started =
            is_protected_ && (kernel_.Start(application_.Describe(), FlowCallback::kOff) == StartResult::kStarted);
        return is_started ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
    }
    /// The configuration is a constant: what was written once stays.
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override
    {
        const bool is_valid = kernel_.ReadObject({0x13FEU, 0U}).data.bytes[0] == kConfigurationValidValue;
        const bool is_loaded = is_valid || (App::Configure(kernel_) == AbortCode::kNone);
        return is_loaded ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
    }

    App& application_;
    Kernel& kernel_;
    bool is_protected_;
    device::QueuedFrame frames_[kRoom]{};
    device::NoServices services_;
    device::Device device_;
};

} // namespace counterpoint::firmware

#endif
