// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/channel_host.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <array>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
template <typename ShippedChannel, typename Storage>
class Host final : public ChannelHost
{
  public:
    Host() : channel_(storage_.Handle())
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

  private:
    Storage storage_{};
    ShippedChannel channel_;
};

template <std::uint8_t kSlots>
std::unique_ptr<ChannelHost> MakeA()
{
    return std::make_unique<Host<channel_a::Channel, channel_a::StorageFor<kSlots>>>();
}

template <std::uint8_t kSlots>
std::unique_ptr<ChannelHost> MakeB()
{
    return std::make_unique<Host<channel_b::Channel, channel_b::StorageFor<kSlots>>>();
}

using Maker = std::unique_ptr<ChannelHost> (*)();

template <std::size_t... kIndex>
constexpr std::array<Maker, sizeof...(kIndex)> MakersA(std::index_sequence<kIndex...> indices)
{
    static_cast<void>(indices);
    return {{&MakeA<static_cast<std::uint8_t>(kIndex + 1U)>...}};
}

template <std::size_t... kIndex>
constexpr std::array<Maker, sizeof...(kIndex)> MakersB(std::index_sequence<kIndex...> indices)
{
    static_cast<void>(indices);
    return {{&MakeB<static_cast<std::uint8_t>(kIndex + 1U)>...}};
}

constexpr std::array<Maker, kMaxSrdoCount> kMakersA = MakersA(std::make_index_sequence<kMaxSrdoCount>());
constexpr std::array<Maker, kMaxSrdoCount> kMakersB = MakersB(std::make_index_sequence<kMaxSrdoCount>());
} // namespace

std::unique_ptr<ChannelHost> MakeChannel(const Letter letter, const std::uint8_t slots)
{
    const std::array<Maker, kMaxSrdoCount>& makers = (letter == Letter::kA) ? kMakersA : kMakersB;
    return makers.at(slots - 1U)();
}

std::optional<BitPlace> FindConfigBit(const Letter letter, const DeviceConfig& config, const ConfigAddress& address,
                                      const std::uint8_t bit)
{
    const std::unique_ptr<ChannelHost> trial = MakeChannel(letter, config.srdo_count);
    trial->Voice().Restart(config);
    // Two values that differ in the wanted bit alone; what else a Store changes is the same both times.
    trial->Voice().Store({address, 0U});
    const std::vector<std::uint8_t> before(trial->Bytes(), trial->Bytes() + trial->Size());
    trial->Voice().Store({address, std::uint32_t{1U} << bit});
    for (std::size_t offset = 0U; offset < before.size(); ++offset)
    {
        const unsigned difference = static_cast<unsigned>(before[offset]) ^ static_cast<unsigned>(trial->Bytes()[offset]);
        for (std::uint8_t place = 0U; place < 8U; ++place)
        {
            if (difference == (1U << place))
            {
                return BitPlace{offset, place};
            }
        }
    }
    return std::nullopt;
}
} // namespace counterpoint::simulator
