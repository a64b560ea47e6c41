// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_APP_DEVICE_HPP
#define CANOPEN_DEVICE_APP_DEVICE_HPP

#include "canopen/device/device.hpp"

namespace counterpoint::device
{

/// An application as a device without services. `App` is the application of `kernel`, describes the device to it
/// (Describe) and writes its configuration (Configure), which is a constant. [SRS_DEV_022, SRS_FW_022]
template <class App, std::uint8_t kSrdos> class AppDevice final : private Owner
{
  public:
    /// @brief All are kept by reference. `sender` sends the boot-up message; null: another CPU of the device sends it.
    AppDevice(Kernel& kernel, hal::CanPorts* const sender, App& application) noexcept
        : application_{application}, kernel_{kernel}, services_{cia301::NodeId{application.Describe().node_id}, sender},
          device_{BareParts{kernel, services_, *this, FrameRoom{frames_, kRoom}, kSrdos}}
    {
    }
    /// @brief The device itself, for frames, cycles and power-on.
    [[nodiscard]] Device& Whole() noexcept
    {
        return device_;
    }
    /// @brief What the kernel answered to the last start; kInvalid: it was not asked, because of the device safe state.
    /// NameOf and MeaningOf (names/safety_core/kernel/start_check.hpp) say it in words. [SRS_EASE_007]
    [[nodiscard]] StartResult Started() const noexcept
    {
        return started_;
    }

  private:
    static constexpr std::uint32_t kRoom = (2U * kSrdos) + 2U;

    /// Only a restart with all start-up tests leads out of the device safe state, and this device cannot run them.
    [[nodiscard]] LoadResult OnResetNode() noexcept override
    {
        const bool is_safe = (started_ == StartResult::kStarted) && (kernel_.DeviceState().fault != DeviceFault::kNone);
        started_ = is_safe ? StartResult::kInvalid : kernel_.Start(application_.Describe(), FlowCallback::kOff);
        return (started_ == StartResult::kStarted) ? LoadResult::kLoaded : LoadResult::kFailed;
    }
    /// What was written once stays.
    [[nodiscard]] LoadResult OnResetCommunication() noexcept override
    {
        const bool is_valid = kernel_.ReadObject({0x13FEU, 0U}).data.bytes[0] == kConfigurationValidValue;
        const bool is_loaded = is_valid || (App::Configure(kernel_) == AbortCode::kNone);
        return is_loaded ? LoadResult::kLoaded : LoadResult::kFailed;
    }

    App& application_;
    Kernel& kernel_;
    StartResult started_{StartResult::kInvalid};
    QueuedFrame frames_[kRoom]{};
    NoServices services_;
    Device device_;
};

} // namespace counterpoint::device

#endif
