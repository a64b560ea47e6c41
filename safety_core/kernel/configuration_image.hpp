// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_CONFIGURATION_IMAGE_HPP
#define SAFETY_CORE_KERNEL_CONFIGURATION_IMAGE_HPP

#include "safety_core/kernel/configuration_guard.hpp"
#include "safety_core/kernel/result.hpp"

#include <cstdint>

namespace counterpoint
{

/// What a store keeps beside the items, so that a damaged or foreign configuration is found. [SRS_CFG_215]
struct ImageHeader
{
    std::uint32_t count; ///< Items, numbered from 0.
    std::uint32_t crc;   ///< CRC-32 over addresses and values of all items and 13FEh.
    std::uint8_t valid;  ///< 13FEh when it was saved.
};

struct ItemReply
{
    Result result;
    std::uint32_t value;
};

struct HeaderReply
{
    Result result;
    ImageHeader header;
};

/// The stored configuration as a whole, item by item: what a device with a store saves and loads, and the power-on
/// values. A view on the guard, which keeps it. Loading and restoring takes time for each item (`header.count`) and is
/// refused in OPERATIONAL; a device that cannot spare it in one cycle does it before the first one. [SRS_CFG_049,
/// SRS_CFG_051, SRS_CFG_052, SRS_CFG_053, SRS_CFG_210, SRS_CFG_211, SRS_CFG_212, SRS_CFG_213, SRS_CFG_214, SRS_CFG_216,
/// SRS_CFG_217]
class ConfigurationImage
{
  public:
    /// @brief `guard` outlives it.
    explicit ConfigurationImage(ConfigurationGuard& guard) noexcept : guard_{guard}
    {
    }

    /// @brief That of the configuration as it is. O(items)
    [[nodiscard]] HeaderReply Header() const noexcept
    {
        return HeaderWith(guard_.Valid());
    }
    /// @brief One item, counted from 0: kNotExist behind the last one, kDeviceFault when stopped or where the channels
    /// differ. [SRS_CFG_051]
    [[nodiscard]] ItemReply ReadItem(std::uint32_t number) const noexcept;
    /// @brief One item of a stored image; clears 13FEh. The value has to fit its object (kDamagedImage); rules are
    /// looked at by Load. What is not stored in the channels is left out. [SRS_CFG_052]
    [[nodiscard]] Result LoadItem(std::uint32_t number, std::uint32_t value) const noexcept;
    /// @brief After all items: rechecks everything, and declares it valid if it was and still is. Else the power-on
    /// configuration is restored. O(items)
    [[nodiscard]] Result Load(const ImageHeader& header) const noexcept;
    /// @brief The power-on configuration. O(items)
    [[nodiscard]] Result RestoreDefaults() const noexcept;

  private:
    /// @brief Header of the items as they are, as if 13FEh were `valid`. O(items)
    [[nodiscard]] HeaderReply HeaderWith(std::uint8_t valid) const noexcept;
    /// @brief Of the device: items of each SRDO, and 1300h.
    [[nodiscard]] std::uint32_t ItemCount() const noexcept;
    /// @brief kSuccessful where there is such an item; kDeviceFault when stopped, else kNotExist.
    [[nodiscard]] Result FindItem(std::uint32_t number) const noexcept;
    /// @brief Object of an item; 1300h for every number behind the SRDOs.
    [[nodiscard]] ObjectKey KeyAt(std::uint32_t number) const noexcept;
    /// @brief Power-on value of what is stored there.
    [[nodiscard]] inline std::uint32_t DefaultOf(const ConfigAddress& address) const noexcept;

    ConfigurationGuard& guard_;
};

/// Default identifiers of SRDO 1 for a node-ID. [SRS_CFG_049]
struct Connection
{
    std::uint16_t cob_id_1;
    std::uint16_t cob_id_2;
    std::uint8_t direction;
};
struct NodeId
{
    std::uint32_t value;
};
/// @brief Producer for 1 to 32, consumer for 33 to 64; off with identifiers 0 for all others.
[[nodiscard]] Connection DefaultConnection(NodeId node_id) noexcept;

} // namespace counterpoint

#endif
