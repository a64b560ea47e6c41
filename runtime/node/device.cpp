// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/digest.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "names/safety_core/kernel/start_check.hpp"
#include "runtime/device/names.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kPressNs = 200000000U;
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kPressCycles = 4U;
/// Of a device that waits for its node-ID: nobody sees it.
constexpr std::uint8_t kPlaceholder = 127U;

/// Node-ID: what LSS gave in this run, what it saved, then the command line and the file.
cia305::LssSettings LssSettingsOf(const NodeSettings& settings, const cia306::Device& file, NodeStore* const store)
{
    const std::optional<std::uint8_t> wanted = settings.node_id ? settings.node_id : file.node_id;
    cia305::LssSettings known{wanted.value_or(cia305::kNoNodeId), {0U}};
    known = (store == nullptr) ? known : store->LoadLss(known);
    known.node_id = settings.lss_node_id.value_or(known.node_id);
    return known;
}

/// With a second controller the inverse frames are sent and received by it. [SRS_NODE_014]
const DeviceModel& UseControllers(DeviceModel& model, NodePorts& ports)
{
    const bool has_second = ports.Inverse() != nullptr;
    if (has_second)
    {
        model.UseTwoControllers();
    }
    else if (model.ControllerCount() != 1U)
    {
        throw cia306::InputError(
            model.File(), {}, {"a device with two controllers (0x5F00:0F and 0x5F00:10)", "--can2 for the second one"});
    }
    return model;
}

/// The node-ID instead of the file's: what LSS gave, else that of the command line; nothing: the file's holds. A device
/// that waits for LSS gets a placeholder. [SRS_NODE_015, SRS_NODE_150]
std::optional<std::uint8_t> NodeIdOf(const NodeSettings& settings, const cia306::Device& file, const bool has_lss)
{
    const std::optional<std::uint8_t> wanted = settings.lss_node_id ? settings.lss_node_id : settings.node_id;
    const bool is_waiting = has_lss && !wanted && !file.node_id;
    return is_waiting ? std::optional(kPlaceholder) : wanted;
}

/// The node-ID that LSS took away, now; 0: none. `had` is the one with which the device was on the bus. [SRS_NODE_470]
std::uint8_t LostNodeId(std::uint8_t& had, const cia301::NodeState state, const std::uint8_t node_id)
{
    const bool is_on_bus = cia301::StateByte(state) != 0U;
    const bool is_lost = !is_on_bus && had != 0U && node_id == 0U;
    const std::uint8_t before = had;
    had = (is_on_bus || is_lost) ? node_id : had;
    return is_lost ? before : std::uint8_t{0U};
}

KeepLss KeeperOf(NodeStore* const store)
{
    return (store == nullptr) ? KeepLss{} : [store](const cia305::LssSettings& settings)
    { return store->Keep(settings); };
}

std::string Milliseconds(const std::uint32_t us)
{
    return MillisecondsText(Nanoseconds{us} * kNanosecondsPerMicrosecond);
}

/// Writes that the digest of the file is not expected, and whether it was right, where the device differs from its
/// file. [SRS_NODE_042]
void TellDigest(NodeReport& report, const std::uint64_t at_ns, const cia306::Device& file, const DeviceConfig& config)
{
    const cia306::DigestRecord digest =
        cia306::ExtractDigest(file, cia306::ExtractSafety(file, file.node_id), file.node_id);
    if (config.digest != 0U || digest.stored.value.value_or(0U) == 0U)
    {
        return;
    }
    const bool is_right = digest.problems.empty() && digest.stored.Is(cia306::DigestOf(digest.fields));
    report.Tell(at_ns,
                std::string("no device digest is expected: cycle, node-ID or controllers are not those of the file") +
                    (is_right ? "" : ", whose 0x5F04:00 is not its digest"),
                "no_digest", {{"is_right", is_right}});
}
} // namespace

NodeRefusals::NodeRefusals(NodeReport& report, const std::string& file,
                           std::vector<cia306::Finding>* const list) noexcept
    : report_(report), file_(file), list_(list)
{
}

void NodeRefusals::Tell(const std::uint64_t at_ns, const std::vector<cia306::Finding>& findings)
{
    for (cia306::Finding finding : findings)
    {
        Keep(finding);
        const bool is_kernels = finding.severity == cia306::Severity::kError;
        finding.text += is_kernels ? ", expected what 'counterpoint check' finds right" : "";
        finding.severity = cia306::Severity::kWarning; // The device goes on without the value.
        const std::string line = cia306::FormatFinding(file_, finding);
        report_.Tell(at_ns, line, "refused", {{"text", line}});
    }
}

