// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_WATCH_HPP
#define CANOPEN_START_UP_EL6751_WATCH_HPP

#include "canopen/start_up/el6751/stops.hpp"

namespace counterpoint::cia302
{

/// Watches the slaves whose SDOs are done: their TxPDOs, errors and the reactions to them, and the gate of safety
/// slaves that run. [SRS_ELM_029, SRS_ELM_034, SRS_ELM_035, SRS_ELM_036, SRS_ELM_037, SRS_ELM_038, SRS_ELM_039,
/// SRS_ELM_040, SRS_ELM_041, SRS_ELM_049]
class El6751Watch
{
  public:
    /// @brief All are kept by reference.
    El6751Watch(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos, El6751Stops& stops) noexcept;

    /// @brief One step of a slave that was started.
    void Watch(NodeId node, Instant now) noexcept;
    /// @brief One step of a slave that is not to run: held, failed or deactivated.
    void WatchIdle(NodeId node, Instant now) noexcept;
    /// @brief Error control found what `code` says, or the slave restarted.
    void OnFault(NodeId node, std::int16_t code, Instant now) noexcept;

  private:
    [[nodiscard]] std::int16_t FaultOf(NodeId node) noexcept;
    void React(NodeId node, std::int16_t code, Instant now) noexcept;
    void VerifyAgain(NodeId node, Instant now) noexcept;
    void Check(NodeId node, bool is_suspect, Instant now) noexcept;

    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    El6751Sdos& sdos_;
    El6751Stops& stops_;
    SafetyReader reader_;
};

} // namespace counterpoint::cia302

#endif
