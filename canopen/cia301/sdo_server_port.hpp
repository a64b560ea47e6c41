// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_SERVER_PORT_HPP
#define CANOPEN_CIA301_SDO_SERVER_PORT_HPP

#include "canopen/cia301/frame_sink.hpp"
#include "canopen/cia301/number_hook.hpp"
#include "canopen/cia301/sdo_server.hpp"

namespace counterpoint::cia301
{

/// The default SDO server on the bus: its identifiers (600h and 580h + node-ID), its states, its pace. Also the hook of
/// 1200h. Server and sink are kept by reference. Not reentrant.
class SdoServerPort final : public NumberHook
{
  public:
    SdoServerPort(SdoServer& server, FrameSink& sink, NodeId node) noexcept;

    /// @brief Reset communication with this node-ID; a running transfer is forgotten.
    void Reset(NodeId node) noexcept;
    /// @brief A frame from the bus; see SdoServer. [SRS-SDO-016]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept;
    /// @brief Sends what is to be sent until the sink is full; closes the transfer with 0800 0022h in a state that has
    /// no SDO. At most kMaxBlockSize frames. [SRS-SDO-014, SRS-SDO-016]
    void OnCycle(const Moment& moment) noexcept;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    void Put(const SdoAnswer& answer) noexcept;
    [[nodiscard]] bool Flush() noexcept;

    SdoServer& server_;
    FrameSink& sink_;
    NodeId node_;
    SdoAnswer waiting_; ///< Found no room in the sink.
};

} // namespace counterpoint::cia301

#endif
