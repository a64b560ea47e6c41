// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_ALTERED_DEVICE_HPP
#define VERIFICATION_CONFORMANCE_ALTERED_DEVICE_HPP

#include "verification/conformance/device.hpp"
#include "verification/conformance/dictionary.hpp"
#include "verification/conformance/step.hpp"

#include <cstdint>

namespace counterpoint::conformance
{

/// The description of a case's device, which steps may alter.
class AlteredDevice
{
  public:
    void Take(const Device& device, const Dictionary& dictionary) noexcept;
    /// @brief No channel keeps a reference to the setup of a slot, but to the configuration: it is restarted after
    /// this.
    void Alter(const Step& step) noexcept;
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return config_;
    }

  private:
    static constexpr std::uint8_t kAlterable = 3U;

    void AlterDevice(Parameter parameter, std::uint32_t value) noexcept;
    void AlterTimes(Parameter parameter, std::uint32_t value) noexcept;
    void AlterSetup(Parameter parameter, SrdoSetup& setup, std::uint32_t value) noexcept;

    DeviceConfig config_{};
    SrdoSetup setups_[kAlterable]{}; ///< Of a device that has no more SRDOs: copies that Alter may change.
};

} // namespace counterpoint::conformance

#endif
