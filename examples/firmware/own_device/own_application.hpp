// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_OWN_DEVICE_OWN_APPLICATION_HPP
#define EXAMPLES_FIRMWARE_OWN_DEVICE_OWN_APPLICATION_HPP

#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

/// Template of an application: two producers report two safe inputs, two consumers enable two outputs. Change what a
/// bit means in own_application.cpp, what an SRDO carries in own_device.dcf.
class OwnApplication final : public QuietApplication
{
  public:
    static constexpr std::uint8_t kProducers = 2U; ///< SRDO 1 and 2.
    static constexpr std::uint8_t kConsumers = 2U; ///< SRDO 3 and 4.
    static constexpr std::uint8_t kSrdos = kProducers + kConsumers;

    /// @brief `inverse_port` is the controller of the inverse frames: kSecond on a board that has one for them.
    explicit OwnApplication(const CanPortId inverse_port) noexcept : inverse_port_{inverse_port}
    {
    }

    [[nodiscard]] const DeviceConfig& Describe() noexcept;
    [[nodiscard]] static AbortCode Configure(Kernel& kernel) noexcept;
    /// @brief Before each cycle: the two readings of one safe input, `b` the inverse of `a`.
    void Sense(std::uint8_t input, std::uint8_t a, std::uint8_t b) noexcept;
    /// @brief After each cycle: whether output `output` may be on. `open` is what the gate lets through.
    [[nodiscard]] bool IsEnabled(std::uint8_t output, SrdoMask open) const noexcept;

    RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;

  private:
    static constexpr std::uint8_t kObjects = 2U * kSrdos;

    CanPortId inverse_port_;
    std::uint8_t sensed_a_[kProducers]{};
    std::uint8_t sensed_b_[kProducers]{};
    std::uint8_t input_[kProducers]{};           ///< 2000h:01, :02.
    std::uint8_t input_inverse_[kProducers]{};   ///< 2100h:01, :02.
    std::uint8_t command_[kConsumers]{};         ///< 2200h:01, :02, written by channel A.
    std::uint8_t command_inverse_[kConsumers]{}; ///< 2300h:01, :02, written by channel B.
    MappableObject objects_[kObjects]{};
    DeviceConfig config_{};
};

} // namespace counterpoint::examples

#endif
