// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/report/journal.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/names.hpp"
#include "runtime/manager/report/texts.hpp"

#include <cstdio>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
using cia302::NodeId;

std::string Letter(const char letter)
{
    return (letter == 0) ? std::string{} : std::string(1U, letter);
}

/// "D: vendor-ID differs (0x1018:01 is 0x2, expected 0x1)"
} // namespace

std::string JsonLine(const ManagerEvent& event)
{
    nlohmann::ordered_json line{
        {"format", kManagerFormat}, {"t_us", event.at_us}, {"node", event.node}, {"event", event.kind}};
    if (event.details.is_object())
    {
        line.update(event.details);
    }
    if (!event.text.empty())
    {
        line["text"] = event.text;
    }
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string TextLine(const ManagerEvent& event)
{
    constexpr double kUsPerSecond = 1e6;
    constexpr std::size_t kRoom = 48U;
    char head[kRoom];
    const double seconds = static_cast<double>(event.at_us) / kUsPerSecond;
    if (event.node == 0U)
    {
        std::snprintf(head, sizeof(head), "%10.3f s  network   ", seconds);
    }
    else
    {
        std::snprintf(head, sizeof(head), "%10.3f s  node %3u  ", seconds, static_cast<unsigned>(event.node));
    }
    return head + event.text;
}

std::vector<ManagerEvent> ManagerJournal::Take()
{
    return std::exchange(events_, {});
}

void ManagerJournal::Tell(const std::uint8_t node, const std::string& kind, const std::string& text,
                          const nlohmann::ordered_json& details, const std::string& word)
{
    events_.push_back({now_us_, node, kind, text, details, word});
}

void ManagerJournal::OnNodeEvent(const NodeId node, const cia302::NodeEvent event, const Instant /*now*/) noexcept
{
    const std::string state = WordOf(assembly_->Core().Table().Record(node).state);
    const bool is_change = event == cia302::NodeEvent::kChanged || event == cia302::NodeEvent::kStarted;
    const bool is_missed = event == cia302::NodeEvent::kGuardMissed;
    const std::string text = Words(is_change ? state : WordOf(event));
    Tell(node.value, WordOf(event), is_missed ? "" : text, {{"state", state}});
}

void ManagerJournal::OnNodeStatus(const NodeId node, const Instant /*now*/) noexcept
{
    const cia302::NodeStatus status = assembly_->Core().Status(node);
    const network_plan::StartProfile profile = assembly_->Net().Plan().manager.profile;
    Told& told = told_.at(node.value & cia302::kLastNode);
    const bool is_waiting = IsAskedAgain(status);
    const bool is_new_wait = is_waiting && told.abort != status.abort;
    const bool is_news = told.letter != status.letter || told.code != status.code ||
                         (status.is_started && !told.is_started) || is_new_wait;
    told = {status.letter, status.code, status.is_started, is_waiting ? status.abort : cia301::SdoAbort::kNone};
    const bool says_something = status.letter != 0 || is_waiting || profile != network_plan::StartProfile::kCia302;
    std::string text = (is_news && says_something) ? StatusText(profile, status) : "";
    text = (is_news && status.is_started && text.empty()) ? "started" : text;
    Tell(node.value, "status", text,
         {{"letter", Letter(status.letter)},
          {"code", status.code},
          {"step", WordOf(status.step)},
          {"object", cia306::ObjectName(status.object.index, status.object.sub)},
          {"abort", static_cast<std::uint32_t>(status.abort)},
          {"expected", status.expected},
          {"read", status.read},
          {"started", status.is_started}},
         Letter(status.letter));
}

void ManagerJournal::OnMasterState(const std::int16_t state, const Instant /*now*/) noexcept
{
    const std::string text = MasterText(assembly_->Net().Plan().manager.profile, state);
    Tell(0U, "master", "master: " + text, {{"state", state}, {"word", text}});
}

void ManagerJournal::OnNmtSent(const cia302::NmtRequest& request, const Instant /*now*/) noexcept
{
    const bool is_all = request.node.value == cia302::kAllNodes.value;
    Tell(request.node.value, "nmt", "NMT " + WordOf(request.command) + (is_all ? " all" : ""),
         {{"command", WordOf(request.command)}});
}

/// [SRS_MGR_800]
void ManagerJournal::OnNmtUnsent(const cia302::NmtRequest& request, const Instant /*now*/) noexcept
{
    const bool is_all = request.node.value == cia302::kAllNodes.value;
    Tell(request.node.value, "nmt_unsent",
         "NMT " + WordOf(request.command) + (is_all ? " all" : "") + " has not left: no active master any more",
         {{"command", WordOf(request.command)}});
}

void ManagerJournal::OnGate(const NodeId node, const cia302::GateState state, const Instant /*now*/) noexcept
{
    const cia302::GateFinding finding = assembly_->Core().Gate().Finding(node);
    const bool is_refused = state == cia302::GateState::kDiffers || state == cia302::GateState::kFailed;
    const std::string found = is_refused ? FindingText(finding) : "";
    std::string text = is_refused ? "safety configuration refused: " + found : "";
    text = (state == cia302::GateState::kOpen) ? "safety configuration verified" : text;
    nlohmann::ordered_json details{{"state", WordOf(state)}};
    if (is_refused)
    {
        details["object"] = cia306::ObjectName(finding.object.index, finding.object.sub);
        details["abort"] = static_cast<std::uint32_t>(finding.abort);
        details["expected"] = finding.expected;
        details["read"] = finding.read;
    }
    Tell(node.value, "gate", text, details, WordOf(state));
}

void ManagerJournal::OnEmergency(const NodeId node, const cia302::EmergencyRecord& emergency,
                                 const Instant /*now*/) noexcept
{
    const std::string more =
        (emergency.untold == 0U) ? "" : ", and " + std::to_string(emergency.untold) + " before it in a storm";
    Tell(node.value, "emergency",
         "emergency " + cia306::Hex(emergency.code, 4) + ", register " + cia306::Hex(emergency.error_register, 2) +
             more,
         {{"code", emergency.code}, {"register", emergency.error_register}, {"left_out", emergency.untold}});
}

void ManagerJournal::OnDuplicate(const NodeId node, const Instant /*now*/) noexcept
{
    const bool is_own = node.value == assembly_->Net().Setup().own.value;
    Tell(node.value, "duplicate",
         is_own ? "another device has the manager's node-ID" : "suspected: two devices with this node-ID", {});
}

void ManagerJournal::OnFlyingMaster(const cia302::FlyingEvent event, const cia302::MasterClaim& claim,
                                    const Instant /*now*/) noexcept
{
    const bool has_claim =
        event != cia302::FlyingEvent::kForceNegotiation && event != cia302::FlyingEvent::kPowerOnReset;
    std::string text = "flying master: " + Words(WordOf(event));
    text += has_claim ? " (priority " + std::to_string(claim.level) + ", node " + std::to_string(claim.node.value) + ")"
                      : "";
    Tell(0U, "flying_master", text,
         {{"number", static_cast<unsigned>(event)},
          {"word", WordOf(event)},
          {"priority", claim.level},
          {"master", claim.node.value}},
         std::to_string(static_cast<unsigned>(event)));
}

void ManagerJournal::OnRoom(const Instant now) noexcept
{
    if (when_room_)
    {
        when_room_(now);
    }
}
} // namespace counterpoint::runtime
