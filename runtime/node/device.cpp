// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"

#include "runtime/node/build.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "runtime/device/names.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kPressNs = 200000000U;
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kPressCycles = 4U;
} // namespace

NodeDevice::NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report)
    : report_(report), ports_(ports), file_(cia306::ReadDeviceFile(settings.dcf)),
      has_lss_(settings.has_lss || file_.is_lss_supported),
      model_(settings.dcf, NodeIdOf(settings, file_, has_lss_), runtime::SafetyNeed::kOptional),
      safety_objects_(SafetyObjectsOf(UseControllers(model_, ports), file_)),
      config_(ConfigOf(model_, safety_objects_, settings.cycle_us)), time_(host::BitRate::k500k), watchdog_(time_),
      output_(time_, watchdog_, {config_.cycle_us + config_.cycle_tolerance_us}),
      channel_a_(MakeChannel(runtime::Letter::kA, runtime::RoomOf(config_))),
      channel_b_(MakeChannel(runtime::Letter::kB, runtime::RoomOf(config_))), application_(model_, report),
      self_test_(settings.has_self_tests ? std::make_unique<NodeSelfTest>(output_) : nullptr),
      assembly_(model_, config_,
                {channel_a_->Voice(), channel_b_->Voice(), ports, output_, watchdog_, application_,
                 self_test_ ? &self_test_->Part() : nullptr, *this, &file_}),
      further_(file_, assembly_.Dictionary(), assembly_.Services(), report,
               assembly_.Objects().Rooms().sdo_buffer.size_bytes),
      store_(settings.store.empty() ? nullptr
                                    : std::make_unique<NodeStore>(
                                          settings.store, NodeStoreParts{assembly_.Core(), assembly_.Objects().Table(),
                                                                         assembly_.Dictionary(), assembly_.Services()}))
{
    assembly_.Connect([this](const std::uint16_t index) { return further_.HookOf(index); },
                      store_ ? &store_->Hook() : nullptr);
    FurnishSelfTest();
    FurnishLss(settings);
    slot_of_.fill(kNoSlot);
    application_.Tell([this](const std::uint8_t srdo) { paired_ |= SrdoMask{1U} << model_.SlotOf(srdo).value_or(0U); });
}

const DeviceConfig& NodeDevice::Config() const noexcept
{
    return config_;
}

const runtime::DeviceModel& NodeDevice::Model() const noexcept
{
    return model_;
}

const NodeSelfTest* NodeDevice::SelfTests() const noexcept
{
    return self_test_.get();
}

NodeFurther& NodeDevice::Further() noexcept
{
    return further_;
}

std::uint8_t NodeDevice::NodeId() const noexcept
{
    if (!lss_)
    {
        return assembly_.Services().node.value;
    }
    const std::uint8_t active = lss_->Slave().ActiveNodeId();
    const std::uint8_t coming = lss_->Slave().Settings().node_id; // Before power-on.
    const std::uint8_t node_id = (active == cia305::kNoNodeId) ? coming : active;
    return (node_id == cia305::kNoNodeId) ? std::uint8_t{0U} : node_id;
}

std::optional<std::uint8_t> NodeDevice::NewNodeId() const noexcept
{
    return assembly_.NewNodeId();
}

NodeApplication& NodeDevice::App() noexcept
{
    return application_;
}

device::Device& NodeDevice::Services() noexcept
{
    return assembly_.Device();
}

cia301::Dictionary& NodeDevice::Objects() noexcept
{
    return assembly_.Dictionary();
}

Kernel& NodeDevice::Core() noexcept
{
    return assembly_.Core();
}

const NodeLatency& NodeDevice::Latency() const noexcept
{
    return latency_;
}

SrdoMask NodeDevice::Open() noexcept
{
    return open_;
}

void NodeDevice::SetTime(const std::uint64_t now_ns)
{
    time_.Advance(static_cast<host::BusTime>(now_ns - start_ns_));
    application_.SetNow(now_ns);
    further_.SetNow(now_ns);
    now_ns_ = now_ns;
}

bool NodeDevice::PowerOn(const InstantPair& now, const std::uint64_t now_ns)
{
    start_ns_ = now_ns;
    SetTime(now_ns);
    const bool is_up = assembly_.Device().PowerOn(now.a) == device::LoadResult::kLoaded;
    TellState(now_ns);
    return is_up;
}

bool NodeDevice::TakeRestart(const std::uint64_t now_ns)
{
    const bool has_restarted = has_restarted_;
    if (has_restarted)
    {
        SetTime(now_ns);
        watchdog_.Start(WindowOf(config_));
        has_restarted_ = false;
    }
    return has_restarted;
}

void NodeDevice::OnFrame(const host::LiveFrame& frame, const CanPortId port, const InstantPair& stamp)
{
    const StampedFrame stamped{host::ToCanFrame(frame, port), stamp};
    if (frame.own)
    {
        assembly_.Device().OnConfirm(stamped);
        return;
    }
    const std::uint32_t number = frame.identifier - kFirstSrdoIdentifier;
    if (number < kSrdoIdentifierCount && slot_of_.at(number) != kNoSlot)
    {
        received_ns_.at(slot_of_.at(number)) = frame.time_ns;
    }
    assembly_.Device().OnFrame(stamped);
}

