// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_NMT_COMMAND_HPP
#define CANOPEN_CIA302_NETWORK_NMT_COMMAND_HPP

#include "canopen/cia301/nmt/slave.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

using cia301::NodeId;

/// NMT commands by their bytes on the bus.
enum class NmtCommand : std::uint8_t
{
    kInvalid = 0U,
    kStart = 1U,
    kStop = 2U,
    kPreOperational = 128U,
    kResetNode = 129U,
    kResetCommunication = 130U,
};

/// @brief Whether this is one of the five; a byte from the bus may be anything.
[[nodiscard]] constexpr bool IsNmtCommand(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kStart) || (command == NmtCommand::kStop) ||
           (command == NmtCommand::kPreOperational) || (command == NmtCommand::kResetNode) ||
           (command == NmtCommand::kResetCommunication);
}

/// A command for one node, or for all with node 0.
struct NmtRequest
{
    NmtCommand command;
    NodeId node;
    Instant since{0U}; ///< When it was asked for.
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
