// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/device.hpp"

#include "safety_core/kernel/reporting.hpp"

#include "runtime/device/assembly.hpp"
#include "verification/campaign/calls.hpp"
#include "verification/campaign/channels.hpp"
#include "verification/campaign/kernel_places.hpp"
#include "verification/campaign/outcome.hpp"
#include "verification/campaign/pins_output.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace counterpoint::campaign
{
namespace
{
/// Time of the bus as output and watchdog count it.
Instant BusInstant(const Nanoseconds at)
{
    return {static_cast<std::uint32_t>(at / runtime::kNanosecondsPerMicrosecond)};
}

bool Signals(const std::uint32_t signals, const SrdoCause cause)
{
    return ((signals >> (static_cast<std::uint32_t>(cause) % 32U)) & 1U) != 0U;
}
} // namespace

Device::Device(Region& region, const runtime::DeviceModel& model, const Recording& recording, const OutputKind output,
               const DeviceSetup& setup)
    : region_(region), recording_(recording), reference_(model.Config()), prefix_(setup.cpu ? setup.cpu->prefix : ""),
      feed_(recording)
{
    MakeSurroundings(recording, output, setup);
    CopyTables(model);
    feed_.TakeInputs(pairs_);
    MakeChannels(setup);
    if (setup.has_self_test)
    {
        self_test_ = std::make_unique<FlatSelfTest>(region_, *output_);
    }
    hal::Watchdog& watchdog = (peer_ == nullptr) ? *watchdog_ : peer_->Watchdog();
    kernel_ =
        &region_.Make<Kernel>(KernelParts{*a_, *b_, *ports_, *output_, watchdog, *application_,
                                          (self_test_ == nullptr) ? nullptr : &self_test_->Part(), windows_, flow_});
    for (const Place& member : PlacesOf(*kernel_, region_))
    {
        places_.push_back({member.part, prefix_ + member.name, member.offset, member.size});
    }
    Start(model);
    if (!setup.cpu)
    {
        region_.Close();
    }
}

void Device::Add(const Part part, const std::string& name, const void* const object, const std::size_t size)
{
    places_.push_back({part, prefix_ + name, region_.OffsetOf(object), size});
}

void Device::CopyTables(const runtime::DeviceModel& model)
{
    config_ = &region_.Make<DeviceConfig>(model.Config());
    Add(Part::kTables, "config", config_, sizeof(*config_));
    auto& source = const_cast<runtime::DeviceModel&>(model); // Its memory is read here alone.
    const std::size_t memory_size = source.Memory().size();
    auto* const memory = region_.MakeArray<std::uint8_t>(memory_size);
    std::copy(source.Memory().begin(), source.Memory().end(), memory);
    Add(Part::kVariables, "variables", memory, memory_size);
    auto* const objects = region_.MakeArray<MappableObject>(model.Objects().size());
    std::copy(model.Objects().begin(), model.Objects().end(), objects);
    for (std::size_t index = 0U; index < model.Objects().size(); ++index)
    {
        objects[index].place = memory + (model.Objects()[index].place - source.Memory().data());
    }
    Add(Part::kTables, "objects", objects, sizeof(MappableObject) * model.Objects().size());
    auto* const setups = region_.MakeArray<SrdoSetup>(config_->srdo_count);
    std::copy_n(model.Config().srdos, config_->srdo_count, setups);
    Add(Part::kTables, "setups", setups, sizeof(SrdoSetup) * config_->srdo_count);
    config_->objects = objects;
    config_->srdos = setups;
    for (const runtime::StaticTable& table : model.StaticTables())
    {
        auto* const entries = region_.MakeArray<std::uint32_t>(table.entries.size());
        std::copy(table.entries.begin(), table.entries.end(), entries);
        setups[model.SlotOf(table.number).value_or(0U)].map.entries = entries;
        Add(Part::kTables, "static_map", entries, sizeof(std::uint32_t) * table.entries.size());
    }
    for (const runtime::VariablePair& pair : model.Pairs())
    {
        const MappableObject& normal = objects[pair.normal];
        const MappableObject& inverse = objects[pair.inverse];
        const SlotIndex slot = model.SlotOf(pair.srdo).value_or(0U);
        const bool is_asked = !pair.is_consumer && reference_.srdos[slot].form == ProducerForm::kProviderCalled;
        pairs_.push_back({{normal.place, normal.length_bits},
                          {inverse.place, inverse.length_bits},
                          {normal.index, normal.sub},
                          slot,
                          pair.first_bit,
                          pair.is_consumer,
                          is_asked ? runtime::CommunicationIndexOf(pair.srdo).value : std::uint16_t{0U}});
    }
}

void Device::MakeSurroundings(const Recording& recording, const OutputKind output, const DeviceSetup& setup)
{
    const bool is_second = setup.cpu && setup.cpu->application != nullptr;
    application_ = is_second ? setup.cpu->application : &region_.Make<FlatApplication>();
    ports_ = is_second ? setup.cpu->ports : &region_.Make<FlatPorts>();
    ports_->frame_ns = recording.frame_ns;
    watchdog_ = &region_.Make<FlatWatchdog>();
    output_ =
        (output == OutputKind::kPins) ? &MakePinsOutput(region_, reference_, places_) : &region_.Make<FlatOutput>();
    output_->limit = {LateCycleUs(reference_)};
    flow_ = &region_.Make<TappedFlow>();
    Add(Part::kFlowMonitor, "flow_monitor", &flow_->monitor, sizeof(flow_->monitor));
    windows_ = region_.MakeArray<CauseWindows>(reference_.srdo_count);
    Add(Part::kKernel, "kernel.windows", windows_, sizeof(CauseWindows) * reference_.srdo_count);
}

void Device::MakeChannels(const DeviceSetup& setup)
{
    if (setup.cpu)
    {
        MakeVoices(setup);
        return;
    }
    const ChannelRoom room{reference_.srdo_count, reference_.map_entries};
    const MadeChannel a = MakeChannelA(region_, room);
    const MadeChannel b = MakeChannelB(region_, room);
    places_.insert(places_.end(), a.places.begin(), a.places.end());
    places_.insert(places_.end(), b.places.begin(), b.places.end());
    a_ = a.voice;
    b_ = b.voice;
    shipped_ = {a.voice, b.voice};
    if (setup.has_call_faults)
    {
        disturbed_a_ = &region_.Make<DisturbedChannel>(*a_, Part::kCallsOfA, feed_.OfCalls());
        disturbed_b_ = &region_.Make<DisturbedChannel>(*b_, Part::kCallsOfB, feed_.OfCalls());
        a_ = disturbed_a_;
        b_ = disturbed_b_;
    }
}

/// One channel, and in the place of the other one what its CPU tells.
void Device::MakeVoices(const DeviceSetup& setup)
{
    const CpuOfTwo& cpu = *setup.cpu;
    const ChannelRoom room{reference_.srdo_count, reference_.map_entries};
    const MadeChannel own = (cpu.link.role == PeerRole::kA) ? MakeChannelA(region_, room) : MakeChannelB(region_, room);
    for (const Place& place : own.places)
    {
        places_.push_back({place.part, prefix_ + place.name, place.offset, place.size});
    }
    shipped_ = {own.voice, own.voice};
    peer_ = &region_.Make<Peer>(*own.voice, *watchdog_, cpu.link);
    Add(Part::kCrossLink, "cross_link", peer_, sizeof(*peer_));
    a_ = &peer_->VoiceA();
    b_ = &peer_->VoiceB();
    if (setup.has_call_faults && cpu.link.role == PeerRole::kA)
    {
        disturbed_a_ = &region_.Make<DisturbedChannel>(*a_, Part::kCallsOfA, feed_.OfCalls());
        a_ = disturbed_a_;
    }
    else if (setup.has_call_faults)
    {
        disturbed_b_ = &region_.Make<DisturbedChannel>(*b_, Part::kCallsOfB, feed_.OfCalls());
        b_ = disturbed_b_;
    }
    else
    {
        // Nobody stands in front of it.
    }
}

void Device::Start(const runtime::DeviceModel& model)
{
    ports_->now = recording_.power_on;
    SetTime(recording_.power_on);
    if (self_test_ != nullptr)
    {
        AddToSelfTest();
    }
    if (kernel_->Start(*config_, FlowCallback::kOff) != StartResult::kStarted)
    {
        throw std::runtime_error("the kernel refuses the device of " + model.File());
    }
    auto& source = const_cast<runtime::DeviceModel&>(model); // To learn where its fields are.
    for (const runtime::StaticTable& table : model.StaticTables())
    {
        const StaticFields fields = source.FieldsOf(table);
        const auto moved = [&](std::uint8_t* const place)
        { return pairs_.empty() ? nullptr : (config_->objects[0].place - model.Objects()[0].place) + place; };
        static_cast<void>(kernel_->DefineStaticFields(runtime::CommunicationIndexOf(table.number),
                                                      {moved(fields.normal), moved(fields.inverse)}));
    }
    for (const runtime::ConfigurationWrite& write : model.Writes())
    {
        if (kernel_->WriteObject(write.object, runtime::DataOf(write)) != AbortCode::kNone)
        {
            throw std::runtime_error("the kernel refuses a value of " + model.File() + " in line " +
                                     std::to_string(write.place.line));
        }
    }
    watchdog_->timer.Start(runtime::WindowOf(reference_), watchdog_->now);
}

/// All of channels and kernel is live memory, the tables are constant.
void Device::AddToSelfTest()
{
    for (Channel* const channel : shipped_)
    {
        self_test_->AddPart(channel);
    }
    self_test_->AddPart(output_);
    self_test_->AddPart(watchdog_);
    self_test_->AddPart(application_);
    std::uint8_t* const bytes = region_.Bytes();
    for (const Part part : {Part::kChannelA, Part::kChannelB})
    {
        std::size_t begin = region_.Size();
        std::size_t end = 0U;
        for (const Place& place : places_)
        {
            begin = (place.part == part) ? std::min(begin, place.offset) : begin;
            end = (place.part == part) ? std::max(end, place.offset + place.size) : end;
        }
        self_test_->AddLive(bytes + begin, end - begin);
    }
    self_test_->AddLive(kernel_, sizeof(*kernel_));
    self_test_->AddLive(&flow_->monitor, sizeof(flow_->monitor));
    for (const Place& place : places_)
    {
        if (place.part == Part::kTables)
        {
            self_test_->AddConstant(bytes + place.offset, place.size);
        }
    }
    self_test_->Start(*shipped_[0], *shipped_[1], reference_.diagnostic_interval_us / LateCycleUs(reference_));
}

void Device::Rewind(const std::size_t cycle, const Experiment* const fault, const std::size_t end,
                    const std::uint64_t seed)
{
    feed_.Rewind(cycle, fault, end, seed);
}

bool Device::IsUndisturbed(const std::size_t cycle) const
{
    return feed_.IsUndisturbed(cycle);
}

DeviceFault Device::Fault() const noexcept
{
    return kernel_->DeviceState().fault;
}

void Device::Follow(PhaseHook* const hook) noexcept
{
    hook_ = hook;
    flow_->hook = hook;
}

void Device::SetTime(const Nanoseconds at) noexcept
{
    output_->now = BusInstant(at);
    watchdog_->now = BusInstant(at);
}

SrdoMask Device::Open() noexcept
{
    watchdog_->timer.Examine(watchdog_->now);
    const SrdoMask open = output_->Open();
    return watchdog_->timer.IsAlive() ? open : SrdoMask{0U};
}

void Device::Cycle(const std::size_t cycle)
{
    ports_->MoveOn();
    ForgetErrors(recording_, cycle, *application_);
    feed_.BeginCycle();
    const Calls calls = feed_.CallsIn(cycle);
    for (std::size_t index = 0U; index < calls.count; ++index)
    {
        Call(cycle, calls.at.at(index));
    }
    SetTime(recording_.cycles[cycle].at);
}

void Device::Call(const std::size_t cycle, const Nanoseconds at)
{
    if (disturbed_a_ != nullptr)
    {
        disturbed_a_->BeginCycle();
        disturbed_b_->BeginCycle();
    }
    feed_.BeginCall(cycle, *kernel_);
    if (hook_ != nullptr)
    {
        hook_->At(Phase::kBeforeFrames);
    }
    Deliver(at);
    if (hook_ != nullptr)
    {
        hook_->At(Phase::kAfterFrames);
    }
    SetTime(at);
    ports_->now = at;
    output_->Examine();
    target_ = {&feed_, &pairs_, cycle};
    application_->provider = this;
    if (output_->is_live)
    {
        kernel_->Cycle(feed_.CallOf(cycle, at));
    }
    feed_.WriteInputs(target_, 0U);
}

RefreshAnswer Device::Provide(const CommunicationIndex index) noexcept
{
    return feed_.Refresh(target_, index);
}

/// Received frames and confirmations in the order of the bus.
void Device::Deliver(const Nanoseconds at)
{
    bool has_come = false;
    for (;;)
    {
        const std::optional<RecordedFrame> frame = feed_.FrameUntil(at);
        const bool has_own = ports_->confirmed < std::min<std::uint32_t>(ports_->count, kMostOwnFrames) &&
                             ports_->frames[ports_->confirmed].confirmed_at <= at;
        if (!frame && !has_own)
        {
            break;
        }
        if (has_own && (!frame || ports_->frames[ports_->confirmed].confirmed_at < frame->at))
        {
            const OwnFrame own = ports_->frames[ports_->confirmed];
            ++ports_->confirmed;
            ports_->now = own.confirmed_at;
            SetTime(own.confirmed_at);
            feed_.Confirm({own.frame, feed_.Stamp(own.confirmed_at)}, *kernel_);
        }
        else
        {
            feed_.Hand(*frame, *kernel_);
        }
        if (!has_come && hook_ != nullptr)
        {
            hook_->At(Phase::kBetweenFrames);
        }
        has_come = true;
    }
    if (!has_come && hook_ != nullptr)
    {
        hook_->At(Phase::kBetweenFrames);
    }
}

void ForgetErrors(const Recording& recording, const std::size_t cycle, FlatApplication& application) noexcept
{
    const RecordedCycle& now = recording.cycles[cycle];
    const CycleCall before = (cycle == 0U) ? CycleCall{} : recording.cycles[cycle - 1U].call;
    const bool is_pressed = (now.call.acknowledge_a & ~before.acknowledge_a) != 0U;
    if (is_pressed || now.nmt != NmtState::kOperational)
    {
        application.ForgetErrors();
    }
}

std::uint8_t WhoSaid(const Device& device, const SrdoCause cause) noexcept
{
    std::uint8_t marks = 0U;
    for (SlotIndex slot = 0U; slot < device.Config().srdo_count; ++slot)
    {
        marks |= Signals(device.Voice(0U).View(slot).signals, cause) ? kMarkSaidByA : std::uint8_t{0U};
        marks |= Signals(device.Voice(1U).View(slot).signals, cause) ? kMarkSaidByB : std::uint8_t{0U};
    }
    return marks;
}

SrdoCause FirstCauseOf(const Device& device) noexcept
{
    const SrdoCause told = device.Application().Now().first_cause;
    for (SlotIndex slot = 0U; slot < device.Config().srdo_count; ++slot)
    {
        const SrdoView a = device.Voice(0U).View(slot);
        const SrdoView b = device.Voice(1U).View(slot);
        const SrdoCause first = FirstCauseOf(a, b);
        const std::uint32_t signals = a.signals | b.signals;
        if (Signals(signals, told) && Signals(signals, first))
        {
            return first;
        }
    }
    return told;
}
} // namespace counterpoint::campaign
