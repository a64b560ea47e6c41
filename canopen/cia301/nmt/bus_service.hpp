// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_BUS_SERVICE_HPP
#define CANOPEN_CIA301_NMT_BUS_SERVICE_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// A service that not every device has, as a device sees it: TIME, emergency consumer, SDO clients, further SDO
/// servers. Each looks into the table of services by state itself. [SRS_DEV_020]
class BusService
{
  public:
    /// @brief Whether a data frame with this identifier is one of its own now. May interrupt the others.
    [[nodiscard]] virtual bool Wants(std::uint32_t identifier) const noexcept = 0;
    /// @brief Reset communication: its objects are as at power-on.
    virtual void ResetCommunication(NodeId node) noexcept = 0;
    /// @brief A frame from the bus; what does not concern it is ignored.
    virtual void OnFrame(const CanFrame& frame, const Moment& moment) noexcept = 0;
    /// @brief Once a cycle.
    virtual void OnCycle(const Moment& moment) noexcept = 0;

  protected:
    BusService() noexcept = default;
    ~BusService() noexcept = default;
    BusService(const BusService&) = default;
    BusService& operator=(const BusService&) = default;
};

} // namespace counterpoint::cia301

#endif
