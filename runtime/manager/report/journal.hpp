// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_REPORT_JOURNAL_HPP
#define RUNTIME_MANAGER_REPORT_JOURNAL_HPP

#include "canopen/manager/manager.hpp"
#include "runtime/manager/assembly.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::runtime
{
/// What each JSON object of a manager begins with. [SRS_EASE_005]
constexpr const char* kManagerFormat = "counterpoint-manager-1";

/// An event of the network.
struct ManagerEvent
{
    std::uint64_t at_us{0U}; ///< Since the start.
    std::uint8_t node{0U};   ///< 0: the network or the manager.
    std::string kind;
    std::string text; ///< For people; empty: only programs want to know.
    nlohmann::ordered_json details;
    std::string word; ///< The part of `details` that this program itself uses: state of a gate, letter of a status.
};

/// @brief An event as a line of the event log. [SRS_MGR_007]
[[nodiscard]] std::string JsonLine(const ManagerEvent& event);
/// @brief An event as a line for a person: time, node, text.
[[nodiscard]] std::string TextLine(const ManagerEvent& event);

/// Makes events of what the manager tells, in order. [SRS_MGR_007]
class ManagerJournal final : public cia302::ManagerListener
{
  public:
    /// @brief The manager whose events these are; call it before anything is told.
    void Watch(const ManagerAssembly& assembly) noexcept
    {
        assembly_ = &assembly;
    }
    /// @brief What is done when the sink of the manager may have room; see cia302::ManagerListener.
    void WhenRoom(std::function<void(Instant)> action)
    {
        when_room_ = std::move(action);
    }
    /// @brief Sets the time of what is told from now on.
    void SetNow(const std::uint64_t since_start_us) noexcept
    {
        now_us_ = since_start_us;
    }
    /// @brief All events since the last call.
    [[nodiscard]] std::vector<ManagerEvent> Take();
    /// @brief Adds an event that the manager itself does not tell: of orders and of the bus.
    void Tell(std::uint8_t node, const std::string& kind, const std::string& text,
              const nlohmann::ordered_json& details, const std::string& word = {});

    void OnNodeEvent(cia302::NodeId node, cia302::NodeEvent event, Instant now) noexcept override;
    void OnNodeStatus(cia302::NodeId node, Instant now) noexcept override;
    void OnMasterState(std::int16_t state, Instant now) noexcept override;
    void OnNmtSent(const cia302::NmtRequest& request, Instant now) noexcept override;
    void OnNmtUnsent(const cia302::NmtRequest& request, Instant now) noexcept override;
    void OnGate(cia302::NodeId node, cia302::GateState state, Instant now) noexcept override;
    void OnEmergency(cia302::NodeId node, const cia302::EmergencyRecord& emergency, Instant now) noexcept override;
    void OnDuplicate(cia302::NodeId node, Instant now) noexcept override;
    void OnFlyingMaster(cia302::FlyingEvent event, const cia302::MasterClaim& claim, Instant now) noexcept override;
    void OnRoom(Instant now) noexcept override;

  private:
    /// What was last told of a slave for people.
    struct Told
    {
        char letter{0};
        std::int16_t code{0};
        bool is_started{false};
        cia301::SdoAbort abort{cia301::SdoAbort::kNone}; ///< Of 1000h, while it is asked again.
    };

    const ManagerAssembly* assembly_{nullptr};
    std::uint64_t now_us_{0U};
    std::vector<ManagerEvent> events_;
    std::array<Told, cia302::kNodeRoom> told_{};
    std::function<void(Instant)> when_room_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_REPORT_JOURNAL_HPP
