// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_KERNEL_WATCH_HPP
#define CANOPEN_DEVICE_KERNEL_WATCH_HPP

#include "canopen/cia301/emergency/producer.hpp"

#include "safety_core/kernel/application.hpp"

namespace counterpoint::device
{

constexpr std::uint16_t kEmergenciesOfSrdo = 5U; ///< Kinds of error of one SRDO that may be active at once.

/// Stands between the kernel and the application of a device: everything is passed on, and what the kernel tells of
/// errors becomes emergencies, one for each SRDO and kind of error. [SRS_DEV_013, SRS_DEV_014, SRS_DEV_015]
class KernelWatch final : public Application
{
  public:
    /// @brief Both are kept by reference.
    KernelWatch(cia301::EmergencyProducer& emergency, Application& application) noexcept;

    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;

    /// @brief OPERATIONAL was entered while 13FEh is not A5h.
    void OnNotConfigured() noexcept;
    /// @brief OPERATIONAL was left: errors of SRDOs end, and so does the error of a missing configuration.
    void OnOperationalLeft() noexcept;
    /// @brief The kernel was started again.
    void OnRestart() noexcept;

  private:
    cia301::EmergencyProducer& emergency_;
    Application& application_;
    std::uint16_t device_code_; ///< Of the device fault that was told; 0: none.
};

} // namespace counterpoint::device

#endif
