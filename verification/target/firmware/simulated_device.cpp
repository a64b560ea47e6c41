// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/firmware/simulated_device.hpp"

#include "verification/target/firmware/meter.hpp"
#include "verification/target/target.hpp"

namespace counterpoint::target
{
namespace
{

constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kFrameUs = 250U;     // 500 kbit/s, 8 bytes, stuffed.
constexpr std::uint32_t kOffsetBUs = 70000U; // The counters start apart, as on a board.
constexpr std::uint32_t kMostCycles = 20000U;

// In the order of the scenario's words.
constexpr std::uint8_t kNmtCommands[]{1U, 128U, 2U, 129U, 130U};
constexpr SrdoState kStates[]{SrdoState::kOff, SrdoState::kWaiting, SrdoState::kFaulted, SrdoState::kReleased,
                              SrdoState::kProducer};
constexpr const char* kStateNames[]{"off", "waiting", "faulted", "released", "producer"};

const char* NameOf(const SrdoState state) noexcept
{
    for (std::uint32_t number = 0U; number < (sizeof(kStates) / sizeof(kStates[0])); ++number)
    {
        if (kStates[number] == state)
        {
            return kStateNames[number];
        }
    }
    return "invalid";
}

bool IsSame(const CanFrame& left, const CanFrame& right) noexcept
{
    bool is_same = (left.identifier == right.identifier) && (left.length_bytes == right.length_bytes);
    for (std::uint32_t byte = 0U; is_same && (byte < left.length_bytes); ++byte)
    {
        is_same = left.data[byte] == right.data[byte];
    }
    return is_same;
}

} // namespace

SimulatedDevice::SimulatedDevice(hal::MemoryProtection& protection) noexcept
    : driven_{firmware::BuildDevice(firmware::Hardware{can_, output_, watchdog_, protection})}
{
}

Cost SimulatedDevice::GreatestCost() const noexcept
{
    return cost_;
}

void SimulatedDevice::Note(const char* const what, const std::uint32_t value) noexcept
{
    WriteNumber(now_us_);
    Write(" ");
    Write(what);
    Write(" ");
    WriteHex(value);
    Write("\n");
}

InstantPair SimulatedDevice::StampOf(const std::uint32_t at_us) const noexcept
{
    return InstantPair{Instant{at_us}, Instant{(at_us + kOffsetBUs) - lost_b_us_}};
}

StateReply SimulatedDevice::StateOf(const std::uint32_t srdo) const noexcept
{
    return driven_.kernel.GetState(CommunicationIndex{static_cast<std::uint16_t>((kFirstCommunication - 1U) + srdo)});
}

bool SimulatedDevice::Start() noexcept
{
    const bool is_up = driven_.is_protected && driven_.device.PowerOn(Instant{0U}) == device::LoadResult::kLoaded;
    if (!is_up)
    {
        Write("FAILURE: the device did not start\n");
    }
    watchdog_.Start(Instant{0U});
    return is_up;
}

void SimulatedDevice::ConfirmBefore(const std::uint32_t until_us) noexcept
{
    for (CanFrame frame = can_.Waiting(); frame.kind == FrameKind::kData; frame = can_.Waiting())
    {
        if ((bus_free_us_ + kFrameUs) > until_us)
        {
            return;
        }
        bus_free_us_ += kFrameUs;
        can_.Confirm();
        driven_.device.OnConfirm(StampedFrame{frame, StampOf(bus_free_us_)});
    }
}

void SimulatedDevice::PassTime(Scenario& scenario, const std::uint32_t until_us) noexcept
{
    bus_free_us_ = (bus_free_us_ < now_us_) ? now_us_ : bus_free_us_;
    while ((event_.at_us <= until_us) && !has_ended_)
    {
        ConfirmBefore(event_.at_us);
        bus_free_us_ = (bus_free_us_ < event_.at_us) ? event_.at_us : bus_free_us_;
        Do(event_);
        event_ = has_ended_ ? event_ : scenario.Next();
    }
    ConfirmBefore(until_us);
}

void SimulatedDevice::Do(const Event& event) noexcept
{
    switch (event.verb)
    {
    case Verb::kFrame:
        driven_.device.OnFrame(StampedFrame{event.frame, StampOf(event.at_us)});
        break;
    case Verb::kNmt:
        driven_.device.OnFrame(
            StampedFrame{CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {kNmtCommands[event.value], 0U}},
                         StampOf(event.at_us)});
        break;
    case Verb::kInput:
        inputs_ = event.value;
        break;
    case Verb::kOverflow:
        driven_.device.OnLoss();
        break;
    case Verb::kBusOff:
        can_.SetBusOff(event.value != 0U);
        break;
    case Verb::kLate:
        late_us_ = event.value;
        break;
    case Verb::kCounterB:
        counter_b_stands_ = event.value != 0U;
        break;
    case Verb::kEnd:
        has_ended_ = true;
        break;
    case Verb::kInvalid:
        Write("FAILURE: scenario:");
        WriteNumber(event.line);
        Write(": expected '<us> <event>', an event of scenario.hpp\n");
        is_good_ = false;
        has_ended_ = true;
        break;
    case Verb::kExpectOutputs:
    case Verb::kExpectGate:
    case Verb::kExpectState:
    case Verb::kExpectFault:
    case Verb::kExpectSent:
    case Verb::kExpectLast:
        Expect(event);
        break;
    }
}

