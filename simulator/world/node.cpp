// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::int64_t kMillion = 1000000;
constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint8_t kCobIdSub1 = 5U;

hal::GateLimit LimitOf(const DeviceConfig& config)
{
    return {config.cycle_us + config.cycle_tolerance_us};
}

/// A frame of an NMT master, if it is one for this node.
void NoteCommand(Journal& journal, CommandEntry command, const CanFrame& frame, const std::uint8_t node_id)
{
    const bool is_for_it = frame.kind == FrameKind::kData && frame.identifier == 0U && frame.length_bytes >= 2U &&
                           (frame.data[1] == 0U || frame.data[1] == node_id);
    const auto order = static_cast<cia301::NmtCommand>(frame.data[0]);
    if (is_for_it && cia301::IsNmtCommand(order))
    {
        command.closes = order != cia301::NmtCommand::kStart;
        journal.Note(command);
    }
}

runtime::Half HalfOf(const runtime::CpuRole role)
{
    if (role == runtime::CpuRole::kWhole)
    {
        return runtime::Half::kBoth;
    }
    return (role == runtime::CpuRole::kA) ? runtime::Half::kNormal : runtime::Half::kInverse;
}
} // namespace

Node::Node(const NodePlace& place, const NodeSetup& setup, runtime::DeviceModel& model)
    : place_(place), setup_(setup), model_(model), bus_(place.bus), journal_(place.journal),
      clocks_(bus_, {{setup.counter_a.start_us}, {setup.counter_b.start_us}}), watchdog_(bus_),
      output_(bus_, watchdog_, LimitOf(model.Config())), output_tap_(output_, faults_),
      watchdog_tap_(watchdog_, faults_), can_(clocks_, *this),
      channel_a_(runtime::MakeChannel(runtime::Letter::kA, runtime::RoomOf(model.Config()))),
      channel_b_(runtime::MakeChannel(runtime::Letter::kB, runtime::RoomOf(model.Config()))),
      tap_a_(channel_a_->Voice(), Part::kChannelA, faults_, this),
      tap_b_(channel_b_->Voice(), Part::kChannelB, faults_, this), supervisors_(faults_),
      application_(place.index, model, journal_, HalfOf(setup.role)),
      self_test_(setup.self_tests ? std::make_unique<NodeSelfTest>(memory_, image_, Output(), faults_) : nullptr),
      peer_((setup.role == runtime::CpuRole::kWhole)
                ? nullptr
                : std::make_unique<Peer>(
                      RealChannel((setup.role == runtime::CpuRole::kA) ? runtime::Letter::kA : runtime::Letter::kB),
                      Supervision(), LinkConfigOf(setup))),
      assembly_(model, model.Config(),
                {VoiceOf(runtime::Letter::kA), VoiceOf(runtime::Letter::kB), can_, Output(),
                 (peer_ == nullptr) ? Supervision() : peer_->Watchdog(), application_, self_test_.get(), *this,
                 place.file}),
      serial_(setup.serial)
{
    FurnishSelfTest();
    application_.Join(assembly_.Core());
    ConnectControllers(model.ControllerCount());
    if (place.file != nullptr)
    {
        assembly_.Connect(nullptr);
        if (place_.file->is_lss_supported)
        {
            assembly_.UseLss(*place_.file, {model.Config().node_id, {0U}}, nullptr); // Nothing is kept.
        }
        for (const host::NodeIndex node : bus_nodes_)
        {
            bus_.SwitchOff(node); // Whoever has no supply hears nobody.
        }
    }
    SetCounterRate(true, setup.counter_a.drift_ppm);
    SetCounterRate(false, setup.counter_b.drift_ppm);
    const std::int64_t cycle = std::int64_t{model.Config().cycle_us} * kNanosecondsPerMicrosecond * kMillion;
    oscillator_ = kMillion + setup.counter_a.drift_ppm;
    cycle_ns_ = cycle / oscillator_;
    cycle_fraction_ = cycle % oscillator_;
    next_cycle_ = setup.phase;
    next_event_ = setup.phase;
    slot_of_.fill(kNoSlot);
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        if (srdo.direction == kDirectionConsumer)
        {
            TakeIdentifier(srdo.cob_id_1, model.SlotOf(srdo.number).value_or(kNoSlot));
        }
    }
}

void Node::SettleNextEvent() noexcept
{
    next_event_ = std::min(is_hung_ ? kNever : std::min(next_cycle_, serve_at_), look_at_);
}

void Node::Run()
{
    if (!is_on_)
    {
        PowerOn();
    }
    else if (!is_hung_ && Now() >= next_cycle_)
    {
        Cycle();
    }
    else
    {
        Serve();
        LookAtOutput();
    }
    SettleNextEvent();
}

