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
/// Saves settings of LSS as LssDevice::Store does; empty: they are not saved.
using KeepLss = std::function<cia305::LssStored(const cia305::LssSettings&)>;

/// The LSS slave of a device on a host. The bit rate is that of the bus; LSS cannot change it. [SRS_NODE_015,
/// SRS_SIM_062]
class DeviceLss final : private cia305::LssDevice
{
  public:
    /// @brief The identity (1018h) is that of the file, in which `node_id` stands for $NODEID. `settings` are what is
    /// found at power-on. The sink outlives it. Throws cia306::InputError.
    DeviceLss(cia301::FrameSink& sink, const cia306::Device& file, const cia305::LssSettings& settings,
              std::uint8_t node_id, KeepLss keep);
    DeviceLss(const DeviceLss&) = delete;
    DeviceLss& operator=(const DeviceLss&) = delete;

    /// @brief The present node-ID, or the one at power-on; 0: LSS has not given one yet.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
    /// @brief The slave itself; valid until PowerOff.
    [[nodiscard]] cia305::LssSlave& Slave() noexcept
    {
        return *slave_;
    }
    /// @brief Supply off: what was configured and not saved is lost. Slave returns another object afterwards.
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
