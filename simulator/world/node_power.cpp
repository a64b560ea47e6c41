// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

// How a node comes to life and loses it, and its controllers. [SRS_SIM_036, SRS_SIM_037]
namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kTransmitCapacity = 16U;
constexpr ObjectAddress kSerialNumber{0x1018U, 4U};
constexpr std::uint32_t kByteBits = 8U;

std::uint64_t DetailsOf(const cia301::ReceivedEmergency& emergency)
{
    std::uint64_t details = 0U;
    for (const std::uint8_t byte : emergency.details)
    {
        details = (details << kByteBits) | byte;
    }
    return details;
}
} // namespace

// Two controllers hear each other on the one bus: the second takes the inverse frames of SRDOs (even identifiers), the
// first everything else.
void Node::ConnectControllers(const std::uint32_t count)
{
    bus_nodes_.push_back(can_.ConnectPort(CanPortId::kFirst, bus_, kTransmitCapacity));
    if (count == 1U)
    {
        return;
    }
    bus_nodes_.push_back(can_.ConnectPort(CanPortId::kSecond, bus_, kTransmitCapacity));
    constexpr std::uint32_t kLastIdentifier = 0x7FFU;
    bus_.AcceptNone(bus_nodes_[0U]);
    bus_.AcceptNone(bus_nodes_[1U]);
    bus_.AcceptRange(bus_nodes_[0U], 0U, kFirstSrdoIdentifier - 1U);
    bus_.AcceptRange(bus_nodes_[0U], kLastSrdoIdentifier + 1U, kLastIdentifier);
    for (std::uint32_t identifier = kFirstSrdoIdentifier; identifier <= kLastSrdoIdentifier; ++identifier)
    {
        const bool is_normal = (identifier & 1U) != 0U;
        bus_.AcceptRange(bus_nodes_[is_normal ? 0U : 1U], identifier, identifier);
    }
}

void Node::Rehearse()
{
    refused_write_.reset();
    // What stood in RAM is gone with the supply, wild pointers too: none may be used on the way up.
    image_.RestorePointers();
    may_be_wild_ = false;
    assembly_.PowerOff();
    const bool is_up = assembly_.Device().PowerOn(Instants().a) == device::LoadResult::kLoaded;
    if (refused_write_ && place_.file == nullptr) // Whoever manages the others finds it and says so.
    {
        throw runtime::RefusalOf(model_, *refused_write_, refused_);
    }
    if (!is_up)
    {
        throw cia306::InputError(model_.File(), 0U,
                                 {"the kernel refuses this device, reason " +
                                      std::to_string(static_cast<unsigned>(started_)) + " of StartResult",
                                  "SRDOs, objects and times of 0x5F00 within the ranges of DeviceConfig"});
    }
}

void Node::OnStart() noexcept
{
    image_.RestorePointers();
    may_be_wild_ = false;
    application_.ForgetFault();
    if (self_test_ != nullptr)
    {
        self_test_->Start();
    }
}

void Node::OnNoStart(const StartResult result) noexcept
{
    started_ = result;
}

void Node::OnRefused(const runtime::ConfigurationWrite& write, const AbortCode code) noexcept
{
    if (!refused_write_)
    {
        refused_write_ = write;
        refused_ = code;
    }
}

void Node::OnLoaded(const std::uint8_t groups) noexcept
{
    has_restarted_ = has_restarted_ || (groups & cia301::kApplicationGroup) != 0U;
    if (serial_ && place_.file != nullptr && (groups & cia301::kCommunicationGroup) != 0U)
    {
        Store(kSerialNumber, *serial_);
    }
}

void Node::OnResetCommunication(const std::vector<std::string>& refusals) noexcept
{
    static_cast<void>(refusals);
    state_ = cia301::NodeState::kInvalid;
}

void Node::OnTime(const cia301::TimeOfDay& time, const Instant now) noexcept
{
    static_cast<void>(now);
    journal_.Tell({Now(), EventKind::kTime, place_.index, 0U, time.ms, time.days});
}

void Node::OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept
{
    journal_.Tell({Now(), EventKind::kEmergency, place_.index, 0U,
                   (std::uint64_t{emergency.node.value} << 24U) | (std::uint64_t{emergency.error_register} << 16U) |
                       emergency.code,
                   DetailsOf(emergency)});
}

void Node::StartFresh()
{
    queue_.reset();
    is_hung_ = false;
    try
    {
        is_on_ = true;
        Guarded([this]() { Rehearse(); }); // A part that hangs does so at the start, too.
    }
    catch (const cia306::InputError&)
    {
        // The rehearsal went well: a fault has hit the device's tables since.
        is_on_ = false;
        next_cycle_ = kNever;
        journal_.Note({Now(), EventKind::kNoStart, place_.index, 0U, 0U, 0U});
        return;
    }
    Settle();
}

