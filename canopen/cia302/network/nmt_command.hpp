// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_NMT_COMMAND_HPP
#define CANOPEN_CIA302_NETWORK_NMT_COMMAND_HPP

#include "canopen/cia301/nmt/command.hpp"
#include "canopen/cia301/nmt/slave.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

using cia301::IsNmtCommand;
using cia301::NmtCommand;
using cia301::NodeId;

/// A command for one node, or for all with node 0.
struct NmtRequest
{
    NmtCommand command;
    NodeId node;
    Instant since{0U};   ///< When it was asked for.
    bool is_halt{false}; ///< Stop of a safety slave that is refused: NmtMaster::Halt.
};

/// Is told of each command when it leaves; for the own node no frame leaves and the listener alone acts.
class NmtListener
{
  public:
    /// @brief The sink took the frame, or the command is for the own node.
    virtual void OnNmtSent(const NmtRequest& request, Instant now) noexcept = 0;
    /// @brief A start was taken and did not leave: its slave has no permission any more.
    virtual void OnStartDropped(NodeId node, Instant now) noexcept;

  protected:
    NmtListener() noexcept = default;
    ~NmtListener() noexcept = default;
    NmtListener(const NmtListener&) = default;
    NmtListener& operator=(const NmtListener&) = default;
};

inline void NmtListener::OnStartDropped(const NodeId /*node*/, const Instant /*now*/) noexcept
{
}

} // namespace counterpoint::cia302

#endif
