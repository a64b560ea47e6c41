// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_EL6751_SDOS_HPP
#define CANOPEN_START_UP_EL6751_SDOS_HPP

#include "canopen/start_up/el6751/slaves.hpp"

namespace counterpoint::cia302
{

/// Resets a slave and carries out its SDOs, row by row: phases kResetting, kRows, kFailed. [SRS_ELM_003, SRS_ELM_025]
class El6751Sdos
{
  public:
    /// @brief Both are kept by reference.
    El6751Sdos(El6751Slaves& slaves, El6751Pdos& pdos) noexcept;

    /// @brief Reset communication as soon as the queue has room, then Begin. The status stays as it was until the slave
    /// answers.
    void Reset(NodeId node, Instant now) noexcept;
    /// @brief Begins with the first row; whatever the slave did is ended. `code` is its NodeState until it answers.
    void Begin(NodeId node, std::int16_t code, Instant now) noexcept;
    /// @brief One step of the slave. True: every row was answered.
    [[nodiscard]] bool Drive(NodeId node, Instant now) noexcept;

  private:
    [[nodiscard]] El6751Context Context(NodeId node) const noexcept;
    void BeginTransfer(NodeId node, Instant now) noexcept;
    void EndTransfer(NodeId node, Instant now) noexcept;
    void StopUnread(NodeId node, Instant now) noexcept;
    void Fail(NodeId node, std::int16_t code, Instant now) noexcept;

    StartUpParts parts_;
    El6751Slaves& slaves_;
    El6751Pdos& pdos_;
    SafetyReader reader_;
};

} // namespace counterpoint::cia302

#endif
