// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP

#include "verification/campaign/managed/devices.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
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
    /// @brief Whether everybody has sent what it sends without fault, each frame at its time, and all that were due.
    [[nodiscard]] bool HasSentTheSame(Nanoseconds now) const;
    /// @brief Of the run without fault, when it ended.
    [[nodiscard]] Reference TakeReference();
    [[nodiscard]] const std::vector<RecordedFrame>& Frames() const noexcept
    {
        return frames_;
    }

    void OnReception(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions) override;
    void OnConfirmation(const host::FrameOnBus& sent, host::ReceptionList& receptions) override;

  private:
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
    void LookAtStates(Nanoseconds now);
    void LookAtMasters(Nanoseconds now);
    [[nodiscard]] std::size_t ActiveManagers(Nanoseconds now);
    void Tell(Wrong wrong);
    void TellIfAny(Wrong wrong);

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
    Devices devices_;
    Picture picture_{};
    std::map<Key, Reading> readings_{};
    std::vector<bool> runs_;               ///< By slave: OPERATIONAL when it was last looked at.
    std::vector<Nanoseconds> started_;     ///< By slave: the last start of a manager that came to an end.
    std::vector<Nanoseconds> other_since_; ///< By slave: runs with another configuration; -1: it does not.
    std::vector<Nanoseconds> reached_;     ///< By slave: the last frame of a manager that came to it.
    std::vector<Nanoseconds> heard_;       ///< By slave: its last frame to a manager; last: of a manager.
    Nanoseconds two_since_{-1};
    std::vector<Coming> coming_{};
    std::vector<RecordedFrame> frames_{};
    Reference made_{};
};
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_WATCH_HPP
