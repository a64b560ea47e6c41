// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_OPERATION_HPP
#define CANOPEN_START_UP_EL6751_OPERATION_HPP

#include "canopen/start_up/el6751/sdos.hpp"

namespace counterpoint::cia302
{

/// Leads a slave from its last SDO to OPERATIONAL (supervision, safety gate, NMT start), watches those that run, their
/// TxPDOs and errors, and stops and holds slaves. One that is held or stopped is not supervised, and no RxPDO is sent
/// to it. [SRS_ELM_026, SRS_ELM_029, SRS_ELM_034, SRS_ELM_035, SRS_ELM_036, SRS_ELM_037, SRS_ELM_038, SRS_ELM_039,
/// SRS_ELM_040, SRS_ELM_041, SRS_ELM_042, SRS_ELM_043, SRS_ELM_048, SRS_ELM_049]
class El6751Operation
{
  public:
    /// @brief All are kept by reference.
    El6751Operation(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos) noexcept;

    /// @brief One step of the slave, whatever its phase is. Once a cycle.
    void Drive(NodeId node, Instant now) noexcept;
    /// @brief One step of a slave that was started.
    void Watch(NodeId node, Instant now) noexcept;
    /// @brief Starts the slave; a safety slave is verified first.
    void Start(NodeId node, Instant now) noexcept;
    /// @brief Somebody commanded the slave while its start waited: it is verified once more.
    void OnStartDropped(NodeId node, Instant now) noexcept;
    /// @brief Error control found what `code` says, or the slave restarted.
    void OnFault(NodeId node, std::int16_t code, Instant now) noexcept;
    /// @brief The slave is not started; `code` is its NodeState.
    void Hold(NodeId node, std::int16_t code, Instant now) noexcept;

  private:
    void Begin(NodeId node, Instant now) noexcept;
    void Supervise(NodeId node, Instant now) noexcept;
    void DriveVerify(NodeId node, Instant now) noexcept;
    void DriveStart(NodeId node, Instant now) noexcept;
    void Run(NodeId node, Instant now) noexcept;
    [[nodiscard]] std::int16_t FaultOf(NodeId node) noexcept;
    void React(NodeId node, std::int16_t code, Instant now) noexcept;
    void VerifyAgain(NodeId node, Instant now) noexcept;
    void WatchIdle(NodeId node, Instant now) noexcept;
    void Check(NodeId node, bool is_suspect, Instant now) noexcept;
    void Stop(NodeId node, El6751Event event, Instant now) noexcept;
    void SendStop(NodeId node, Instant now) noexcept;
    void Deactivate(NodeId node, Instant now) noexcept;
    void TellDeactivated(NodeId node, Instant now) noexcept;
    void StopOthers(NodeId node, Instant now) noexcept;
    void Refuse(NodeId node, Instant now) noexcept;

    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    El6751Sdos& sdos_;
    SafetyReader reader_;
};

} // namespace counterpoint::cia302

#endif
