// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_CLIENT_PORT_HPP
#define CANOPEN_CIA301_SDO_CLIENT_PORT_HPP

#include "canopen/cia301/nmt/bus_service.hpp"
#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/sdo/parameters.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// What an SDO client of a device is built from; the sink is kept by reference.
struct SdoClientPortParts
{
    FrameSink& sink;
    std::uint8_t number;       ///< 0 to 127; its object is 1280h + number.
    std::uint32_t time_out_us; ///< 2 to 2^30.
    std::uint8_t block_size;   ///< 1 to 127.
};

/// An SDO client of a device, whose server the dictionary names: also the hook of its object, off at first. The
/// application starts a transfer with Client() while IsConnected, and looks at its state once a cycle. Not reentrant.
/// [SRS_SDC_011, SRS_SDC_012]
class SdoClientPort final : public NumberHook, public BusService
{
  public:
    /// @brief Its object is off, so that there is no server.
    explicit SdoClientPort(const SdoClientPortParts& parts) noexcept;

    /// @brief Whether the object names the identifiers of a server.
    [[nodiscard]] bool IsConnected() const noexcept;
    /// @brief Node-ID of the server; 0: not told.
    [[nodiscard]] NodeId Server() const noexcept;
    /// @brief The client, by which transfers are started.
    [[nodiscard]] SdoClient& Client() noexcept;

    [[nodiscard]] bool Wants(std::uint32_t identifier) const noexcept override;
    [[nodiscard]] bool Uses(std::uint32_t identifier) const noexcept override;
    /// @brief Reset communication: off; a running transfer has failed.
    void ResetCommunication(NodeId node) noexcept override;
    [[nodiscard]] NumberHook* Objects() noexcept override
    {
        return this;
    }
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept override;
    /// @brief Goes on with a transfer; gives it up with 0800 0022h in a state that has no SDO.
    void OnCycle(const Moment& moment) noexcept override;

  private:
    [[nodiscard]] ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    std::uint16_t index_;
    SdoParameters parameters_;
    SdoClient client_;
};

} // namespace counterpoint::cia301

#endif
