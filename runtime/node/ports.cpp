// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/ports.hpp"

#include "canopen/device/safety_queue.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kRestartAfterMs = 200U;
constexpr std::uint32_t kOneIdentifier = 0x7FFU;
constexpr std::uint32_t kBlockOf128 = 0x780U;

host::LiveOptions OptionsOfServices()
{
    return {host::RestartPolicy::kTimed, kRestartAfterMs, host::kReconnectAfterMs, {}, 0U, host::kAnswerMs};
}

/// Nothing old is released, however the frames came. [SRS_NODE_031]
host::LiveOptions OptionsOfSrdos()
{
    host::LiveOptions options = OptionsOfServices();
    options.oldest_ms = kOldestSrdoMs;
    return options;
}

/// 001h, 100h to 17Fh, 180h: whole powers of two; the device leaves out 100h. With two controllers the first one has
/// the odd ones of the pairs, the second one the even ones.
host::LiveOptions OptionsOfSafety(const bool is_alone)
{
    host::LiveOptions options = OptionsOfSrdos();
    options.filters = {{kGfcIdentifier, kOneIdentifier, false}};
    if (is_alone)
    {
        options.filters.push_back({kFirstSrdoIdentifier - 1U, kBlockOf128, false});
        options.filters.push_back({kLastSrdoIdentifier, kOneIdentifier, false});
    }
    else
    {
        options.filters.push_back({kFirstSrdoIdentifier, kBlockOf128 | 1U, false});
    }
    return options;
}

host::LiveOptions OptionsOfInverse()
{
    host::LiveOptions options = OptionsOfSrdos();
    options.filters = {{kFirstSrdoIdentifier + 1U, kBlockOf128 | 1U, false},
                       {kLastSrdoIdentifier, kOneIdentifier, false}};
    return options;
}
} // namespace

NodePorts::NodePorts(const std::string& first, const std::string& second)
    : safety_(host::OpenLiveBus(first, OptionsOfSafety(second.empty()))),
      services_(host::OpenLiveBus(first, OptionsOfServices())),
      inverse_(second.empty() ? nullptr : host::OpenLiveBus(second, OptionsOfInverse()))
{
}

NodePorts::NodePorts(std::unique_ptr<host::LiveBus> safety, std::unique_ptr<host::LiveBus> services,
                     std::unique_ptr<host::LiveBus> inverse) noexcept
    : safety_(std::move(safety)), services_(std::move(services)), inverse_(std::move(inverse))
{
}

hal::CanGuarantees NodePorts::Guarantees() const noexcept
{
    return {hal::Guarantee::kGiven, hal::Guarantee::kGiven, hal::Guarantee::kGiven};
}

std::uint32_t NodePorts::LostFrames() const
{
    return safety_->Health().lost_frames + services_->Health().lost_frames +
           (inverse_ ? inverse_->Health().lost_frames : 0U);
}

std::uint32_t NodePorts::StaleFrames() const
{
    return safety_->Health().stale_frames + (inverse_ ? inverse_->Health().stale_frames : 0U);
}

/// Null at the last place: there is no second controller.
std::array<host::LiveBus*, 3U> NodePorts::Buses() const noexcept
{
    return {safety_.get(), services_.get(), inverse_.get()};
}

std::uint32_t NodePorts::Malformed() const
{
    return safety_->Health().malformed + services_->Health().malformed + (inverse_ ? inverse_->Health().malformed : 0U);
}

std::string NodePorts::Problem() const
{
    std::string problem;
    for (const host::LiveBus* const bus : Buses())
    {
        problem = (problem.empty() && bus != nullptr) ? bus->Problem() : problem;
    }
    return problem;
}

host::BusState NodePorts::TakeAbsence()
{
    host::BusState absence = host::BusState::kInvalid;
    const std::array<host::LiveBus*, 3U> buses = Buses();
    for (std::size_t place = 0U; place < buses.size(); ++place)
    {
        const host::BusHealth health = (buses[place] == nullptr) ? host::BusHealth{} : buses[place]->Health();
        absence = (health.absences != absences_[place]) ? health.absence : absence;
        absences_[place] = health.absences;
    }
    return absence;
}

host::BusState NodePorts::State() const
{
    const host::BusState services = services_->Health().state;
    const std::array<host::BusState, 3U> states{services, safety_->Health().state,
                                                inverse_ ? inverse_->Health().state : services};
    const auto is_there = [&states](const Word<host::BusState>& each)
    { return std::find(states.begin(), states.end(), each.meaning) != states.end(); };
    const auto* const worst = std::find_if(std::begin(kBusWords), std::end(kBusWords), is_there);
    return (worst == std::end(kBusWords)) ? host::BusState::kInvalid : worst->meaning;
}

hal::TransmitStatus NodePorts::DoTransmit(const CanFrame& frame) noexcept
{
    const bool is_safety = device::IsSafetyIdentifier(frame.identifier);
    host::LiveBus* const first = is_safety ? safety_.get() : services_.get();
    host::LiveBus* const bus = (frame.port == CanPortId::kFirst) ? first : inverse_.get();
    if (bus == nullptr || (is_safety && has_ended_))
    {
        return hal::TransmitStatus::kRefused;
    }
    switch (bus->Send(host::FromCanFrame(frame)))
    {
    case host::SendResult::kSent:
        return hal::TransmitStatus::kAccepted;
    case host::SendResult::kBusOff:
        return hal::TransmitStatus::kBusOff;
    case host::SendResult::kQueueFull:
    case host::SendResult::kDown:
        return hal::TransmitStatus::kQueueFull;
    case host::SendResult::kRefused:
    case host::SendResult::kInvalid:
        break;
    }
    return hal::TransmitStatus::kRefused;
}
} // namespace counterpoint::runtime
