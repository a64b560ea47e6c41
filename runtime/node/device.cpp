// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"

#include "runtime/node/srdo_line.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/names.hpp"
#include "safety_core/kernel/limits.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kPressNs = 200000000U;
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kPressCycles = 4U;

/// Node-ID: what LSS gave in this run, what it saved, then the command line and the file.
cia305::LssSettings LssSettingsOf(const NodeSettings& settings, const cia306::Device& file, NodeStore* const store)
{
    const std::optional<std::uint8_t> wanted = settings.node_id ? settings.node_id : file.node_id;
    cia305::LssSettings known{wanted.value_or(cia305::kNoNodeId), {0U}};
    known = (store == nullptr) ? known : store->LoadLss(known);
    known.node_id = settings.lss_node_id.value_or(known.node_id);
    return known;
}

KeepLss KeeperOf(NodeStore* const store)
{
    return (store == nullptr) ? KeepLss{} : [store](const cia305::LssSettings& settings)
    { return store->Keep(settings); };
}
} // namespace

NodeDevice::NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report)
    : report_(report), ports_(ports), file_(cia306::ReadDeviceFile(settings.dcf)),
      has_lss_(settings.has_lss || file_.is_lss_supported),
      model_(settings.dcf, NodeIdOf(settings, file_, has_lss_), SafetyNeed::kOptional),
      config_(ConfigOf(UseControllers(model_, ports), settings.cycle_us)), time_(host::BitRate::k500k),
      watchdog_(time_), output_(time_, watchdog_, {config_.cycle_us + config_.cycle_tolerance_us}),
      channel_a_(MakeChannel(Letter::kA, RoomOf(config_))), channel_b_(MakeChannel(Letter::kB, RoomOf(config_))),
      application_(model_, report),
      self_test_(settings.has_self_tests ? std::make_unique<NodeSelfTest>(output_) : nullptr),
      outputs_(model_, output_, report), loading_(model_, self_test_.get(), report),
      assembly_(model_, config_,
                {channel_a_->Voice(), channel_b_->Voice(), ports, output_, watchdog_, application_,
                 self_test_ ? &self_test_->Part() : nullptr, loading_, &file_}),
      transfers_(assembly_.Optional(), report),
      store_(settings.store.empty() ? nullptr
                                    : std::make_unique<NodeStore>(
                                          settings.store, NodeStoreParts{assembly_.Core(), assembly_.Objects().Table(),
                                                                         assembly_.Dictionary(), assembly_.Services()}))
{
    assembly_.Connect(store_ ? &store_->Hook() : nullptr);
    if (store_)
    {
        loading_.Use(*store_);
    }
    FurnishSelfTest();
    if (has_lss_)
    {
        assembly_.UseLss(file_, LssSettingsOf(settings, file_, store_.get()), KeeperOf(store_.get()));
    }
    application_.Tell([this](const std::uint8_t srdo) { outputs_.OnPair(srdo); });
}

const DeviceConfig& NodeDevice::Config() const noexcept
{
    return config_;
}

const DeviceModel& NodeDevice::Model() const noexcept
{
    return model_;
}

const NodeSelfTest* NodeDevice::SelfTests() const noexcept
{
    return self_test_.get();
}

NodeTransfers& NodeDevice::Transfers() noexcept
{
    return transfers_;
}

std::uint8_t NodeDevice::NodeId() const noexcept
{
    return assembly_.NodeId();
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
    return outputs_.Latency();
}

SrdoMask NodeDevice::Open() noexcept
{
    return outputs_.Open();
}

void NodeDevice::FurnishSelfTest()
{
    if (!self_test_)
    {
        return;
    }
    self_test_->AddChannel(*channel_a_);
    self_test_->AddChannel(*channel_b_);
    self_test_->AddKernel(assembly_.Core());
    self_test_->AddPart(static_cast<hal::CanPorts*>(&ports_));
    self_test_->AddPart(static_cast<hal::SafetyOutput*>(&output_));
    self_test_->AddPart(static_cast<hal::Watchdog*>(&watchdog_));
    self_test_->AddPart(&assembly_.Told());
    self_test_->AddConstants(config_, model_);
    const std::uint32_t cycles = config_.diagnostic_interval_us / LateCycleUs(config_);
    if (!self_test_->Settle(cycles))
    {
        throw cia306::InputError(
            model_.File(), 0U,
            {"the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) + " cycles",
             "a longer one (0x5F00:04), or --no-self-tests"});
    }
}

void NodeDevice::SetTime(const std::uint64_t now_ns)
{
    time_.Advance(static_cast<host::BusTime>(now_ns - start_ns_));
    application_.SetNow(now_ns);
    transfers_.SetNow(now_ns);
    loading_.SetNow(now_ns);
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
    const bool has_restarted = loading_.TakeRestart();
    if (has_restarted)
    {
        SetTime(now_ns);
        watchdog_.Start(WindowOf(config_));
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
    outputs_.OnFrame(frame);
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
    outputs_.BeginCycle();
    const SrdoMask levels = AcknowledgeLevels(now_ns);
    assembly_.Device().Cycle({now, levels, levels});
    if (store_)
    {
        store_->OnCycle();
    }
    transfers_.Look();
    loading_.TellSelfTest();
    TellState(now_ns);
}

void NodeDevice::Serve(const InstantPair& now, const std::uint64_t now_ns)
{
    SetTime(now_ns);
    assembly_.Device().Serve(now.a);
    if (store_)
    {
        store_->OnCycle();
    }
    transfers_.Look();
    TellState(now_ns);
}

void NodeDevice::LookAtOutput(const std::uint64_t now_ns)
{
    // What closes by itself does so at its time, not when somebody looks again.
    const host::BusTime closes_at = output_.ClosesAt();
    const bool closes = closes_at != host::kNever;
    SetTime(now_ns);
    outputs_.Look(closes ? start_ns_ + static_cast<std::uint64_t>(closes_at) : now_ns, now_ns);
    application_.Run(outputs_.Open());
}

bool NodeDevice::IsSaving() const noexcept
{
    return store_ && store_->IsBusy();
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
    state_ = loading_.TakeReset() ? cia301::NodeState::kInvalid : state_; // Told again, even if it is the same.
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
            FollowConfiguration(now_ns);
        }
        const std::string name = Name(cia301::KernelState(state));
        report_.Tell(now_ns, "NMT " + name, "nmt", {{"state", name}});
    }
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left; the file, a store or a
/// commissioner may have given them. [SRS_NODE_019]
void NodeDevice::FollowConfiguration(const std::uint64_t now_ns)
{
    cycles_per_send_ = assembly_.CyclesPerSend();
    cycles_to_send_ = 0U;
    outputs_.Follow(assembly_.Core());
    application_.Follow(assembly_.Core(), model_);
    for (const SrdoModel& of_file : model_.Srdos())
    {
        // What is as in the file was told at the start.
        const SrdoModel srdo = ConfiguredSrdo(assembly_.Core(), of_file);
        if (!IsSameSrdo(srdo, of_file))
        {
            TellSrdo(report_, now_ns, config_, srdo);
        }
    }
}

// At once after a change, and every refresh time after the last time.
void NodeDevice::SendByApplication()
{
    if (cycles_per_send_ == 0U || assembly_.Device().State() != cia301::NodeState::kOperational)
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
    assembly_.SendAll();
}

void NodeDevice::Stop(const std::uint64_t now_ns)
{
    ports_.EndProduction();
    assembly_.Core().Stop();
    LookAtOutput(now_ns);
}
} // namespace counterpoint::runtime
