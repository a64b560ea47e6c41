// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_STOPS_HPP
#define CANOPEN_START_UP_EL6751_STOPS_HPP

#include "canopen/start_up/el6751/sdos.hpp"

namespace counterpoint::cia302
{

/// Stops slaves and holds them: phase kHeld, and the phases that wait for NMT stop. Such a slave is not supervised, and
/// no RxPDO is sent to it. [SRS_ELM_042, SRS_ELM_043]
class El6751Stops
{
  public:
    /// @brief All are kept by reference.
    El6751Stops(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos) noexcept;

    /// @brief NMT stop as soon as the queue has room, then what `event` leads to.
    void Stop(NodeId node, El6751Event event, Instant now) noexcept;
    /// @brief One step of a slave that waits for its stop.
    void Drive(NodeId node, Instant now) noexcept;
    /// @brief Stops the other slaves because of an error of `node`, if that is configured.
    void StopOthers(NodeId node, Instant now) noexcept;
    /// @brief The slave is not started; `code` is its NodeState.
    void Hold(NodeId node, std::int16_t code, Instant now) noexcept;
    /// @brief The gate refused the slave: that is told, and the slave is stopped.
    void Refuse(NodeId node, Instant now) noexcept;

  private:
    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    El6751Sdos& sdos_;
};

} // namespace counterpoint::cia302

#endif