// Cycles and watchdog begin with the kernel.
void Node::BeginCycles()
{
    has_restarted_ = false;
    state_ = cia301::NodeState::kInvalid; // Followed again, even if it is the same.
    watchdog_.Start(runtime::WindowOf(model_.Config()));
    was_alive_ = true;
    voice_a_ = Voice{};
    voice_b_ = Voice{};
    shown_agreed_ = 0U;
    shown_matched_ = 0U;
    times_.fill(PairTimes{});
    fraction_sum_ = 0;
    next_cycle_ = Now();
    ScheduleNext();
    cycles_to_send_ = 0U;
    cycles_per_send_ = 0U;
}

void Node::PowerOn()
{
    const bool is_again = next_cycle_ == kNever;
    for (const host::NodeIndex node : bus_nodes_)
    {
        bus_.SwitchOn(node); // Without what it said when it was rehearsed.
    }
    if (is_again)
    {
        BeginCounters();
    }
    StartFresh();
    journal_.Tell({Now(), EventKind::kPowerOn, place_.index, 0U, 0U, 0U});
    SettleNextEvent();
}

void Node::BeginCounters()
{
    const InstantPair now = clocks_.Now();
    clocks_.A().Jump(Now(), static_cast<std::int32_t>(setup_.counter_a.start_us - now.a.us));
    clocks_.B().Jump(Now(), static_cast<std::int32_t>(setup_.counter_b.start_us - now.b.us));
}

void Node::PowerOff()
{
    is_on_ = false;
    is_hung_ = false;
    state_ = cia301::NodeState::kInvalid;
    condition_ = device::BusCondition::kActive;
    next_cycle_ = kNever;
    serve_at_ = kNever;
    look_at_ = kNever;
    queue_.reset();
    for (const host::NodeIndex node : bus_nodes_)
    {
        bus_.SwitchOff(node);
    }
    for (SlotIndex slot = 0U; slot < model_.Config().srdo_count; ++slot)
    {
        if (((open_ >> slot) & 1U) != 0U)
        {
            const PairTimes& times = times_.at(slot);
            journal_.Note({Now(), EventKind::kOutput, place_.index, NumberOf(slot), 0U, 0U, times.last_good_normal,
                           times.last_inverse});
        }
    }
    open_ = 0U;
    application_.Run(open_, Now(), false); // Without supply no value counts.
    journal_.Tell({Now(), EventKind::kPowerOff, place_.index, 0U, 0U, 0U});
    SettleNextEvent();
}

void Node::ResetNode()
{
    if (is_on_ && !is_hung_)
    {
        StartFresh();
        LookAtOutput();
        SettleNextEvent();
    }
}

void Node::ResetCommunication()
{
    if (place_.file == nullptr)
    {
        for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational})
        {
            journal_.Tell({Now(), EventKind::kNmt, place_.index, 0U, static_cast<std::uint64_t>(state), 0U});
        }
    }
    Obey(cia301::NmtCommand::kResetCommunication);
}

void Node::Poll(const std::size_t capacity, const std::size_t fault)
{
    queue_capacity_ = capacity;
    queue_fault_ = (capacity == 0U) ? queue_fault_ : fault;
}

void Node::OnFrame(const StampedFrame& frame)
{
    if (queue_capacity_ == 0U && queue_ == nullptr)
    {
        Take(frame);
        return;
    }
    if (!is_on_)
    {
        return;
    }
    if (queue_ == nullptr)
    {
        queue_ = std::make_unique<host::FrameQueue>(queue_capacity_);
    }
    if (queue_->Size() >= queue_capacity_ && queue_capacity_ != 0U && queue_fault_ != kNoFaultIndex)
    {
        journal_.Note({Now(), EventKind::kFault, place_.index, 0U, queue_fault_, 0U});
        queue_fault_ = kNoFaultIndex;
    }
    queue_->OnFrame(frame);
}

void Node::OnConfirm(const StampedFrame& frame)
{
    if (queue_ == nullptr)
    {
        TakeConfirmation(frame);
        return;
    }
    queue_->OnConfirm(frame); // Behind the frames that wait.
}

void Node::OnOverflow()
{
    TakeOverflow();
}

void Node::DrainQueue()
{
    if (queue_ == nullptr)
    {
        return;
    }
    class Sink final : public host::FrameSink
    {
      public:
        explicit Sink(Node& node) : node_(node)
        {
        }
        void OnFrame(const StampedFrame& frame) override
        {
            node_.Take(frame);
        }
        void OnConfirm(const StampedFrame& frame) override
        {
            node_.TakeConfirmation(frame);
        }
        void OnOverflow() override
        {
            node_.TakeOverflow();
        }

      private:
        Node& node_;
    };
    Sink sink(*this);
    const std::unique_ptr<host::FrameQueue> queue = std::move(queue_);
    queue->Drain(sink);
}
} // namespace counterpoint::simulator