void Node::Cycle()
{
    application_.SetNow(Now());
    DrainQueue();
    if (is_hung_)
    {
        return;
    }
    if (cycles_per_send_ != 0U && setup_.role != runtime::CpuRole::kB) // CPU B follows.
    {
        SendByApplication();
    }
    if (is_hung_)
    {
        return;
    }
    seen_acknowledge_a_ = Level(Part::kAcknowledgeA, seen_acknowledge_a_);
    seen_acknowledge_b_ = Level(Part::kAcknowledgeB, seen_acknowledge_b_);
    const CycleCall call{Instants(), seen_acknowledge_a_, seen_acknowledge_b_};
    LookAtBus();
    Guarded(
        [this, &call]()
        {
            if (self_test_ == nullptr)
            {
                RequireSound();
            }
            RunKernel(call);
        });
    if (place_.insight == Insight::kTapped)
    {
        NoteEffects();
        NoteSelfTest();
        LookInside();
    }
    LookAtOutput();
    const bool has_restarted = has_restarted_;
    Settle();
    if (!is_hung_)
    {
        const PartCondition& condition = faults_.Condition(Part::kApplication);
        if (application_.Run(open_, Now(), condition.is_faulty))
        {
            faults_.HasEffect(condition);
        }
        if (!has_restarted)
        {
            ScheduleNext();
        }
    }
}

/// What follows when the device was called: it may have obeyed a command.
void Node::Settle()
{
    if (is_hung_ || !is_on_)
    {
        return;
    }
    if (has_restarted_)
    {
        BeginCycles();
    }
    const cia301::NodeState state = assembly_.Device().State();
    if (state == state_)
    {
        return;
    }
    state_ = state;
    if (place_.file != nullptr)
    {
        journal_.Tell(
            {Now(), EventKind::kNmt, place_.index, 0U, static_cast<std::uint64_t>(cia301::KernelState(state)), 0U});
    }
    if (place_.file != nullptr && assembly_.NewNodeId())
    {
        journal_.Note({Now(), EventKind::kNewNodeId, place_.index, 0U, *assembly_.NewNodeId(), 0U});
    }
    if (state == cia301::NodeState::kOperational)
    {
        FollowConfiguration();
    }
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left. What a manager may have
/// written is followed; without services they are those of the file.
void Node::FollowConfiguration()
{
    cycles_per_send_ = assembly_.CyclesPerSend();
    cycles_to_send_ = 0U;
    if (place_.file == nullptr)
    {
        return;
    }
    slot_of_.fill(kNoSlot);
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + model_.NumberOf(slot));
        if (assembly_.Core().GetParameters({index}).direction == kDirectionConsumer)
        {
            TakeIdentifier(ToValue(assembly_.Core().ReadObject({index, kCobIdSub1}).data), slot);
        }
    }
    application_.Follow(assembly_.Core(), model_);
}

/// Of the normal frame; that of the inverse frame is the next one.
void Node::TakeIdentifier(const std::uint32_t identifier, const SlotIndex slot)
{
    if (identifier >= kFirstSrdoIdentifier && identifier < kLastSrdoIdentifier)
    {
        slot_of_.at(identifier - kFirstSrdoIdentifier) = slot;
        slot_of_.at(identifier - kFirstSrdoIdentifier + 1U) = slot;
    }
}

void Node::LookAtBus()
{
    if (place_.file == nullptr)
    {
        return;
    }
    const bool is_off = std::any_of(bus_nodes_.begin(), bus_nodes_.end(), [this](const host::NodeIndex node)
                                    { return bus_.State(node) == host::ControllerState::kBusOff; });
    const device::BusCondition condition = is_off ? device::BusCondition::kOff : device::BusCondition::kActive;
    if (condition != condition_)
    {
        condition_ = condition;
        assembly_.Device().OnBus(condition);
    }
}

void Node::HandOver()
{
    assembly_.Device().HandOver();
    if (place_.file != nullptr && serve_at_ == kNever)
    {
        serve_at_ = Now() + ReactionTime(bus_);
        SettleNextEvent();
    }
}

/// Between two cycles.
void Node::Serve()
{
    if (is_hung_ || Now() < serve_at_)
    {
        return;
    }
    serve_at_ = kNever;
    Guarded(
        [this]()
        {
            RequireSound();
            assembly_.Device().Serve(Instants().a);
        });
    Settle();
}

void Node::ScheduleNext()
{
    next_cycle_ += cycle_ns_;
    fraction_sum_ += cycle_fraction_;
    if (fraction_sum_ >= oscillator_)
    {
        fraction_sum_ -= oscillator_;
        ++next_cycle_;
    }
}

// The application's own refresh: at once after a change, and every refresh time after the last time.
void Node::SendByApplication()
{
    if (assembly_.Device().State() != cia301::NodeState::kOperational)
    {
        cycles_to_send_ = 0U;
        return;
    }
    const bool has_changed = application_.TakeChange();
    if (cycles_to_send_ != 0U && !has_changed)
    {
        --cycles_to_send_;
        return;
    }
    cycles_to_send_ = cycles_per_send_ - 1U;
    Guarded(
        [this]()
        {
            RequireSound();
            assembly_.SendAll();
        });
}

