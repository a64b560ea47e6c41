// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA302_FAKE_SLAVE_HPP
#define TESTS_CANOPEN_CIA302_FAKE_SLAVE_HPP

#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia301/nmt/node_guarding.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace counterpoint::cia302
{

using cia301::NodeId;
using cia301::SdoAbort;
using Octets = std::vector<std::uint8_t>;

/// A slave of real services (NMT, SDO server, heartbeat, guarding) with a dictionary of the test's making, that can be
/// told to misbehave. Objects have to be there before Power.
class FakeSlave final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    FakeSlave(std::uint8_t node, cia301::FrameSink& bus);

    /// Object with a value of 1, 2 or 4 bytes, or of a whole domain.
    void Put(std::uint16_t index, std::uint8_t sub, const Octets& value);
    void Put32(std::uint16_t index, std::uint8_t sub, std::uint32_t value);
    void Put8(std::uint16_t index, std::uint8_t sub, std::uint8_t value);
    [[nodiscard]] Octets Get(std::uint16_t index, std::uint8_t sub) const;
    /// 1000h and 1018h: device type 0x191, vendor 0x2A, product 7, revision 3, serial 0x1234.
    void PutIdentity();

    void Power(Instant now);
    void Unplug();
    void OnFrame(const CanFrame& frame, Instant now);
    void OnCycle(Instant now);
    [[nodiscard]] cia301::NodeState State() const;

    cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;

    std::uint8_t node;
    bool is_on{false};
    bool has_boot_up{true};                        ///< False: it does not tell that it booted.
    bool is_sdo_mute{false};                       ///< Answers no SDO.
    bool is_self_starting{false};                  ///< OPERATIONAL without being told.
    bool is_toggle_stuck{false};                   ///< Guarding answers always with toggle 0.
    std::uint32_t boot_ms{1U};                     ///< From reset to boot-up message.
    std::uint16_t heartbeat_ms{0U};                ///< From the reset on.
    bool is_period_kept{false};                    ///< A write of another object does not begin it anew.
    std::map<std::uint32_t, SdoAbort> refused{};   ///< By key; writes and reads.
    std::map<std::uint32_t, Octets> after_reset{}; ///< Values that objects take at the next reset.
    std::vector<std::uint32_t> writes{};           ///< Keys in order.
    std::uint32_t mute_after_writes{0xFFFFFFFFU};  ///< Falls silent after as many.
    int resets{0};
    int reads{0}; ///< Of objects that it has.

  private:
    void Build();
    void Restart(Instant now);

    cia301::FrameSink& bus_;
    std::map<std::uint32_t, Octets> values_{};
    std::map<std::uint32_t, std::uint32_t> lengths_{};
    std::vector<cia301::Entry> entries_{};
    std::array<std::uint8_t, 8000> buffer_{};
    cia301::FakeObjects foreign_{};
    cia301::Dictionary dictionary_{cia301::EntryTable{nullptr, 0U}, foreign_};
    cia301::NmtSlave nmt_;
    cia301::SdoServer server_;
    cia301::SdoServerPort port_;
    cia301::HeartbeatProducer heartbeat_;
    cia301::NodeGuarding guarding_;
    Instant reset_at_{0U};
    bool is_booting_{false};
};

} // namespace counterpoint::cia302

#endif
