// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/owned_channel.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <array>
#include <utility>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
template <typename ShippedChannel, typename Storage> class Owned final : public OwnedChannel
{
  public:
    Owned() : channel_(storage_.Handle())
    {
    }
    [[nodiscard]] Channel& Voice() noexcept override
    {
        return channel_;
    }
    [[nodiscard]] std::uint8_t* Bytes() noexcept override
    {
        return reinterpret_cast<std::uint8_t*>(&storage_);
    }
    [[nodiscard]] std::size_t Size() const noexcept override
    {
        return sizeof(storage_);
    }
    [[nodiscard]] std::size_t VoiceSize() const noexcept override
    {
        return sizeof(channel_);
    }

  private:
    Storage storage_{};
    ShippedChannel channel_;
};

template <std::uint8_t kSlots, std::uint8_t kEntries> std::unique_ptr<OwnedChannel> MakeA()
{
    return std::make_unique<Owned<channel_a::Channel, channel_a::StorageFor<kSlots, kEntries>>>();
}

template <std::uint8_t kSlots, std::uint8_t kEntries> std::unique_ptr<OwnedChannel> MakeB()
{
    return std::make_unique<Owned<channel_b::Channel, channel_b::StorageFor<kSlots, kEntries>>>();
}

using Maker = std::unique_ptr<OwnedChannel> (*)();
using Makers = std::array<Maker, kMaxSrdoCount>;

template <std::uint8_t kEntries, std::size_t... kIndex> constexpr Makers MakersA(std::index_sequence<kIndex...> indices)
{
    static_cast<void>(indices);
    return {{&MakeA<static_cast<std::uint8_t>(kIndex + 1U), kEntries>...}};
}

template <std::uint8_t kEntries, std::size_t... kIndex> constexpr Makers MakersB(std::index_sequence<kIndex...> indices)
{
    static_cast<void>(indices);
    return {{&MakeB<static_cast<std::uint8_t>(kIndex + 1U), kEntries>...}};
}

constexpr Makers kUsualA = MakersA<kUsualMapEntries>(std::make_index_sequence<kMaxSrdoCount>());
constexpr Makers kWideA = MakersA<kMaxMapEntries>(std::make_index_sequence<kMaxSrdoCount>());
constexpr Makers kUsualB = MakersB<kUsualMapEntries>(std::make_index_sequence<kMaxSrdoCount>());
constexpr Makers kWideB = MakersB<kMaxMapEntries>(std::make_index_sequence<kMaxSrdoCount>());
} // namespace

std::unique_ptr<OwnedChannel> MakeChannel(const Letter letter, const ChannelRoom& room)
{
    const bool is_wide = room.map_entries > kUsualMapEntries;
    const Makers& of_a = is_wide ? kWideA : kUsualA;
    const Makers& of_b = is_wide ? kWideB : kUsualB;
    return ((letter == Letter::kA) ? of_a : of_b).at(room.slots - 1U)();
}

ChannelRoom RoomOf(const DeviceConfig& config) noexcept
{
    return {config.srdo_count, config.map_entries};
}

std::optional<BitPlace> FindConfigBit(const Letter letter, const DeviceConfig& config, const ConfigAddress& address,
                                      const std::uint8_t bit)
{
    const std::unique_ptr<OwnedChannel> trial = MakeChannel(letter, RoomOf(config));
    trial->Voice().Restart(config);
    // What changes when the value does is looked at bit by bit: the one whose flip alone changes the value is it, and
    // not a check sum beside it.
    const std::uint32_t wanted = std::uint32_t{1U} << bit;
    trial->Voice().Store({address, wanted});
    const std::vector<std::uint8_t> set(trial->Bytes(), trial->Bytes() + trial->Size());
    trial->Voice().Store({address, 0U});
    for (std::size_t offset = 0U; offset < set.size(); ++offset)
    {
        std::uint8_t& byte = trial->Bytes()[offset];
        const std::uint8_t kept = byte;
        for (std::uint8_t place = 0U; place < 8U; ++place)
        {
            const bool differs = (((set[offset] ^ kept) >> place) & 1U) != 0U;
            byte = static_cast<std::uint8_t>(kept ^ (1U << place));
            const bool is_it = differs && trial->Voice().Load(address).value == wanted;
            byte = kept;
            if (is_it)
            {
                return BitPlace{offset, place};
            }
        }
    }
    return std::nullopt;
}
} // namespace counterpoint::runtime
