// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_STOPS_HPP
#define CANOPEN_START_UP_EL6751_STOPS_HPP

#include "canopen/start_up/el6751/sdos.hpp"

namespace counterpoint::cia302
{

/// Slaves that are stopped or held: phases kHeld and those that wait for NMT stop. Nothing is supervised any more, no
/// RxPDO goes to them. [SRS_ELM_042, SRS_ELM_043]
class El6751Stops
{
  public:
    El6751Stops(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos) noexcept;

    /// @brief NMT stop as soon as the queue has room, then what `event` leads to.
    void Stop(NodeId node, El6751Event event, Instant now) noexcept;
    /// @brief One step of a slave that waits for it.
    void Drive(NodeId node, Instant now) noexcept;
    /// @brief The reaction of the network to an error of `node`, if one is set up.
    void StopOthers(NodeId node, Instant now) noexcept;
    /// @brief Not started, and why.
    void Hold(NodeId node, std::int16_t code, Instant now) noexcept;
    /// @brief The gate refused the slave: told, and stopped.
    void Refuse(NodeId node, Instant now) noexcept;

  private:
    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    El6751Sdos& sdos_;
};

} // namespace counterpoint::cia302

#endif
