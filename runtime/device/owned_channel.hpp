// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OWNED_CHANNEL_HPP
#define RUNTIME_DEVICE_OWNED_CHANNEL_HPP

#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace counterpoint::runtime
{
/// A shipped channel with exactly as much injected storage as its device needs. The storage is at hand as bytes, so
/// that a fault can flip any bit of it.
class OwnedChannel
{
  public:
    OwnedChannel() = default;
    virtual ~OwnedChannel() = default;
    OwnedChannel(const OwnedChannel&) = delete;
    OwnedChannel& operator=(const OwnedChannel&) = delete;

    [[nodiscard]] virtual Channel& Voice() noexcept = 0;
    [[nodiscard]] virtual std::uint8_t* Bytes() noexcept = 0;
    [[nodiscard]] virtual std::size_t Size() const noexcept = 0;
    /// @brief The channel itself; what it keeps is in the storage.
    [[nodiscard]] virtual std::size_t VoiceSize() const noexcept = 0;
};

/// Which CPU of a device with two a node is.
enum class CpuRole : std::uint8_t
{
    kWhole = 0U, ///< The device has one.
    kA = 1U,
    kB = 2U,
};

enum class Letter : std::uint8_t
{
    kA = 1U,
    kB = 2U,
};

/// @brief Whether a CPU with this role runs the channel.
[[nodiscard]] constexpr bool HasChannel(const CpuRole role, const Letter letter) noexcept
{
    return role == CpuRole::kWhole || (role == CpuRole::kA) == (letter == Letter::kA);
}
/// @brief What a device needs: 1 to 64 slots.
[[nodiscard]] ChannelRoom RoomOf(const DeviceConfig& config) noexcept;
/// @brief A channel with room for so many slots, and 16 entries each where they are enough, else 128.
[[nodiscard]] std::unique_ptr<OwnedChannel> MakeChannel(Letter letter, const ChannelRoom& room);

struct BitPlace
{
    std::size_t offset{0U};
    std::uint8_t bit{0U};
};

/// Where the channel keeps one bit of a configuration value, found by trial on a second channel of the same kind: which
/// bit of the storage changes when that bit of the value does. Nothing if the value does not exist. [SRS_SIM_021]
[[nodiscard]] std::optional<BitPlace> FindConfigBit(Letter letter, const DeviceConfig& config,
                                                    const ConfigAddress& address, std::uint8_t bit);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OWNED_CHANNEL_HPP
