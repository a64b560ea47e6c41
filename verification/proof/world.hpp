// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_WORLD_HPP
#define VERIFICATION_PROOF_WORLD_HPP

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "safety_core/contract/channel.hpp"
#include "verification/proof/domain.hpp"
#include "verification/proof/witness.hpp"
#include "verification/third_voice/consumer.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::proof
{

/// A place in memory that belongs to the state.
struct Region
{
    void* first;
    std::size_t bytes;
};

/// What may stand between the explorer and a channel. It keeps nothing of its own from call to call but `notes`.
class Between
{
  public:
    virtual ~Between() = default;
    /// @brief The channel that is driven in place of `inner`; it lives as long as this object.
    virtual Channel& Around(Channel& inner) = 0;
    /// @brief Where it remembers something; part of the state.
    virtual Region Notes() = 0;
};

/// What one letter came to.
struct Answer
{
    bool is_possible{true};    ///< False: a frame with a stamp before the frame before it.
    std::string refused{};     ///< What does not hold, by name; empty: all holds.
    std::uint64_t visible{0U}; ///< Digest of what both channels show.
};

/// All but the bytes of the channels.
struct Course
{
    third_voice::Consumer model{};
    Witness witness{};
    SrdoState state{SrdoState::kOff};
    SrdoCause first_cause{SrdoCause::kNone};
    std::uint32_t cycles{0U};
    std::int64_t called_us{0};  ///< The last call.
    std::uint32_t frame_us{0U}; ///< The last frame, behind it.
    std::uint32_t told{0U};     ///< Causes of the model, as bits, since the last call.
    std::int64_t entered_us{0}; ///< OPERATIONAL.
    bool is_left{true};         ///< Not OPERATIONAL, as the last call said.
    bool has_gfc{false};
};

/// What only goes up.
struct Counted
{
    std::uint32_t cycles;
    std::uint32_t ordinal;
    std::uint32_t errors;
    std::uint32_t active_us; ///< At the last call, since OPERATIONAL was entered.
};

/// A state as a whole: what can be put back.
struct Snapshot
{
    std::vector<std::uint8_t> bytes;
    Course course;
};

/// One consumer of one byte in both channels that ship, in one memory with their two objects, beside the model and the
/// witness; driven by the contract, with the comparison that the kernel makes behind each call.
class World
{
  public:
    /// @brief `around_a` and `around_b` may be null.
    World(const ConsumerSetup& setup, Between* around_a, Between* around_b);
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// @brief Power-on, at this value of the counter.
    void Start(std::uint32_t base_us);
    [[nodiscard]] Answer Apply(const Letter& letter);
    [[nodiscard]] Snapshot Save() const;
    void Restore(const Snapshot& snapshot);
    [[nodiscard]] const Course& Now() const
    {
        return course_;
    }
    [[nodiscard]] std::uint32_t NowUs() const;

    [[nodiscard]] Counted Counts() const;
    /// @brief What the normal and the inverse object hold.
    [[nodiscard]] std::uint32_t Objects() const;
    /// @brief Where in the bytes of a snapshot the budgets of channel B are, which run below zero when they are over.
    [[nodiscard]] std::vector<std::size_t> Budgets() const;
    [[nodiscard]] std::vector<Region> Regions() const;

  private:
    void Configure(Channel& channel);
    void Frame(const Letter& letter);
    [[nodiscard]] std::string Call(const Letter& letter);
    void CallModel(const Letter& letter, bool is_late);
    [[nodiscard]] std::string CompareOutcomes(const CycleOutcome& a, const CycleOutcome& b) const;
    [[nodiscard]] std::string CompareChannels() const;
    [[nodiscard]] std::string CompareModel() const;
    [[nodiscard]] std::string Finish(bool is_released) const;
    [[nodiscard]] std::uint64_t Digest(bool is_call) const;

    ConsumerSetup setup_;
    SrdoSetup srdo_{};
    MappableObject objects_[2]{};
    DeviceConfig config_{};
    struct Variables
    {
        std::uint8_t normal;
        std::uint8_t inverse;
    };
    Variables variables_{};
    channel_a::StorageFor<1U, 2U> storage_a_{};
    channel_b::StorageFor<1U, 2U> storage_b_{};
    std::optional<channel_a::Channel> a_;
    std::optional<channel_b::Channel> b_;
    Between* around_a_;
    Between* around_b_;
    Channel* voice_a_{nullptr};
    Channel* voice_b_{nullptr};
    std::uint32_t base_us_{0U};

    Course course_{};
};

} // namespace counterpoint::proof

#endif
