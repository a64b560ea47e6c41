// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_BUS_SERVICE_HPP
#define CANOPEN_CIA301_NMT_BUS_SERVICE_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia301/nmt/frame_sink.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// A service that only some devices have: TIME, emergency consumer, SDO clients, further SDO servers. Each of them
/// looks by itself whether the NMT state allows it. [SRS_DEV_020]
class BusService
{
  public:
    /// @brief Whether a data frame with this identifier is for this service at present. May interrupt the other calls.
    [[nodiscard]] virtual bool Wants(std::uint32_t identifier) const noexcept = 0;
    /// @brief Whether this service sends or receives by this identifier at present.
    [[nodiscard]] virtual bool Uses(std::uint32_t identifier) const noexcept = 0;
    /// @brief Reset communication: its objects become as at power-on. `node` is the node-ID from now on.
    virtual void ResetCommunication(NodeId node) noexcept = 0;
    /// @brief The hook of its objects, which gets the values of a configuration after a reset; null: it has none.
    [[nodiscard]] virtual NumberHook* Objects() noexcept = 0;
    /// @brief A frame from the bus. Frames that do not concern the service are ignored.
    virtual void OnFrame(const CanFrame& frame, const Moment& moment) noexcept = 0;
    /// @brief Call once a cycle: times, and what found no room in the sink before.
    virtual void OnCycle(const Moment& moment) noexcept = 0;

  protected:
    BusService() noexcept = default;
    ~BusService() noexcept = default;
    BusService(const BusService&) = default;
    BusService& operator=(const BusService&) = default;
};

} // namespace counterpoint::cia301

#endif
