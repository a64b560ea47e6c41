// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/assembly.hpp"

#include "canopen/cia306/text/input_error.hpp"

namespace counterpoint::runtime
{
namespace
{
using network_plan::StartProfile;

constexpr cia302::SdoTimes kUsualTimes{500000U, 3U};

/// Those of the profile, where the network file says nothing else.
cia302::SdoTimes TimesOf(const network_plan::ManagerPlan& plan)
{
    constexpr std::uint32_t kUsPerMs = 1000U;
    cia302::SdoTimes times = kUsualTimes;
    times = (plan.profile == StartProfile::kEl6751) ? cia302::kEl6751SdoTimes : times;
    times = (plan.profile == StartProfile::kPlcDesigner) ? cia302::kPlcSdoTimes : times;
    times.time_out_us = plan.sdo_time_out_ms ? (*plan.sdo_time_out_ms * kUsPerMs) : times.time_out_us;
    times.tries = plan.sdo_tries.value_or(times.tries);
    return times;
}
constexpr const char* kSlots = "a level slot above 127 node slots, which are above 0";

std::string SlotsOf(const cia302::FlyingMasterTimes& times)
{
    return "level slot " + std::to_string(times.priority_slot) + " ms with node slot " +
           std::to_string(times.device_slot) + " ms";
}

/// The network file goes before the manager's DCF. [SRS_NET_231]
cia306::InputError SlotError(const network_plan::LoadedNetwork& net, const std::string& wrong)
{
    constexpr std::uint8_t kLevelSlot = 4U;
    constexpr std::uint8_t kNodeSlot = 5U;
    const network_plan::NetworkPlan& plan = net.Plan();
    const network_plan::KeyPlaces& places = plan.manager.flying->places;
    const bool is_of_file = places.count("level_slot") + places.count("node_slot") > 0U;
    std::string file = plan.file;
    cia306::Place place = plan.manager.place;
    for (const std::uint8_t sub : {kNodeSlot, kLevelSlot})
    {
        const cia306::Entry* const entry = net.Device().Find(cia302::kFlyingMasterIndex, sub);
        if (!is_of_file && entry != nullptr)
        {
            file = net.Device().file;
            place = entry->ValuePlace();
        }
    }
    return cia306::InputError(file, place, {wrong, kSlots});
}
} // namespace

cia302::FlyingMasterTimes FlyingTimesOf(const network_plan::NetworkPlan& plan)
{
    const network_plan::FlyingPlan flying = plan.manager.flying.value_or(network_plan::FlyingPlan{});
    cia302::FlyingMasterTimes times = cia302::DefaultTimes(cia302::NodeId{plan.manager.node.value_or(1U)});
    times.timeout = flying.timeout_ms.value_or(times.timeout);
    times.delay = flying.delay_ms.value_or(times.delay);
    times.priority = flying.priority.value_or(times.priority);
    times.priority_slot = flying.level_slot_ms.value_or(times.priority_slot);
    times.device_slot = flying.node_slot_ms.value_or(times.device_slot);
    times.detection_cycle = flying.detect_ms.value_or(times.detection_cycle);
    return times;
}

ManagerAssembly::ManagerAssembly(const network_plan::LoadedNetwork& net, cia301::FrameSink& sink,
                                 cia302::ManagerListener& listener)
    : net_(net), times_(TimesOf(net.Plan().manager)), lanes_(sink, times_),
      manager_(cia302::ManagerParts{net.Setup(), sink, listener, Room(),
                                    net.Plan().manager.heartbeat_ms.value_or(std::uint16_t{0U})})
{
    MakeProfile();
    if (net.Plan().manager.flying)
    {
        MakeFlying(sink);
    }
}

cia302::ManagerRoom ManagerAssembly::Room() noexcept
{
    return {records_.data(),
            watched_.data(),
            gates_.data(),
            {commands_.data(), static_cast<std::uint16_t>(commands_.size())},
            {safety_.data(), static_cast<std::uint8_t>(safety_.size())},
            lanes_.All(),
            times_};
}

void ManagerAssembly::MakeProfile()
{
    const cia302::StartUpParts parts = manager_.ProfileParts();
    switch (net_.Plan().manager.profile)
    {
    case StartProfile::kEl6751:
        el6751_pdos_.resize(cia302::El6751PdoCount(net_.Setup()));
        el6751_ = std::make_unique<cia302::El6751StartUp>(
            cia302::El6751Parts{parts,
                                el6751_nodes_.data(),
                                {el6751_pdos_.data(), static_cast<std::uint16_t>(el6751_pdos_.size())},
                                net_.Plan().manager.el6751.value_or(cia302::El6751Times{})});
        Use(*el6751_);
        break;
    case StartProfile::kPlcDesigner:
        plc_ = std::make_unique<cia302::PlcStartUp>(cia302::PlcParts{parts, plc_nodes_.data()});
        Use(*plc_);
        break;
    case StartProfile::kCia302:
    default:
        cia302_ = std::make_unique<cia302::Cia302StartUp>(parts, boots_.data());
        Use(*cia302_);
        break;
    }
}

void ManagerAssembly::Use(cia302::StartUp& profile) noexcept
{
    profile_ = &profile;
    manager_.Use(profile);
}

void ManagerAssembly::MakeFlying(cia301::FrameSink& sink)
{
    const network_plan::ManagerPlan& plan = net_.Plan().manager;
    flying_times_ = FlyingTimesOf(net_.Plan());
    if (!cia302::IsUsable(flying_times_))
    {
        throw SlotError(net_, SlotsOf(flying_times_));
    }
    flying_options_ = plan.flying->options;
    flying_options_.own_producer_ms = plan.heartbeat_ms.value_or(flying_options_.own_producer_ms);
    flying_ = std::make_unique<cia302::FlyingMaster>(
        cia302::FlyingMasterParts{net_.Setup(), flying_times_, flying_options_, sink, manager_.Role()});
    is_held_ = plan.flying->is_by_order;
    manager_.Role().Use(*flying_, is_held_ ? cia302::NegotiationBy::kApplication : cia302::NegotiationBy::kManager);
}

void ManagerAssembly::OnCycle(const Instant now)
{
    const bool is_by_order = net_.Plan().manager.flying.value_or(network_plan::FlyingPlan{}).is_by_order;
    if (is_by_order && !is_held_ && flying_->State() == cia302::FlyingState::kInitialising)
    {
        static_cast<void>(manager_.Role().StartNegotiation(now));
    }
}

void ManagerAssembly::SetHeartbeat(const std::uint16_t period_ms) noexcept
{
    manager_.Heartbeat().SetPeriod(period_ms);
    flying_options_.own_producer_ms = period_ms;
}

std::string ManagerAssembly::Negotiate()
{
    if (flying_ != nullptr && !cia302::IsUsable(flying_times_))
    {
        return SlotsOf(flying_times_) + ", expected " + kSlots;
    }
    const bool is_taken = is_held_;
    is_held_ = false;
    return is_taken ? "taken" : "no negotiation waits for an order, expected flying: {start: by_order}";
}

bool ManagerAssembly::Runs(const cia302::NodeId node) const noexcept
{
    constexpr auto kOperational = static_cast<std::uint8_t>(cia302::SlaveState::kOperational);
    const cia302::NodeRecord& record = manager_.Table().Record(node);
    const bool is_running = manager_.Table().RequestValue(node) == kOperational;
    const bool is_supervised = record.watch != cia302::Watch::kNone;
    const bool was_heard = record.state == cia302::SlaveState::kOperational && !(is_supervised && record.is_presumed);
    const bool is_by_order = !is_supervised && manager_.Status(node).is_started;
    return is_running && (was_heard || (is_by_order && !cia302::DeniesStart(manager_.Table(), node)));
}

bool ManagerAssembly::IsUnheard(const cia302::NodeId node) const noexcept
{
    const bool is_supervised = manager_.Table().Record(node).watch != cia302::Watch::kNone;
    return is_supervised && manager_.Status(node).is_started && !Runs(node) &&
           manager_.Table().RequestValue(node) == static_cast<std::uint8_t>(cia302::SlaveState::kOperational);
}

bool ManagerAssembly::HasFault(const cia302::NodeId node) const noexcept
{
    const cia302::WatchedNode& watched = manager_.Watched().Of(node);
    // Who does not lead verifies nobody.
    const bool is_unverified = manager_.IsActive() && manager_.Gate().State(node) != cia302::GateState::kOpen;
    return watched.is_duplicate || (net_.Setup().IsSafetySlave(node) && (watched.fault != 0U || is_unverified));
}

bool ManagerAssembly::HasUnendedBoot(const cia302::NodeId node) const noexcept
{
    const bool is_booted = cia302_ != nullptr && net_.Setup().Slave(node).Has(cia302::kBootSlave); // Else supervised.
    return is_booted && manager_.IsActive() && !manager_.Status(node).has_ended;
}

bool ManagerAssembly::IsGood(const cia302::NodeId node) const noexcept
{
    constexpr int kNoError = 0; // NodeState.
    const cia302::NodeStatus status = manager_.Status(node);
    const StartProfile profile = net_.Plan().manager.profile;
    bool is_good = (status.letter == 0 || status.letter == 'L') && !HasUnendedBoot(node);
    is_good = (profile == StartProfile::kEl6751) ? status.code == kNoError && !status.has_failed : is_good;
    // Who does not lead has begun no start-up, and so found nothing.
    const int wanted = manager_.IsActive() ? cia302::kPlcStarted : cia302::kPlcOutside;
    const bool has_aborted = status.abort != cia301::SdoAbort::kNone; // Configured all the same. [SRS_PLC_585]
    is_good = (profile == StartProfile::kPlcDesigner) ? status.code == wanted && !has_aborted : is_good;
    return is_good && Runs(node) && !HasFault(node);
}

bool ManagerAssembly::HasDouble() const noexcept
{
    const bool is_halted = flying_ != nullptr && flying_->State() == cia302::FlyingState::kHalted;
    return is_halted || manager_.Watched().Of(net_.Setup().own).is_duplicate;
}

bool ManagerAssembly::HasStarted() const noexcept
{
    bool has_started = !HasDouble();
    for (const auto& slave : net_.Slaves())
    {
        const cia302::NodeId node{slave->plan.node};
        const cia302::NodeStatus status = manager_.Status(node);
        const bool is_needed = net_.Setup().Slave(node).Has(cia302::kInNetwork | cia302::kMandatory);
        const bool is_waiting = el6751_ != nullptr && status.code == cia302::kNodeWaitsForPdos && !status.has_failed;
        const bool has_one = IsGood(node) || (is_waiting && Runs(node) && !HasFault(node));
        has_started = has_started && (has_one || !is_needed);
    }
    return has_started;
}

void ManagerAssembly::OnController(const cia302::ControllerState state, const Instant now) noexcept
{
    manager_.OnBus(state == cia302::ControllerState::kRunning, now);
    if (el6751_ != nullptr)
    {
        el6751_->OnController(state, now);
    }
}

void ManagerAssembly::OnSent(const CanFrame& frame) noexcept
{
    manager_.OnSent(frame);
    if (el6751_ != nullptr)
    {
        el6751_->OnSent(frame);
    }
}

cia302::NmtAnswer ManagerAssembly::Control(const cia302::NodeId node, const std::uint16_t ads_state,
                                           const std::uint16_t device_state, const Instant now) noexcept
{
    return (el6751_ != nullptr) ? el6751_->Control(node, ads_state, device_state, now) : cia302::NmtAnswer::kWrong;
}
} // namespace counterpoint::runtime
