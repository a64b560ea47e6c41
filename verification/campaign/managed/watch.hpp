// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP

#include "verification/campaign/managed/memory.hpp"
#include "verification/campaign/managed/stage.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// What must never happen. Outcome::detail of what is silent. [SRS_CMG_072]
enum class Wrong : std::uint8_t
{
    kNothing = 0U,
    kStartOfAll = 1U,    ///< A start to node 0, with a safety slave in the network.
    kUnverified = 2U,    ///< A safety slave is started, and not all of it was read as expected.
    kConfiguration = 3U, ///< A safety slave is started that was changed before it was read.
    kIdentity = 4U,      ///< Another device is started.
    kRunsOn = 5U,        ///< A safety slave with another configuration runs longer than `stop_within`.
    kTwoMasters = 6U,
    kNoLeave = 7U,       ///< Output open outside of OPERATIONAL.
    kNoAcknowledge = 8U, ///< Open again without an acknowledge.
    kData = 9U,
    kIdentifier = 10U,
    kCrash = 11U, ///< The program ended.
};

/// Limits that documents name. Outcome::detail of what is listed. [SRS_CMG_073]
enum class Limit : std::uint8_t
{
    kNothing = 0U,
    kChangedBehind = 1U, ///< A safety configuration changed without a message, behind its last reading.
    kForeignStart = 2U,  ///< A slave runs by a command that no manager gave to it then.
    kApart = 4U,         ///< Slave and managers do not hear each other any more.
    kGfcBehind = 3U,     ///< 1300h was written behind the start, which is possible in every state.
    kOwnRule = 5U,       ///< A manager whose memory or clock is wrong broke a rule; every device is as it has to be.
    kOwnGate = 6U,       ///< Such a manager lets a slave run that holds itself back: 13FEh, or a device fault.
};

[[nodiscard]] const char* TextOf(Wrong wrong);
[[nodiscard]] const char* TextOf(Limit limit);

/// A frame of the run without fault.
struct RecordedFrame
{
    host::BusTime start{0};
    CanFrame frame{};
    host::NodeIndex sender{0U};
};

/// What is seen of a network each ms.
struct Picture
{
    std::vector<std::uint32_t> words;  ///< States and outputs of the devices, and what the managers know.
    std::vector<std::uint64_t> values; ///< Of each pair of a consumer.

    [[nodiscard]] bool operator==(const Picture& other) const
    {
        return words == other.words && values == other.values;
    }
};

/// The run without fault, which all others are compared with.
struct Reference
{
    std::vector<RecordedFrame> frames;
    std::vector<Picture> pictures; ///< Of each ms.
    std::map<host::NodeIndex, std::set<std::uint32_t>> identifiers;
    std::map<host::NodeIndex, std::vector<std::uint64_t>> hashes; ///< Of all frames of a sender up to each.
    std::map<std::string, std::uint32_t> told;                    ///< How often.
    std::set<std::pair<std::size_t, std::uint32_t>> automatic;    ///< Device and slot that open without an acknowledge.
    std::vector<ManagerMember> memory;                            ///< Of a plan that hits it.
};

/// A value that a manager got.
struct Answer
{
    bool is_right{false};
    Nanoseconds at{0};
};
/// What a manager has read of a slave, since it had to read anew and before.
struct Reading
{
    std::map<std::uint32_t, Answer> now;
    std::map<std::uint32_t, Answer> before;
    std::uint32_t asked{0U}; ///< The object that it waits for; 0: for none.
    Nanoseconds cleared{-1};
    Nanoseconds booted{-1}; ///< Its last boot-up message that came.
};

/// The judge. It sees frames as each receiver gets them, devices as they are, and managers by their controllers alone;
/// it shares nothing with the gate. [SRS_CMG_072]
class Watch final : public host::BusFault
{
  public:
    /// @brief Both outlive it. `reference` null: this is the run without fault.
    Watch(Stage& stage, const Plan& plan);

