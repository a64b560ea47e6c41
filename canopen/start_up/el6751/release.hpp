// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_RELEASE_HPP
#define CANOPEN_START_UP_EL6751_RELEASE_HPP

#include "canopen/start_up/el6751/stops.hpp"

namespace counterpoint::cia302
{

/// Leads a slave from its last SDO to OPERATIONAL: supervision, safety gate, NMT start. Phases kVerify and kStarting.
/// [SRS_ELM_026, SRS_ELM_039, SRS_ELM_048]
class El6751Release
{
  public:
    /// @brief All are kept by reference.
    El6751Release(El6751Slaves& slaves, El6751Pdos& pdos, El6751Stops& stops) noexcept;

    /// @brief All SDOs were answered: the slave is supervised, and started if it is to be started.
    void Begin(NodeId node, Instant now) noexcept;
    /// @brief Starts the slave; a safety slave is verified first.
    void Start(NodeId node, Instant now) noexcept;
    /// @brief One step of the slave. Once a cycle.
    void Drive(NodeId node, Instant now) noexcept;
    /// @brief Somebody commanded the slave while its start waited: it is verified once more.
    void OnStartDropped(NodeId node, Instant now) noexcept;

  private:
    void Supervise(NodeId node, Instant now) noexcept;
    void DriveVerify(NodeId node, Instant now) noexcept;
    void DriveStart(NodeId node, Instant now) noexcept;
    void Run(NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    El6751Stops& stops_;
    SafetyReader reader_;
};

} // namespace counterpoint::cia302

#endif
