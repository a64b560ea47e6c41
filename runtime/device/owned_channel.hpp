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
/// A shipped channel with exactly as much storage as its device needs. The storage can be reached as bytes, so that a
/// fault can flip any bit of it.
class OwnedChannel
{
  public:
    OwnedChannel() = default;
    virtual ~OwnedChannel() = default;
    OwnedChannel(const OwnedChannel&) = delete;
    OwnedChannel& operator=(const OwnedChannel&) = delete;

    /// @brief The channel.
    [[nodiscard]] virtual Channel& Voice() noexcept = 0;
    /// @brief Its storage as bytes.
    [[nodiscard]] virtual std::uint8_t* Bytes() noexcept = 0;
    /// @brief Number of these bytes.
    [[nodiscard]] virtual std::size_t Size() const noexcept = 0;
    /// @brief Size of the channel object itself, without the storage.
    [[nodiscard]] virtual std::size_t VoiceSize() const noexcept = 0;
};

/// Which CPU a node is, of a device with one CPU or two.
enum class CpuRole : std::uint8_t
{
    kWhole = 0U, ///< The device has one.
    kA = 1U,
    kB = 2U,
};

/// Which of the two channels.
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
/// @brief The room that a channel needs for this device: 1 to 64 slots, and its mapping entries.
[[nodiscard]] ChannelRoom RoomOf(const DeviceConfig& config) noexcept;
/// @brief Makes a channel with room for so many slots, and for 16 entries each where they are enough, else 128.
[[nodiscard]] std::unique_ptr<OwnedChannel> MakeChannel(Letter letter, const ChannelRoom& room);

/// A bit of a channel's storage.
struct BitPlace
{
    std::size_t offset{0U};
    std::uint8_t bit{0U};
};

/// @brief Where a channel keeps one bit of a configuration value. It is found by trial on a second channel of the same
/// kind: the bit of the storage that changes with that bit of the value. Nothing if the value does not exist.
/// [SRS_SIM_021]
[[nodiscard]] std::optional<BitPlace> FindConfigBit(Letter letter, const DeviceConfig& config,
                                                    const ConfigAddress& address, std::uint8_t bit);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OWNED_CHANNEL_HPP
