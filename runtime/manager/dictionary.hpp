// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_DICTIONARY_HPP
#define RUNTIME_MANAGER_DICTIONARY_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia301/sdo/server.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "runtime/device/objects/hooks.hpp"
#include "runtime/manager/objects.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The manager as a device on the bus: its object dictionary, and the SDO server at its node-ID. It cannot be moved or
/// copied. [SRS_MGR_020, SRS_MGR_150, SRS_MGR_151]
class ManagerDictionary
{
  public:
    /// @brief All outlive it. Throws cia306::InputError for a value of the manager's DCF that its type cannot have.
    ManagerDictionary(ManagerAssembly& assembly, network_plan::LoadedNetwork& net, cia301::FrameSink& sink);
    ManagerDictionary(const ManagerDictionary&) = delete;
    ManagerDictionary& operator=(const ManagerDictionary&) = delete;

    /// @brief A frame from the bus; answers in PRE-OPERATIONAL and OPERATIONAL only.
    void OnFrame(const CanFrame& frame, Instant now);
    /// @brief Once a cycle: writes that wait for the command queue, and the time-outs of transfers.
    void OnCycle(Instant now);
    /// @brief The sink may have room: an answer that found none leaves. [SRS_MGR_321]
    void OnRoom() noexcept
    {
        port_.OnRoom();
    }
    /// @brief The value of an object as text, in whatever NMT state, or why there is none.
    [[nodiscard]] std::string Get(const ObjectAddress& object, Instant now);
    /// @brief Whether it has such a number and lets somebody write it.
    [[nodiscard]] bool CanSet(const ObjectAddress& object) const noexcept;
    /// @brief Writes an object as the application does. Answers "taken", or the abort code and its meaning.
    [[nodiscard]] std::string Set(const ObjectAddress& object, std::uint64_t value, Instant now);

  private:
    [[nodiscard]] cia301::Moment Begin(Instant now);
    void AddValue(std::uint16_t index, std::uint8_t sub, cia301::DataType type, std::uint32_t value);
    void AddBytes(std::uint16_t index, std::uint8_t sub, cia301::DataType type, std::vector<std::uint8_t> value);
    void AddHook(std::uint16_t index, std::uint8_t sub, cia301::DataType type, cia301::Access access);
    void AddArray(std::uint16_t index, cia301::DataType type, cia301::Access access);
    void AddIdentity();
    void AddConsumers();
    void AddNetwork();
    void AddFlying();
    void Sort();

    ManagerAssembly& assembly_;
    network_plan::LoadedNetwork& net_;
    ManagerObjects objects_;
    std::vector<cia301::Entry> entries_;
    std::deque<std::vector<std::uint8_t>> values_;
    std::uint32_t domain_length_{0U}; ///< Domains come by hooks; their entries need a place for a length.
    std::vector<std::uint8_t> buffer_;
    cia301::NoObjects no_safety_;
    cia301::Dictionary dictionary_;
    cia301::SdoServer server_;
    cia301::SdoServerPort port_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_DICTIONARY_HPP
