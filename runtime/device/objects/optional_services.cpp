// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/objects/optional_services.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/objects/objects.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint16_t kTime = 0x1012U;
constexpr std::uint16_t kHighResolution = 0x1013U;
constexpr std::uint16_t kSources = 0x1028U;
constexpr std::uint16_t kFirstServer = 0x1201U;
constexpr std::uint16_t kLastServer = 0x127FU;
constexpr std::uint16_t kFirstClient = 0x1280U;
constexpr std::uint16_t kLastClient = 0x12FFU;
constexpr std::uint32_t kSilenceUs = 1000000U;
constexpr std::uint8_t kBlock = 64U;
constexpr std::size_t kShownBytes = 32U;
} // namespace

OptionalServices::Serving::Serving(cia301::Dictionary& dictionary, cia301::FrameSink& sink, const std::uint8_t number,
                                   const std::uint32_t longest_bytes)
    : buffer(longest_bytes), server({dictionary, {buffer.data(), longest_bytes}, kSilenceUs, kBlock}),
      port(server, sink, cia301::SdoServerNumber{number}), index(static_cast<std::uint16_t>(kFirstServer - 1U + number))
{
}

OptionalServices::OptionalServices(const cia306::Device& file, cia301::Dictionary& dictionary,
                                   device::Services& services, const HeardBy& heard_by,
                                   const std::uint32_t longest_bytes)
    : sources_(std::min<std::size_t>(LastSubOf(file, kSources), 127U)), time_(services.outbox, heard_by.times),
      emergencies_({sources_.data(), static_cast<std::uint8_t>(sources_.size())}, heard_by.emergencies)
{
    if (file.Find(kTime) != nullptr || file.Find(kHighResolution) != nullptr)
    {
        list_.push_back(&time_);
    }
    if (!sources_.empty())
    {
        list_.push_back(&emergencies_);
    }
    for (std::uint16_t index = kFirstServer; index <= kLastServer; ++index)
    {
        if (file.Find(index) != nullptr)
        {
            const auto number = static_cast<std::uint8_t>(index - kFirstServer + 1U);
            list_.push_back(&servers_.emplace_back(dictionary, services.outbox, number, longest_bytes).port);
        }
    }
    for (std::uint16_t index = kFirstClient; index <= kLastClient; ++index)
    {
        if (file.Find(index) != nullptr)
        {
            const auto number = static_cast<std::uint8_t>(index - kFirstClient);
            const cia301::SdoClientPortParts parts{services.outbox, number, kSilenceUs, kBlock};
            clients_.push_back({cia301::SdoClientPort{parts}, index});
            list_.push_back(&clients_.back().port);
        }
    }
    services.further = {list_.data(), static_cast<std::uint8_t>(list_.size())};
}

cia301::NumberHook* OptionalServices::HookOf(const std::uint16_t index) noexcept
{
    if (index == kTime || index == kHighResolution)
    {
        return &time_;
    }
    if (index == kSources)
    {
        return &emergencies_;
    }
    for (Serving& serving : servers_)
    {
        if (serving.index == index)
        {
            return &serving.port;
        }
    }
    for (Client& client : clients_)
    {
        if (client.index == index)
        {
            return &client.port;
        }
    }
    return nullptr;
}

cia301::TimeStamp& OptionalServices::Time() noexcept
{
    return time_;
}

cia301::SdoClientPort* OptionalServices::ClientOf(const std::uint8_t server) noexcept
{
    for (Client& client : clients_)
    {
        if (client.port.IsConnected() && client.port.Server().value == server)
        {
            return &client.port;
        }
    }
    return nullptr;
}

std::string TextOf(const cia301::TimeOfDay& time)
{
    return "time " + std::to_string(time.ms) + " ms of day " + std::to_string(time.days);
}

std::string TextOf(const cia301::ReceivedEmergency& emergency)
{
    return "emergency of node " + std::to_string(emergency.node.value) + ": " + cia306::Hex(emergency.code, 4) +
           ", register " + cia306::Hex(emergency.error_register, 2) + ", " +
           BytesText(emergency.details, sizeof(emergency.details));
}

std::string BytesText(const std::uint8_t* const bytes, const std::size_t count)
{
    std::string text;
    for (std::size_t place = 0U; place < std::min(count, kShownBytes); ++place)
    {
        text += (place == 0U ? "" : " ") + cia306::Hex(bytes[place], 2).substr(2U);
    }
    return text + (count > kShownBytes ? " ..." : "");
}
} // namespace counterpoint::runtime
