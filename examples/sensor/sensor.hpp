// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_SENSOR_SENSOR_HPP
#define EXAMPLES_SENSOR_SENSOR_HPP

#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

/// The contacts of one button as two inputs read them: contact A closes (1) and contact B opens (0) while the button is
/// let go. Pressed, they are the other way round; alike, a contact or a wire is broken.
struct Contacts
{
    std::uint8_t a;
    std::uint8_t b;
};

/// Two emergency-stop buttons, one producer. 2000h:01 and :02 are 1 while a button is let go.
class Sensor final : public QuietApplication
{
  public:
    static constexpr std::uint8_t kButtons = 2U;

    [[nodiscard]] const DeviceConfig& Describe() noexcept;
    [[nodiscard]] static AbortCode Configure(Kernel& kernel) noexcept;
    /// @brief Before each cycle: what the inputs read.
    void Sense(std::uint8_t button, const Contacts& contacts) noexcept;

    RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;

  private:
    Contacts contacts_[kButtons]{};
    std::uint8_t normal_[kButtons]{};  ///< 2000h:01, :02, from the contacts A.
    std::uint8_t inverse_[kButtons]{}; ///< 2100h:01, :02, from the contacts B.
    MappableObject objects_[2U * kButtons]{};
    DeviceConfig config_{};
};

} // namespace counterpoint::examples

#endif
