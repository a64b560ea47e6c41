// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_LSS_HPP
#define RUNTIME_DEVICE_LSS_HPP

#include "canopen/cia305/lss_slave.hpp"
#include "canopen/cia306/file/device.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace counterpoint::runtime
{
/// Saves settings of LSS, as LssDevice::Store; empty: they are not kept.
using KeepLss = std::function<cia305::LssStored(const cia305::LssSettings&)>;

/// The LSS slave of a device. Its bit rate is that of the bus: LSS changes none. [SRS_NODE_015, SRS_SIM_062]
class DeviceLss final : private cia305::LssDevice
{
  public:
    /// Identity by the file, `node_id` stands for $NODEID in it. `settings`: what the supply finds. The sink outlives
    /// it. Throws cia306::InputError.
    DeviceLss(cia301::FrameSink& sink, const cia306::Device& file, const cia305::LssSettings& settings,
              std::uint8_t node_id, KeepLss keep);
    DeviceLss(const DeviceLss&) = delete;
    DeviceLss& operator=(const DeviceLss&) = delete;

    /// @brief Of the device now, or what it will be at power-on; 0: LSS has given none.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
    [[nodiscard]] cia305::LssSlave& Slave() noexcept
    {
        return *slave_;
    }
    /// @brief What was configured and not kept is gone. Slave is another one then.
    void PowerOff() noexcept;

  private:
    [[nodiscard]] bool IsSupported(cia305::BitTiming timing) noexcept override;
    [[nodiscard]] cia305::LssStored Store(const cia305::LssSettings& settings) noexcept override;
    void SwitchTo(cia305::BitTiming timing) noexcept override;

    KeepLss keep_;
    cia305::LssParts parts_;
    std::optional<cia305::LssSlave> slave_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_LSS_HPP
