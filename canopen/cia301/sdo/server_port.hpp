// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_SERVER_PORT_HPP
#define CANOPEN_CIA301_SDO_SERVER_PORT_HPP

#include "canopen/cia301/nmt/bus_service.hpp"
#include "canopen/cia301/sdo/parameters.hpp"
#include "canopen/cia301/sdo/server.hpp"

namespace counterpoint::cia301
{

/// Number of an SDO server; its object is 1200h + number. 0 is the default server.
struct SdoServerNumber
{
    std::uint8_t value; ///< 0 to 127.
};

/// An SDO server on the bus: its identifiers, its states, its pace. Also the hook of its object. The default server has
/// 600h and 580h + node-ID; a further one has what its object says, off at first. Server and sink are kept by
/// reference. Not reentrant.
class SdoServerPort final : public NumberHook, public BusService
{
  public:
    /// @brief The default server.
    SdoServerPort(SdoServer& server, FrameSink& sink, NodeId node) noexcept;
    /// @brief A further one, `number` from 1 on. [SRS_SDO_018]
    SdoServerPort(SdoServer& server, FrameSink& sink, SdoServerNumber number) noexcept;

    [[nodiscard]] bool Wants(std::uint32_t identifier) const noexcept override;
    [[nodiscard]] bool Uses(std::uint32_t identifier) const noexcept override;
    /// @brief Reset communication with this node-ID; a running transfer is forgotten.
    void ResetCommunication(NodeId node) noexcept override;
    [[nodiscard]] NumberHook* Objects() noexcept override
    {
        return this;
    }
    /// @brief A frame from the bus; see SdoServer. [SRS_SDO_016]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept override;
    /// @brief Sends what is to be sent until the sink is full; closes the transfer with 0800 0022h in a state that has
    /// no SDO. At most kMaxBlockSize frames. [SRS_SDO_014, SRS_SDO_016]
    void OnCycle(const Moment& moment) noexcept override;
    /// @brief The sink may have room: sends the answer that found none, and nothing else.
    void OnRoom() noexcept
    {
        static_cast<void>(Flush());
    }

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    void Put(const SdoAnswer& answer) noexcept;
    [[nodiscard]] bool Flush() noexcept;

    SdoServer& server_;
    FrameSink& sink_;
    SdoServerNumber number_;
    SdoParameters parameters_;
    SdoAnswer waiting_; ///< Found no room in the sink.
};

} // namespace counterpoint::cia301

#endif
