// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_OBJECTS_HPP
#define CANOPEN_CIA302_NETWORK_OBJECTS_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia302/network/start_up.hpp"

namespace counterpoint::cia302
{

/// What the objects show and move, kept by reference. `setup_room` and `slave_room` are the memory that `setup` and its
/// slaves stand in, where they may be written; null: the setup is constant.
struct NetworkObjectParts
{
    const NetworkSetup& setup;
    NetworkSetup* setup_room;
    SlaveSetup* slave_room;
    NodeTable& table;
    StartUp& start_up;
};

/// Hook of the entries 102Ah, 1F25h to 1F27h, 1F53h to 1F55h, 1F80h to 1F8Ah; they need no place. Arrays are numbered
/// by node-ID; sub 80h of 1F25h, 1F82h and 1F83h is all nodes. [SRS_NMM_006, SRS_NMM_210, SRS_NMM_211, SRS_NMM_212,
/// SRS_NMM_007, SRS_NMM_008, SRS_NMM_009, SRS_NMM_010]
class NetworkObjects final : public cia301::NumberHook
{
  public:
    /// @brief The parts are kept by reference.
    explicit NetworkObjects(const NetworkObjectParts& parts) noexcept;

    /// @brief Sets the time for what writes lead to. Once a cycle.
    void OnCycle(Instant now) noexcept;
    /// @brief Node-ID of the SDO client whose write is being carried out, 0 if it is not known. A command to all but
    /// the requester leaves this node out.
    void SetRequester(NodeId node) noexcept;

  private:
    [[nodiscard]] cia301::ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] SdoAbort StoreAgain(const ObjectAddress& address, std::uint32_t value) noexcept override;
    [[nodiscard]] cia301::ObjectValue FetchArray(const ObjectAddress& address) const noexcept;
    [[nodiscard]] cia301::ObjectValue FetchService(const ObjectAddress& address) const noexcept;
    [[nodiscard]] SdoAbort StoreSetup(std::uint16_t index, std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort StoreArray(const ObjectAddress& address, std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort RequestNmt(std::uint8_t sub, std::uint32_t value, cia301::Attempt attempt) noexcept;
    [[nodiscard]] SdoAbort RequestEach(NmtCommand command) noexcept;
    [[nodiscard]] SdoAbort RequestGuarding(std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] SdoAbort GuardNode(NodeId node, bool is_on) noexcept;
    [[nodiscard]] SdoAbort RequestConfiguration(std::uint8_t sub, std::uint32_t value) noexcept;

    NetworkObjectParts parts_;
    Instant now_;
    NodeId requester_;
    NmtCommand each_;   ///< A command to each that is under way, else kInvalid.
    std::uint8_t next_; ///< Node at which it goes on: the queue was full.
    bool is_other_met_; ///< In this pass of RequestEach.
};

/// Hook of the entries 1F20h, 1F22h and 1F58h: domains by node-ID, only read.
class NetworkDomains final : public cia301::ReadHook
{
  public:
    /// @brief `setup` outlives the hook.
    explicit NetworkDomains(const NetworkSetup& setup) noexcept;

    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const Room& room) noexcept override;

  private:
    const NetworkSetup& setup_;
};

} // namespace counterpoint::cia302

#endif
