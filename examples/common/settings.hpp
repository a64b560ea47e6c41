// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_COMMON_SETTINGS_HPP
#define EXAMPLES_COMMON_SETTINGS_HPP

#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace counterpoint::examples
{

/// One object of the configuration, as it stands in the device's DCF.
struct Setting
{
    ObjectAddress address;
    std::uint8_t size_bytes;
    std::uint32_t value;
};

struct SettingList
{
    const Setting* first;
    std::uint32_t count;
};

/// @brief Writes the settings in their order; the first refusal ends it and is returned.
[[nodiscard]] AbortCode WriteSettings(Kernel& kernel, const SettingList& list) noexcept;

/// @brief What all example devices have alike: one controller, cycle 1 ms, objects of whole bytes.
void SetCommonConfig(DeviceConfig& config) noexcept;

/// An application that need not know of most events.
class QuietApplication : public Application
{
  public:
    void OnSrdoEvent(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnSrdoError(CommunicationIndex /*index*/, const SrdoCause cause) noexcept override
    {
        error_ = (error_ == SrdoCause::kNone) ? cause : error_;
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept override
    {
    }

    /// @brief First cause since the last call; kNone if there was none.
    [[nodiscard]] SrdoCause TakeError() noexcept
    {
        const SrdoCause error = error_;
        error_ = SrdoCause::kNone;
        return error;
    }

  protected:
    QuietApplication() noexcept = default;
    ~QuietApplication() noexcept = default;

  private:
    SrdoCause error_{SrdoCause::kNone};
};

} // namespace counterpoint::examples

#endif