void NodeRefusals::TellNoStart(const std::uint64_t at_ns, const StartResult result)
{
    const std::string text = NoStartText(result);
    Keep({cia306::Severity::kError, {}, "", text});
    report_.Tell(at_ns, text, "no_start", {{"reason", NameOf(result)}, {"text", text}});
}

void NodeRefusals::Keep(const cia306::Finding& finding)
{
    if (list_ != nullptr)
    {
        list_->push_back(finding);
    }
}

NodeDevice::NodeDevice(const NodeSettings& settings, NodePorts& ports, NodeReport& report)
    : report_(report), ports_(ports), file_(cia306::ReadDeviceFile(settings.dcf)),
      has_lss_(settings.has_lss || file_.is_lss_supported),
      model_(settings.dcf, NodeIdOf(settings, file_, has_lss_), SafetyNeed::kOptional),
      config_(ConfigOf(UseControllers(model_, ports), settings.cycle_us)), time_(host::BitRate::k500k),
      watchdog_(time_), output_(time_, watchdog_, {config_.cycle_us + config_.cycle_tolerance_us}),
      channel_a_(MakeChannel(Letter::kA, RoomOf(config_))), channel_b_(MakeChannel(Letter::kB, RoomOf(config_))),
      application_(model_, file_, report),
      self_test_(settings.has_self_tests ? std::make_unique<NodeSelfTest>(output_) : nullptr),
      outputs_(model_, output_, report), srdos_(model_, config_, report),
      assembly_(model_, config_,
                {channel_a_->Voice(), channel_b_->Voice(), ports, output_, watchdog_, application_,
                 self_test_ ? &self_test_->Part() : nullptr, *this, &file_, nullptr, settings.domain_bytes}),
      transfers_(assembly_.Optional(), report),
      store_(settings.store.empty() ? nullptr
                                    : std::make_unique<NodeStore>(
                                          settings.store, NodeStoreParts{assembly_.Core(), assembly_.Objects().Table(),
                                                                         assembly_.Objects(), assembly_.Dictionary(),
                                                                         assembly_.Services()})),
      refusals_(report, model_.File(), settings.refused)
{
    assembly_.Connect(store_ ? &store_->Hook() : nullptr);
    FurnishSelfTest();
    if (has_lss_)
    {
        assembly_.UseLss(file_, LssSettingsOf(settings, file_, store_.get()), KeeperOf(store_.get()));
    }
    application_.Tell([this](const std::uint8_t srdo) { outputs_.OnPair(srdo); });
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
            model_.File(), model_.IntervalPlace(),
            {"the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) + " cycles",
             "a longer one (0x5F00:04), or --no-self-tests"});
    }
}

void NodeDevice::SetTime(const std::uint64_t now_ns)
{
    time_.Advance(static_cast<host::BusTime>(now_ns - start_ns_));
    application_.SetNow(now_ns);
    now_ns_ = now_ns;
}

