// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_CROSS_LINK_HPP
#define EXAMPLES_PORT_SKELETON_CROSS_LINK_HPP

#include "hal/api/cross_link.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// The wire to the other CPU of a device with two.
class CrossLink final : public counterpoint::hal::CrossLink
{
  public:
    /// @brief CONTRACT. Hands a frame to the wire, or says kNothing; never waits.
    [[nodiscard]] counterpoint::hal::LinkStatus Send(const counterpoint::hal::LinkFrame& frame) noexcept override;
    /// @brief CONTRACT. The next frame in the order of arrival. It may be wrong in every way: the kernel looks.
    [[nodiscard]] counterpoint::hal::LinkStatus Receive(counterpoint::hal::LinkFrame& frame) noexcept override;

    /// @brief kThere with the body, and not before; kAbsent where the device does without.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