void Node::Take(const StampedFrame& frame)
{
    if (is_hung_ || !is_on_)
    {
        return;
    }
    NoteCommand(journal_, {Now(), place_.index}, frame.frame, model_.Config().node_id);
    if (place_.insight == Insight::kTapped)
    {
        Follow(frame);
    }
    Guarded(
        [this, &frame]()
        {
            RequireSound();
            const bool is_echo = peer_ != nullptr && peer_->IsEcho(frame.frame);
            is_echo ? assembly_.Device().OnConfirm(Stamped(frame)) : assembly_.Device().OnFrame(Stamped(frame));
            HandOver();
        });
}

void Node::TakeConfirmation(const StampedFrame& frame)
{
    if (is_hung_ || !is_on_)
    {
        return;
    }
    application_.SetNow(Now());
    Guarded(
        [this, &frame]()
        {
            RequireSound();
            assembly_.Device().OnConfirm(Stamped(frame));
            HandOver();
        });
}

void Node::TakeOverflow()
{
    assembly_.Device().OnLoss();
}

// Independent of both channels: a pair is good when it is complete, in order and inverse over all its bytes.
void Node::Follow(const StampedFrame& frame)
{
    const std::uint32_t identifier = frame.frame.identifier;
    const SlotIndex slot = ConsumerOf(frame.frame);
    if (slot == kNoSlot)
    {
        return;
    }
    PairTimes& times = times_.at(slot);
    Payload data{0U, 0U};
    for (std::uint8_t byte = 0U; byte < std::min(frame.frame.length_bytes, kMaxPayloadBytes); ++byte)
    {
        std::uint32_t& word = (byte < 4U) ? data.low : data.high;
        word |= std::uint32_t{frame.frame.data[byte]} << (8U * (byte % 4U));
    }
    if ((identifier & 1U) != 0U)
    {
        times.pending = Now();
        times.data = data;
        times.length_bytes = frame.frame.length_bytes;
        journal_.Tell({Now(), EventKind::kReception, place_.index, NumberOf(slot), identifier, 0U});
        return;
    }
    times.last_inverse = Now();
    const std::uint64_t normal = (std::uint64_t{times.data.high} << 32U) | times.data.low;
    const std::uint64_t inverse = (std::uint64_t{data.high} << 32U) | data.low;
    const std::uint64_t mask = ~std::uint64_t{0U} >> (64U - 8U * std::max<unsigned>(times.length_bytes, 1U));
    const bool is_good =
        times.pending >= 0 && times.length_bytes == frame.frame.length_bytes && ((normal ^ inverse) & mask) == mask;
    times.last_good_normal = is_good ? times.pending : times.last_good_normal;
    times.pending = -1;
    journal_.Tell({Now(), EventKind::kReception, place_.index, NumberOf(slot), identifier, is_good ? 1U : 0U});
}

void Node::LookAtOutput()
{
    const SrdoMask open = output_.Open();
    const SrdoMask changed = open ^ open_;
    open_ = open;
    for (SlotIndex slot = 0U; changed != 0U && slot < model_.Config().srdo_count; ++slot)
    {
        if (((changed >> slot) & 1U) != 0U)
        {
            const PairTimes& times = times_.at(slot);
            journal_.Note({Now(), EventKind::kOutput, place_.index, NumberOf(slot), (open >> slot) & 1U, 0U,
                           times.last_good_normal, times.last_inverse});
        }
    }
    if (place_.insight == Insight::kTapped)
    {
        LookAtWatchdog();
    }
}

void Node::LookAtWatchdog()
{
    const Nanoseconds served = watchdog_tap_.Keep(Now(), cycle_ns_);
    const bool is_alive = watchdog_.IsAlive();
    if (was_alive_ && !is_alive)
    {
        journal_.Note({Now(), EventKind::kWatchdog, place_.index, 0U, 0U, 0U});
    }
    was_alive_ = is_alive;
    look_at_ = std::min({output_.ClosesAt(), watchdog_.TripsAt(), served});
}

void Node::SetNmt(const NmtState state)
{
    if (place_.file == nullptr)
    {
        journal_.Tell({Now(), EventKind::kNmt, place_.index, 0U, static_cast<std::uint64_t>(state), 0U});
    }
    if (state == NmtState::kOperational)
    {
        Obey(cia301::NmtCommand::kStart);
    }
    else
    {
        Obey((state == NmtState::kStopped) ? cia301::NmtCommand::kStop : cia301::NmtCommand::kPreOperational);
    }
}

// As a frame of a master that no bus carried.
void Node::Obey(const cia301::NmtCommand command)
{
    if (is_hung_ || !is_on_)
    {
        return;
    }
    application_.SetNow(Now());
    CanFrame frame{};
    frame.kind = FrameKind::kData;
    frame.port = CanPortId::kFirst;
    frame.length_bytes = 2U;
    frame.data[0] = static_cast<std::uint8_t>(command);
    frame.data[1] = model_.Config().node_id;
    Guarded(
        [this, &frame]()
        {
            RequireSound();
            assembly_.Device().OnFrame({frame, Instants()});
            assembly_.Device().Serve(Instants().a);
        });
    Settle();
}
} // namespace counterpoint::simulator