void NodeDevice::TellStart(const std::string& buses, const std::uint64_t now_ns)
{
    const std::uint8_t node_id = assembly_.NodeId();
    report_.Tell(now_ns,
                 (node_id != 0U ? "node " + std::to_string(config_.node_id) : std::string("node without a node-ID")) +
                     " of " + cia306::Printable(model_.File()) + " on " + buses + ", cycle " +
                     Milliseconds(config_.cycle_us) + ", late above " +
                     Milliseconds(config_.cycle_us + config_.cycle_tolerance_us),
                 "start",
                 {{"node_id", node_id},
                  {"dcf", model_.File()},
                  {"can", buses},
                  {"cycle_us", config_.cycle_us},
                  {"cycle_tolerance_us", config_.cycle_tolerance_us}});
    const std::string covered = self_test_ ? self_test_->Text() : "none";
    report_.Tell(now_ns, "self tests: " + covered, "self_tests", {{"covered", covered}});
    TellDigest(report_, now_ns, file_, config_);
    if (model_.Srdos().empty())
    {
        report_.Tell(now_ns, "no safety objects: a plain CANopen device", "plain", nlohmann::ordered_json::object());
    }
    srdos_.TellFile(now_ns);
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
    const bool has_restarted = std::exchange(has_restarted_, false);
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

void NodeDevice::Cycle(const InstantPair& now, const std::uint64_t now_ns)
{
    SetTime(now_ns);
    SendByApplication();
    outputs_.BeginCycle();
    SrdoMask levels = 0U;
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        levels |= (now_ns < pressed_until_ns_[slot]) ? SrdoMask{1U} << slot : SrdoMask{0U};
    }
    assembly_.Device().Cycle({now, levels, levels});
    if (store_)
    {
        store_->OnCycle();
    }
    transfers_.Look(now_ns_);
    TellSelfTest();
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
    transfers_.Look(now_ns_);
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

void NodeDevice::TellState(const std::uint64_t now_ns)
{
    const cia301::NodeState state = assembly_.Device().State();
    const bool is_told_invalid = application_.TakeInvalid();
    state_ =
        std::exchange(has_reset_, false) ? cia301::NodeState::kInvalid : state_; // Told again, even if it is the same.
    if (const std::uint8_t lost = LostNodeId(node_id_, state, assembly_.NodeId()); lost != 0U)
    {
        report_.Tell(now_ns, "LSS took node-ID " + std::to_string(lost) + " away: node without a node-ID", "lss",
                     {{"node_id", 0}});
    }
    if (state != state_)
    {
        const bool is_configured = state_ == cia301::NodeState::kInvalid && cia301::StateByte(state) != 0U;
        const auto is_saved = [this](const ObjectAddress& object) { return store_ && store_->Loaded().Has(object); };
        refusals_.Tell(now_ns, is_configured ? assembly_.Objects().NotTaken(is_saved) : std::vector<cia306::Finding>{});
        for (const std::string& line : is_configured&& store_ ? store_->NotTaken() : std::vector<std::string>{})
        {
            report_.Tell(now_ns, line, "store", {{"text", line}});
        }
        if (is_configured && store_)
        {
            srdos_.TellSaved(assembly_.Core(), now_ns);
        }
        state_ = state;
        if (state == cia301::NodeState::kOperational)
        {
            FollowConfiguration(now_ns, is_told_invalid);
        }
        const std::string name = Name(cia301::KernelState(state));
        report_.Tell(now_ns, "NMT " + name, "nmt", {{"state", name}});
    }
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left; the file, a store or a
/// commissioner may have given them. [SRS_NODE_019]
void NodeDevice::FollowConfiguration(const std::uint64_t now_ns, const bool is_told_invalid)
{
    cycles_per_send_ = assembly_.CyclesPerSend();
    cycles_to_send_ = 0U;
    outputs_.Follow(assembly_.Core());
    application_.Follow(assembly_.Core(), model_);
    srdos_.Follow(assembly_.Core(), now_ns, is_told_invalid);
}

// At once after a change, and every refresh time after the last time. [SRS_NODE_025]
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
    application_.WriteOut(); // What has changed since the last cycle is what it sends.
    assembly_.SendAll();
}

void NodeDevice::Stop(const std::uint64_t now_ns)
{
    ports_.EndProduction();
    assembly_.Core().Stop();
    LookAtOutput(now_ns);
}

/// Tells once when a self test has failed; called once a cycle, too: a cycle that a self test ends before any part is
/// called tells nobody.
void NodeDevice::TellSelfTest()
{
    const std::string failure = self_test_ ? self_test_->Failure() : "";
    if (!failure.empty() && !has_told_test_)
    {
        report_.Tell(now_ns_, "self test failed: " + failure, "self_test", {{"failed", failure}});
    }
    has_told_test_ = !failure.empty();
}

void NodeDevice::OnStart() noexcept
{
    if (self_test_)
    {
        has_told_test_ = false;
        self_test_->Start();
        TellSelfTest();
    }
}

void NodeDevice::OnNoStart(const StartResult result) noexcept
{
    refusals_.TellNoStart(now_ns_, result);
}

/// What is wrong with the store's file is told once, not at each reset.
void NodeDevice::OnLoaded(const std::uint8_t groups) noexcept
{
    has_restarted_ = has_restarted_ || (groups & cia301::kApplicationGroup) != 0U;
    const std::string warning = store_ ? store_->Load(groups) : "";
    if (!warning.empty() && warning != store_warning_)
    {
        report_.Tell(now_ns_, warning, "store", {{"text", warning}});
        store_warning_ = warning;
    }
}

void NodeDevice::OnRefused(const ConfigurationWrite& write, const AbortCode code) noexcept
{
    refusals_.Tell(now_ns_,
                   {{cia306::Severity::kError, write.place, cia306::ObjectName(write.object.index, write.object.sub),
                     "the kernel refuses " + cia306::Hex(write.value, write.size_bytes * 2) + " with abort code " +
                         AbortText(code)}});
}

void NodeDevice::OnResetCommunication(const std::vector<cia306::Finding>& refusals) noexcept
{
    has_reset_ = true;
    refusals_.Tell(now_ns_, refusals);
}

void NodeDevice::OnTime(const cia301::TimeOfDay& time, const Instant now) noexcept
{
    static_cast<void>(now);
    report_.Tell(now_ns_, TextOf(time), "time", {{"ms", time.ms}, {"days", time.days}});
}

void NodeDevice::OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept
{
    report_.Tell(now_ns_, TextOf(emergency), "emergency",
                 {{"node", emergency.node.value}, {"code", emergency.code}, {"register", emergency.error_register}});
}
} // namespace counterpoint::runtime
