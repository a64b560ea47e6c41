// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_DEVICE_HPP
#define VERIFICATION_THIRD_VOICE_DEVICE_HPP

#include "safety_core/contract/channel.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/object_access.hpp"
#include "verification/third_voice/consumer.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::third_voice
{
/// The objects of one SRDO as a client on the bus sees them.
struct SrdoObjects
{
    std::uint32_t direction{0U};
    std::uint32_t sct_ms{0U};
    std::uint32_t srvt_ms{0U};
    std::uint32_t transmission_type{254U};
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::uint32_t count{0U};
    std::vector<std::uint32_t> entries; ///< As many as the device has room for.
    std::uint32_t signature{0U};
};

/// What somebody in front of the device sees behind a call.
struct Seen
{
    std::vector<std::pair<std::uint8_t, SrdoCause>> signals; ///< Number of the SRDO and cause.
    std::vector<std::uint8_t> events;                        ///< Numbers of SRDOs that were released.
    int gfcs{0};
    bool is_configuration_invalid{false};
};

/// CRC of 13FFh, bit by bit. [semantics 7]
[[nodiscard]] std::uint16_t SignatureOf(const SrdoObjects& srdo);

/// One rule that is broken on purpose: a comparison that does not see it shows nothing. [SRS_VER_032]
enum class Flaw : std::uint8_t
{
    kNone = 0U,
    kSctLonger,     ///< SCT is one microsecond longer.
    kSrvtLonger,    ///< SRVT is.
    kNoInversion,   ///< The inverse frame is not compared.
    kNoSignature,   ///< 13FFh is not.
    kKeepsReleased, ///< Leaving OPERATIONAL writes no safe value.
};

/// A whole device as docs/semantics.md describes it: configuration, consumers, GFC; one time for both counters.
class Device
{
  public:
    using Address = std::pair<std::uint16_t, std::uint8_t>;

    /// @brief `config` outlives it. Initial values of the objects are told by SetInitial: what a device has at power-on
    /// is its own affair.
    explicit Device(const DeviceConfig& config, Flaw flaw = Flaw::kNone);

    void SetInitial(std::uint8_t number, const SrdoObjects& objects);
    void SetGfcParameter(std::uint32_t value);
    void Start();

    [[nodiscard]] AbortCode Write(Address address, std::uint64_t value, std::size_t size);
    void SetNmt(NmtState state);
    void OnFrame(const CanFrame& frame, Time stamp);
    void Cycle(Time now, SrdoMask acknowledge_a, SrdoMask acknowledge_b);

    [[nodiscard]] std::uint64_t Variable(Address address) const;
    [[nodiscard]] bool IsValid() const;
    [[nodiscard]] const SrdoObjects& Objects(std::uint8_t number) const;
    [[nodiscard]] SrdoState StateOf(std::uint8_t number) const;
    [[nodiscard]] SrdoMask Open() const;
    [[nodiscard]] Seen TakeSeen();

  private:
    struct Srdo
    {
        const SrdoSetup* setup{nullptr};
        SrdoObjects objects{};
        std::array<Consumer, 2U> observers{};
        std::uint32_t written_ordinal{0U};
        bool is_released{false};
    };

    [[nodiscard]] AbortCode WriteParameter(Srdo& srdo, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] AbortCode WriteMapping(Srdo& srdo, std::uint8_t sub, std::uint32_t value);
    [[nodiscard]] AbortCode WriteValid(std::uint32_t value);
    [[nodiscard]] AbortCode CheckIdentifier(const Srdo& srdo, std::uint32_t cob_id_1, std::uint32_t cob_id_2) const;
    [[nodiscard]] bool IsSound(const Srdo& srdo) const;
    [[nodiscard]] bool IsMappingSound(const Srdo& srdo) const;
    [[nodiscard]] const MappableObject* ObjectOf(std::uint32_t entry) const;
    [[nodiscard]] ConsumerRules RulesOf(const Srdo& srdo) const;
    [[nodiscard]] Srdo* Find(std::uint8_t number);     ///< Null: there is none.
    [[nodiscard]] Srdo& Existing(std::uint8_t number); ///< Throws std::out_of_range.
    [[nodiscard]] const Srdo& Existing(std::uint8_t number) const;
    void Keep(std::uint32_t& place, std::uint32_t value);
    void WriteSafe(const Srdo& srdo);
    void WriteData(const Srdo& srdo, std::uint64_t normal);
    void Enter(Time now);
    void Leave();
    void Decide(Srdo& srdo, Time now);
    [[nodiscard]] SrdoMask BitOf(const Srdo& srdo) const;

    const DeviceConfig& config_;
    Flaw flaw_;
    std::vector<Srdo> srdos_;
    std::map<Address, std::uint64_t> variables_;
    std::uint32_t gfc_parameter_{0U};
    std::uint32_t valid_{0U};
    NmtState nmt_{NmtState::kInitialising};
    bool has_gfc_{false};
    bool has_left_{false};           ///< Since the last cycle: that one shows it, whatever came behind.
    bool has_entered_{false};        ///< OPERATIONAL, and a cycle saw it.
    std::vector<std::uint8_t> left_; ///< Consumers that the next cycle tells of leaving OPERATIONAL.
    bool is_running_{false};         ///< OPERATIONAL with a valid configuration.
    Seen seen_{};
};
} // namespace counterpoint::third_voice

#endif
