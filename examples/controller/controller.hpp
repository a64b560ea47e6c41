// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_CONTROLLER_CONTROLLER_HPP
#define EXAMPLES_CONTROLLER_CONTROLLER_HPP

#include "examples/common/settings.hpp"
#include "safety_core/crosslink/link_config.hpp"

namespace counterpoint::examples
{

/// Joins two buttons to two commands. Each of the two CPUs has one of these: CPU A computes from the normal objects
/// that channel A wrote, CPU B from the inverse ones that channel B wrote.
class Controller final : public QuietApplication
{
  public:
    explicit Controller(PeerRole role) noexcept;

    [[nodiscard]] const DeviceConfig& Describe() noexcept;
    [[nodiscard]] LinkConfig DescribeLink() const noexcept;
    [[nodiscard]] static AbortCode Configure(Kernel& kernel) noexcept;

    RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;

  private:
    static constexpr std::uint8_t kValues = 2U;

    [[nodiscard]] std::uint8_t Button(std::uint8_t number) const noexcept;

    PeerRole role_;
    std::uint8_t command_[kValues]{};         ///< 2000h
    std::uint8_t command_inverse_[kValues]{}; ///< 2100h
    std::uint8_t button_[kValues]{};          ///< 2200h
    std::uint8_t button_inverse_[kValues]{};  ///< 2300h
    MappableObject objects_[4U * kValues]{};
    DeviceConfig config_{};
};

} // namespace counterpoint::examples

#endif