void SimulatedDevice::Judge(const Event& event, const bool holds, const char* const what,
                            const std::uint32_t got) noexcept
{
    is_good_ = is_good_ && holds;
    if (!holds)
    {
        Write("FAILURE: scenario:");
        WriteNumber(event.line);
        Write(": expected ");
        Write(what);
        Write(" ");
        WriteHex(event.value);
        Write(", got ");
        WriteHex(got);
        Write("\n");
    }
}

void SimulatedDevice::Expect(const Event& event) noexcept
{
    if (event.verb == Verb::kExpectOutputs)
    {
        Judge(event, outputs_ == event.value, "outputs", outputs_);
    }
    else if (event.verb == Verb::kExpectGate)
    {
        Judge(event, open_ == event.value, "gate", static_cast<std::uint32_t>(open_));
    }
    else if (event.verb == Verb::kExpectState)
    {
        const SrdoState state = StateOf(event.srdo).state;
        Judge(event, state == kStates[event.value], kStateNames[event.value], static_cast<std::uint32_t>(state));
    }
    else if (event.verb == Verb::kExpectFault)
    {
        const auto fault = static_cast<std::uint32_t>(driven_.kernel.DeviceState().fault);
        Judge(event, fault == event.value, "fault", fault);
    }
    else if (event.verb == Verb::kExpectSent)
    {
        Judge(event, can_.Sent() == event.value, "sent", can_.Sent());
    }
    else
    {
        Judge(event, IsSame(can_.Last(), event.frame), "another last frame than", can_.Last().identifier);
    }
}

void SimulatedDevice::ShowSent() noexcept
{
    if (can_.Sent() == shown_sent_)
    {
        return;
    }
    shown_sent_ = can_.Sent();
    const CanFrame& frame = can_.Last();
    WriteNumber(now_us_);
    Write(" sent ");
    WriteHex(frame.identifier);
    for (std::uint32_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        Write(" ");
        WriteNumber(frame.data[byte]);
    }
    Write("\n");
}

void SimulatedDevice::ShowState(const std::uint8_t srdo) noexcept
{
    const StateReply reply = StateOf(srdo + 1U);
    if ((reply.result == Result::kSuccessful) && (reply.state != shown_states_[srdo]))
    {
        shown_states_[srdo] = reply.state;
        WriteNumber(now_us_);
        Write(" SRDO ");
        WriteNumber(srdo + 1U);
        Write(" ");
        Write(NameOf(reply.state));
        Write(" cause ");
        WriteNumber(static_cast<std::uint32_t>(reply.first_cause));
        Write("\n");
    }
}

void SimulatedDevice::Show() noexcept
{
    ShowSent();
    for (std::uint8_t srdo = 0U; srdo < kMostShown; ++srdo)
    {
        ShowState(srdo);
    }
    if (open_ != shown_gate_)
    {
        shown_gate_ = static_cast<std::uint32_t>(open_);
        Note("gate", shown_gate_);
    }
    if (outputs_ != shown_outputs_)
    {
        shown_outputs_ = outputs_;
        Note("outputs", outputs_);
    }
    const auto fault = static_cast<std::uint32_t>(driven_.kernel.DeviceState().fault);
    if (fault != shown_fault_)
    {
        shown_fault_ = fault;
        Note("device fault", fault);
    }
}

void SimulatedDevice::Cycle() noexcept
{
    const Instant now{now_us_};
    output_.SetTime(now);
    watchdog_.SetTime(now);
    const SrdoMask acknowledge_a = firmware::ReadInputs(firmware::Pins{inputs_});
    const SrdoMask acknowledge_b = firmware::ReadAcknowledge(firmware::Pins{~inputs_});
    const CycleCall call{StampOf(now_us_), acknowledge_a, acknowledge_b};
    driven_.device.Serve(now); // Frames and commands; what is measured is a cycle.
    const std::uint32_t before = ReadMeter();
    driven_.device.Cycle(call);
    const std::uint32_t cost = ReadMeter() - before;
    cost_.greatest = (cost > cost_.greatest) ? cost : cost_.greatest;
    ++cost_.cycles;
    open_ = watchdog_.IsAlive() ? output_.Open() : 0U;
    outputs_ = firmware::SetOutputs(open_).bits;
}

bool SimulatedDevice::Run(const char* const text, void (*const non_safety)() noexcept) noexcept
{
    if (!Start())
    {
        return false;
    }
    Scenario scenario{text};
    event_ = scenario.Next();
    for (std::uint32_t cycle = 0U; (cycle < kMostCycles) && !has_ended_; ++cycle)
    {
        cycle_at_us_ += kCycleUs + late_us_;
        late_us_ = 0U;
        lost_b_us_ += counter_b_stands_ ? kCycleUs : 0U;
        PassTime(scenario, cycle_at_us_);
        now_us_ = cycle_at_us_;
        Cycle();
        non_safety();
        Show();
    }
    return is_good_ && has_ended_;
}

} // namespace counterpoint::target
