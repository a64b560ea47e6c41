// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_BY_HAND_HPP
#define CANOPEN_START_UP_EL6751_BY_HAND_HPP

#include "canopen/start_up/el6751/release.hpp"

namespace counterpoint::cia302
{

/// Carries out commands of the application while the start-up runs: the transitions of the text's table, and NMT
/// commands. [SRS_ELM_046, SRS_ELM_047]
class El6751ByHand
{
  public:
    /// @brief All are kept by reference.
    El6751ByHand(El6751Slaves& slaves, El6751Sdos& sdos, El6751Stops& stops, El6751Release& release) noexcept;

    /// @brief See El6751StartUp::Control.
    [[nodiscard]] NmtAnswer Control(NodeId node, std::uint16_t ads_state, std::uint16_t device_state,
                                    Instant now) noexcept;
    /// @brief See El6751StartUp::Command.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept;

  private:
    [[nodiscard]] NmtAnswer CommandOne(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Hold(NmtCommand command, NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Start(NodeId node, Instant now) noexcept;
    [[nodiscard]] NmtAnswer Reset(NmtCommand command, NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Sdos& sdos_;
    El6751Stops& stops_;
    El6751Release& release_;
};

} // namespace counterpoint::cia302

#endif
