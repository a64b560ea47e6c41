// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_STATION_HPP
#define RUNTIME_MANAGER_STATION_HPP

#include "runtime/manager/assembly.hpp"
#include "runtime/manager/dictionary.hpp"
#include "runtime/manager/order.hpp"
#include "runtime/manager/pdos.hpp"
#include "runtime/manager/report/diagram.hpp"
#include "runtime/manager/report/journal.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// A manager with everything that watches it, on whatever bus. Its owner brings frames, time and orders, and gets
/// frames and events. Times are microseconds since the start. [SRS_MGR_001, SRS_MGR_012, SRS_MGR_156]
class ManagerStation final : private cia301::FrameSink
{
  public:
    using SendFrame = std::function<bool(const CanFrame&)>;
    using TellEvent = std::function<void(const ManagerEvent&)>;

    /// @brief `net` outlives it; `send` answers whether the bus took the frame.
    ManagerStation(network_plan::LoadedNetwork& net, SendFrame send, TellEvent tell);

    /// @brief Switches the manager on.
    void Begin(std::uint64_t now_us);
    /// @brief A frame from the bus, in bus order; never one of this manager.
    void OnFrame(const CanFrame& frame, std::uint64_t now_us);
    /// @brief Call it each ms. Tells what happened since the last call.
    void OnCycle(std::uint64_t now_us);
    /// @brief Carries out an order. Answers its result; empty for orders that the owner itself carries out.
    [[nodiscard]] std::string Carry(const ManagerOrder& order, std::uint64_t now_us);
    /// @brief Whether this object of the manager is a number that somebody may write, now or at another time.
    [[nodiscard]] bool CanSet(const ObjectAddress& object) const noexcept
    {
        return dictionary_.CanSet(object);
    }
    /// @brief The run ends: commands that wait are sent now, whatever the inhibit time. [SRS_NMM_520]
    void Finish(std::uint64_t now_us);
    /// @brief The commands that wait: "stop node 5", "reset all". [SRS_MGR_520]
    [[nodiscard]] std::vector<std::string> Unsent() const;
    /// @brief Adds an event of the bus or of a person.
    void Tell(const std::string& kind, const std::string& text, const nlohmann::ordered_json& details,
              std::uint64_t now_us);

    /// @brief The manager and its room.
    [[nodiscard]] ManagerAssembly& Assembly() noexcept
    {
        return assembly_;
    }
    /// @brief The same, to look at.
    [[nodiscard]] const ManagerAssembly& Assembly() const noexcept
    {
        return assembly_;
    }
    /// @brief Its process data.
    [[nodiscard]] const ManagerPdos& Pdos() const noexcept
    {
        return pdos_;
    }
    /// @brief Its sequence diagram.
    [[nodiscard]] const ManagerDiagram& Diagram() const noexcept
    {
        return diagram_;
    }

    /// @brief The time that it was told last.
    [[nodiscard]] std::uint64_t NowUs() const noexcept
    {
        return now_us_;
    }
    /// @brief When the node last sent a sign of life; only of one that was seen. Unlike that of the node table this
    /// time does not come round. [SRS_MGR_005]
    [[nodiscard]] std::uint64_t LastSignUs(const cia302::NodeId node) const
    {
        return last_signs_us_.at(node.value);
    }

  private:
    /// Where the writing of a safety configuration is, that its network file asks for.
    enum class Writing : std::uint8_t
    {
        kNone = 0U,
        kWanted = 1U,
        kRuns = 2U,
        kTried = 3U, ///< Once for each boot-up of the slave.
    };

    [[nodiscard]] bool Send(const CanFrame& frame) noexcept override;
    void Enter(std::uint64_t now_us);
    void Leave();
    void KeepSign(cia302::NodeId node);
    void TellInputs();
    [[nodiscard]] bool IsAllStopped() const;
    void FollowWriting(const ManagerEvent& event);
    void DriveWriting();

    SendFrame send_;
    TellEvent tell_;
    std::uint64_t now_us_{0U};
    ManagerJournal journal_;
    ManagerDiagram diagram_;
    ManagerAssembly assembly_;
    ManagerDictionary dictionary_;
    ManagerPdos pdos_;
    std::array<Writing, cia302::kNodeRoom> writing_{};
    std::array<std::uint64_t, cia302::kNodeRoom> last_signs_us_{};
};

/// @brief A time since the start as the manager's counter reads it.
[[nodiscard]] inline Instant InstantAt(const std::uint64_t us) noexcept
{
    return Instant{static_cast<std::uint32_t>(us & 0xFFFFFFFFU)};
}
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_STATION_HPP
