// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_LOADED_NETWORK_HPP
#define CANOPEN_NETWORK_PLAN_LOADED_NETWORK_HPP

#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/network_plan/concise_maker.hpp"
#include "canopen/network_plan/network_plan.hpp"
#include "canopen/network_plan/profile_maker.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::network_plan
{
/// One slave with everything that its SlaveSetup points to.
struct LoadedSlave
{
    SlavePlan plan;
    cia306::Device device;
    std::vector<ConciseEntry> entries;
    std::vector<std::uint8_t> concise;
    std::vector<std::uint8_t> downloaded; ///< The concise DCF instead of the one that its DCF makes.
    std::string dcf_text;                 ///< As 1F20h shows it.
    std::vector<std::uint8_t> program;    ///< Octets of the software.
    std::vector<cia302::ExpectedObject> objects;
    cia302::SafetyExpectation safety{nullptr, 0U};
    ProfileSlave profile;
};

/// A network as the manager needs it, made from its file and the DCFs of its devices. Its parts refer to each other, so
/// it cannot be moved or copied.
class LoadedNetwork
{
  public:
    /// @brief Reads every DCF that the plan names. Throws cia306::InputError. [SRS_NET_003, SRS_NET_004, SRS_NET_005]
    explicit LoadedNetwork(const NetworkPlan& plan);
    LoadedNetwork(const LoadedNetwork&) = delete;
    LoadedNetwork& operator=(const LoadedNetwork&) = delete;

    /// @brief What the network file says.
    [[nodiscard]] const NetworkPlan& Plan() const noexcept
    {
        return plan_;
    }
    /// @brief The network as the manager takes it.
    [[nodiscard]] const cia302::NetworkSetup& Setup() const noexcept
    {
        return setup_;
    }
    /// @brief The same, to be written to.
    [[nodiscard]] cia302::NetworkSetup& SetupRoom() noexcept
    {
        return setup_;
    }
    /// @brief Its slaves by node-ID, to be written to.
    [[nodiscard]] cia302::SlaveSetup* SlaveRoom() noexcept
    {
        return slaves_.data();
    }
    /// @brief The manager's own DCF; without objects if there is none.
    [[nodiscard]] const cia306::Device& Device() const noexcept
    {
        return device_;
    }
    /// @brief Gives a slave another concise DCF; not while it is being written. False: there is no such slave, or the
    /// bytes are damaged.
    [[nodiscard]] bool ReplaceConcise(std::uint8_t node, const cia302::Bytes& bytes);
    /// @brief The slaves, in the order of the file.
    [[nodiscard]] const std::vector<std::unique_ptr<LoadedSlave>>& Slaves() const noexcept
    {
        return loaded_;
    }
    /// @brief The slave with this node-ID; null: the network has none.
    [[nodiscard]] const LoadedSlave* Find(std::uint8_t node) const noexcept;
    /// @brief The same, to be written to.
    [[nodiscard]] LoadedSlave* Find(std::uint8_t node) noexcept;
    /// @brief What a person should know before the network starts, a line each.
    [[nodiscard]] const std::vector<std::string>& Warnings() const noexcept
    {
        return warnings_;
    }

  private:
    void RequireManager() const;
    void RequireNode(const cia306::Device& device, std::uint8_t node, Place place, const std::string& who) const;
    void RequireNodes() const;
    void Load(const SlavePlan& plan);
    void Fill(LoadedSlave& slave, cia302::SlaveSetup& setup) const;
    void FillIdentity(const LoadedSlave& slave, cia302::SlaveSetup& setup) const;
    void FillHeartbeat(LoadedSlave& slave, cia302::SlaveSetup& setup) const;
    static void FillSoftware(const LoadedSlave& slave, cia302::SlaveSetup& setup);
    void RequireSense(const LoadedSlave& slave, const cia302::SlaveSetup& setup) const;
    void RequireSoftware(const SlavePlan& plan) const;
    void RequireSync() const;
    void FillManager();

    NetworkPlan plan_;
    cia306::Device device_;
    std::array<cia302::SlaveSetup, cia302::kNodeRoom> slaves_{};
    std::vector<std::unique_ptr<LoadedSlave>> loaded_;
    cia302::NetworkSetup setup_{};
    std::vector<std::string> warnings_;
};

/// @brief The safety configuration that a DCF gives its device, for the gate; empty: the DCF describes no SRDO.
/// [SRS_NET_003]
/// Throws cia306::InputError for the first rule that the configuration breaks: what is expected has to be right.
/// [SRS_NET_003, SRS_NET_004]
[[nodiscard]] std::vector<cia302::ExpectedObject> MakeExpectation(const cia306::Device& device, std::uint8_t node_id);

/// @brief Puts what the manager's own DCF says (1F80h to 1F90h, 1F26h, 1F27h, 1006h, 1016h, 1017h, 102Ah) where the
/// network file says nothing. Throws cia306::InputError. [SRS_NET_003]
void TakeManagerObjects(const cia306::Device& device, NetworkPlan& plan);

/// @brief What a network file asks for without effect, a line each. What cannot work at all is refused by
/// LoadedNetwork. `network` is complete. [SRS_NET_006, SRS_NET_151, SRS_NET_153]
[[nodiscard]] std::vector<std::string> WarningsOf(const LoadedNetwork& network);
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_LOADED_NETWORK_HPP
