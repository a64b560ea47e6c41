// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRST_DEVICE_DEVICE_HPP
#define EXAMPLES_FIRST_DEVICE_DEVICE_HPP

#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace first_device
{

/// SRDO 1 receives a command, SRDO 2 reports it back. The same source on host and target: no heap, no library.
class Device final : public counterpoint::Application
{
  public:
    /// @brief Describes the device to the kernel; the objects are variables of this class.
    [[nodiscard]] const counterpoint::DeviceConfig& Describe() noexcept;
    /// @brief Writes the configuration and declares it valid; the first refusal ends it.
    [[nodiscard]] static counterpoint::AbortCode Configure(counterpoint::Kernel& kernel) noexcept;
    /// @brief The received command: 0 is the safe value.
    [[nodiscard]] std::uint8_t Command() const noexcept;
    /// @brief First cause since the last call; kNone if there was none.
    [[nodiscard]] counterpoint::SrdoCause TakeError() noexcept;

    counterpoint::RefreshAnswer OnRefresh(counterpoint::CommunicationIndex index) noexcept override;
    void OnSrdoEvent(counterpoint::CommunicationIndex index) noexcept override;
    void OnSrdoError(counterpoint::CommunicationIndex index, counterpoint::SrdoCause cause) noexcept override;
    void OnConfigurationInvalid(counterpoint::CommunicationIndex index) noexcept override;
    void OnDeviceFault(const counterpoint::DeviceFaultReport& report) noexcept override;

  private:
    std::uint8_t report_[1]{0U};             ///< 2000h:01, sent as normal data.
    std::uint8_t report_inverse_[1]{0xFFU};  ///< 2100h:01, sent as inverse data.
    std::uint8_t command_[1]{0U};            ///< 2200h:01, written by channel A.
    std::uint8_t command_inverse_[1]{0xFFU}; ///< 2300h:01, written by channel B.
    counterpoint::SrdoCause error_{counterpoint::SrdoCause::kNone};
    counterpoint::MappableObject objects_[4]{};
    counterpoint::DeviceConfig config_{};
};

} // namespace first_device

#endif
