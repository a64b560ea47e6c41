// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_KERNEL_WATCH_HPP
#define CANOPEN_DEVICE_KERNEL_WATCH_HPP

#include "canopen/device/error_book.hpp"

#include "safety_core/kernel/application.hpp"

namespace counterpoint::device
{

/// Stands between the kernel and the application of a device: everything is passed on, errors are written into the
/// book. [SRS-DEV-013..015]
class KernelWatch final : public Application
{
  public:
    KernelWatch(ErrorBook& errors, Application& application) noexcept;

    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;

    /// @brief OPERATIONAL was left: SRDOs have no errors any more.
    void EndSrdoErrors() noexcept;
    /// @brief The kernel was started anew.
    void EndDeviceFault() noexcept;

  private:
    ErrorBook& errors_;
    Application& application_;
};

} // namespace counterpoint::device

#endif
