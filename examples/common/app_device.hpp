// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_COMMON_APP_DEVICE_HPP
#define EXAMPLES_COMMON_APP_DEVICE_HPP

#include "canopen/device/device.hpp"

namespace counterpoint::examples
{

/// An application as a device: canopen/device follows NMT, the application describes and configures the kernel. It has
/// no other services. [SRS_FW_022]
template <class App, std::uint8_t kSrdos> class AppDevice final : private device::Owner
{
  public:
    /// `sender` sends the boot-up message; null: another CPU of the device does.
    AppDevice(Kernel& kernel, hal::CanPorts* const sender, App& application) noexcept
        : application_{application}, kernel_{kernel}, services_{cia301::NodeId{application.Describe().node_id}, sender},
          device_{device::BareParts{kernel, services_, *this, device::FrameRoom{frames_, kRoom}, kSrdos}}
    {
    }
    [[nodiscard]] device::Device& Whole() noexcept
    {
        return device_;
    }

  private:
    static constexpr std::uint32_t kRoom = (2U * kSrdos) + 2U;

    [[nodiscard]] device::LoadResult OnResetNode() noexcept override
    {
        const StartResult result = kernel_.Start(application_.Describe(), FlowCallback::kOff);
        return (result == StartResult::kStarted) ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
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
    device::QueuedFrame frames_[kRoom]{};
    device::NoServices services_;
    device::Device device_;
};

} // namespace counterpoint::examples

#endif