void NodeDevice::OnLoss() noexcept
{
    assembly_.Device().OnLoss();
}

void NodeDevice::OnBus(const device::BusCondition condition) noexcept
{
    assembly_.Device().OnBus(condition);
}

void NodeDevice::Cycle(const InstantPair& now, const std::uint64_t now_ns)
{
    SetTime(now_ns);
    SendByApplication();
    paired_ = 0U;
    const SrdoMask levels = AcknowledgeLevels(now_ns);
    assembly_.Device().Cycle({now, levels, levels});
    Save();
    further_.Look();
    TellSelfTest(now_ns);
    TellState(now_ns);
}

void NodeDevice::Serve(const InstantPair& now, const std::uint64_t now_ns)
{
    SetTime(now_ns);
    assembly_.Device().Serve(now.a);
    Save();
    further_.Look();
    TellState(now_ns);
}

void NodeDevice::LookAtOutput(const std::uint64_t now_ns)
{
    // What closes by itself does so at its time, not when somebody looks again.
    const host::BusTime closes_at = output_.ClosesAt();
    SetTime(now_ns);
    const SrdoMask open = output_.Open();
    TellLatency(now_ns);
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        const bool is_open = ((open >> slot) & 1U) != 0U;
        if (((open_ ^ open) >> slot) & 1U)
        {
            const std::uint64_t closed_ns = start_ns_ + static_cast<std::uint64_t>(closes_at);
            const std::uint64_t at_ns = (is_open || closes_at == host::kNever) ? now_ns : std::min(closed_ns, now_ns);
            report_.Tell(at_ns,
                         "output of SRDO " + std::to_string(model_.NumberOf(slot)) + (is_open ? " open" : " closed"),
                         "output", {{"srdo", model_.NumberOf(slot)}, {"open", is_open}});
        }
    }
    open_ = open;
    application_.Run(open);
}

// From the stamp of the inverse frame to now, when the gate is open with the new pair.
void NodeDevice::TellLatency(const std::uint64_t now_ns)
{
    const SrdoMask released = paired_ & output_.Open();
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        if (((released >> slot) & 1U) != 0U && received_ns_.at(slot) != 0U && received_ns_.at(slot) < now_ns)
        {
            latency_.Add(now_ns - received_ns_.at(slot));
        }
    }
    paired_ = 0U;
}

bool NodeDevice::IsSaving() const noexcept
{
    return store_ && store_->IsBusy();
}

void NodeDevice::Save()
{
    if (store_)
    {
        store_->OnCycle();
    }
}

bool NodeDevice::Acknowledge(const std::uint8_t srdo, const std::uint64_t now_ns)
{
    const std::optional<SlotIndex> slot = model_.SlotOf(srdo);
    if (slot)
    {
        const std::uint64_t cycles_ns = kPressCycles * config_.cycle_us * kNsPerUs;
        pressed_until_ns_.at(*slot) = now_ns + std::max(kPressNs, cycles_ns);
    }
    return slot.has_value();
}

SrdoMask NodeDevice::AcknowledgeLevels(const std::uint64_t now_ns) const noexcept
{
    SrdoMask levels = 0U;
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        levels |= (now_ns < pressed_until_ns_[slot]) ? SrdoMask{1U} << slot : SrdoMask{0U};
    }
    return levels;
}

void NodeDevice::TellState(const std::uint64_t now_ns)
{
    const cia301::NodeState state = assembly_.Device().State();
    if (state != state_)
    {
        const bool is_configured = state_ == cia301::NodeState::kInvalid && cia301::StateByte(state) != 0U;
        const bool is_of_file = is_configured && !store_; // What was saved may have turned one off.
        for (const std::string& line :
             is_of_file ? assembly_.Objects().PdosTurnedOff(assembly_.Dictionary()) : std::vector<std::string>{})
        {
            report_.Tell(now_ns, line, "refused", {{"text", line}});
        }
        state_ = state;
        if (state == cia301::NodeState::kOperational)
        {
            FollowConfiguration();
        }
        const std::string name = Name(cia301::KernelState(state));
        report_.Tell(now_ns, "NMT " + name, "nmt", {{"state", name}});
    }
}

// A cycle that ended before any part was called told nobody.
void NodeDevice::TellSelfTest(const std::uint64_t now_ns)
{
    const std::string failure = self_test_ ? self_test_->Failure() : "";
    if (!failure.empty() && !has_told_test_)
    {
        report_.Tell(now_ns, "self test failed: " + failure, "self_test", {{"failed", failure}});
    }
    has_told_test_ = !failure.empty();
}

void NodeDevice::Stop(const std::uint64_t now_ns)
{
    ports_.EndProduction();
    assembly_.Core().Stop();
    LookAtOutput(now_ns);
}
} // namespace counterpoint::runtime