    /// @brief From now on this is no longer the run without fault.
    void Compare(const Reference& reference, Nanoseconds at)
    {
        reference_ = &reference;
        at_ = at;
    }
    /// @brief The fault changed an object of a device without a message.
    void NoteStored() noexcept
    {
        is_stored_ = true;
    }
    /// @brief Memory or clock of a manager is wrong from now on: what counts are the devices. [SRS_CMG_082]
    void NoteManagerHit() noexcept
    {
        is_manager_hit_ = true;
    }
    /// @brief The device has another serial number from now on.
    void NoteExchanged(const Slave& slave) noexcept
    {
        exchanged_ = &slave;
    }
    /// @brief A manager is switched on again: it knows nothing.
    void NoteNewManager(host::NodeIndex bus_node);
    /// @brief Each ms, when everything up to it was done.
    void Look(Nanoseconds now);

    [[nodiscard]] Wrong Found() const noexcept
    {
        return wrong_;
    }
    [[nodiscard]] Limit Listed() const noexcept
    {
        return limit_;
    }
    [[nodiscard]] Nanoseconds FoundAt() const noexcept
    {
        return found_at_;
    }
    [[nodiscard]] const Picture& Seen() const noexcept
    {
        return picture_;
    }
    /// @brief Whether anything that lasts is still to be judged.
    [[nodiscard]] bool IsWaiting() const noexcept;
    /// @brief Whether each sender has sent what it sends without fault, so far.
    [[nodiscard]] bool HasSentTheSame() const;
    /// @brief Of the run without fault, when it ended.
    [[nodiscard]] Reference TakeReference();
    [[nodiscard]] const std::vector<RecordedFrame>& Frames() const noexcept
    {
        return frames_;
    }

    void OnReception(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions) override;
    void OnConfirmation(const host::FrameOnBus& sent, host::ReceptionList& receptions) override;

  private:
    struct Output
    {
        bool is_open{false};
        Nanoseconds closed{0};
        Nanoseconds without_leave{0}; ///< Open outside of OPERATIONAL for so long.
    };
    /// A frame that comes to a manager later than its end.
    struct Coming
    {
        Nanoseconds at;
        CanFrame frame;
        host::NodeIndex receiver;
    };
    using Key = std::pair<host::NodeIndex, std::uint8_t>;

    void Meet(host::NodeIndex sender, host::NodeIndex receiver);
    void Take(const Coming& coming);
    void OnAnswer(const CanFrame& frame, const Slave& slave, Reading& reading, Nanoseconds now) const;
    void OnOwnFrame(const CanFrame& frame, host::NodeIndex sender);
    void OnCommand(const CanFrame& frame, host::NodeIndex sender);
    [[nodiscard]] Wrong WrongOfStart(const Slave& slave, host::NodeIndex sender);
    void TellOf(const Slave& slave, Wrong wrong);
    [[nodiscard]] bool IsHeldByItself(const Slave& slave);
    void LookAtOutputs(Nanoseconds now);
    void LookAtOutput(const Slave& slave, std::uint32_t slot, Nanoseconds now);
    void LookAtValues(Nanoseconds now);
    void LookAtStates(Nanoseconds now);
    void LookAtMasters(Nanoseconds now);
    void Draw();
    void Tell(Wrong wrong);

    Stage& stage_;
    const Plan& plan_;
    const Reference* reference_{nullptr};
    Nanoseconds at_{0};
    bool is_stored_{false};
    bool is_manager_hit_{false};
    const Slave* exchanged_{nullptr};
    Wrong wrong_{Wrong::kNothing};
    Limit limit_{Limit::kNothing};
    Nanoseconds found_at_{0};
    Picture picture_{};
    std::map<Key, Reading> readings_{};
    std::map<Key, Output> outputs_{};      ///< By index of the device and slot.
    std::vector<bool> runs_;               ///< By slave: OPERATIONAL when it was last looked at.
    std::vector<Nanoseconds> started_;     ///< By slave: the last start of a manager that came to an end.
    std::vector<Nanoseconds> other_since_; ///< By slave: runs with another configuration; -1: it does not.
    std::vector<Nanoseconds> reached_;     ///< By slave: the last frame of a manager that came to it.
    std::vector<Nanoseconds> heard_;       ///< By slave: its last frame to a manager; last: of a manager.
    Nanoseconds two_since_{-1};
    std::vector<Coming> coming_{};
    std::map<host::NodeIndex, std::uint64_t> hashes_{};
    std::map<host::NodeIndex, std::size_t> counts_{};
    std::vector<RecordedFrame> frames_{};
    Reference made_{};
    Nanoseconds phase_{0}; ///< Greatest time between two frames of a producer.
    Nanoseconds age_{0};   ///< Greatest age of data along the longest chain.
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP
