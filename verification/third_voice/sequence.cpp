// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/sequence.hpp"

#include "verification/third_voice/buttons.hpp"
#include "verification/third_voice/device.hpp"
#include "verification/third_voice/dice.hpp"
#include "verification/third_voice/drawing.hpp"
#include "verification/third_voice/rig.hpp"
#include "verification/third_voice/talker.hpp"
#include "verification/third_voice/told.hpp"

#include <algorithm>
#include <deque>
#include <memory>
#include <sstream>
#include <vector>

namespace counterpoint::third_voice
{
namespace
{
constexpr Time kMs = 1000;
constexpr std::size_t kStoryLines = 90U;
constexpr std::uint32_t kCycles = 300U;
constexpr std::uint32_t kCyclesInLevel2 = 40U;

/// A frame of the device that is going to be on the bus.
struct Flight
{
    Sent frame;
    Time at{0};
};

std::optional<SrdoCause> AnyRefusal(Dice& dice)
{
    return dice.Chance(3U) ? std::optional{dice.Pick({SrdoCause::kTransmitQueue, SrdoCause::kBusOff})} : std::nullopt;
}

class Sequence
{
  public:
    Sequence(const std::uint64_t seed, const Flaw flaw, const Questions questions)
        : dice_(seed), flaw_(flaw), is_asked_(questions == Questions::kAsked)
    {
    }

    SequenceResult Run()
    {
        MakeDevice();
        const bool is_demanded = dice_.Chance(drawing_.is_dense ? 40U : 15U);
        const std::uint32_t demanded = is_demanded ? dice_.Below(kCycles) : kCycles; // The last phase of a sequence.
        Configure();
        for (std::uint32_t cycle = 0U; cycle < std::min(kCycles, demanded + kCyclesInLevel2) && GoesOn(); ++cycle)
        {
            if (cycle == demanded)
            {
                DemandSafeState();
            }
            const Time last = now_;
            const Time due = NextCall();
            Between(last, due);
            RunCycle(due);
            if (GoesOn() && dice_.Chance(3U))
            {
                Reconfigure();
            }
        }
        result_.story = "cycle " + std::to_string(drawing_.config.cycle_us) + " us, acknowledge window " +
                        std::to_string(drawing_.config.acknowledge_window_us) + " us, discrepancy time " +
                        std::to_string(drawing_.config.discrepancy_us) + " us\n";
        for (const std::string& line : story_)
        {
            result_.story += line + "\n";
        }
        return result_;
    }

  private:
    [[nodiscard]] bool GoesOn() const
    {
        return result_.is_equal && !result_.is_undecided;
    }

    /// Later than the cycle now and then. Drifting counters have calls in a row that keeps its phase to some
    /// microseconds, so that what falls due at one of them is due for one counter and not yet for the other.
    [[nodiscard]] Time NextCall()
    {
        const std::uint32_t tolerance = drawing_.config.cycle_tolerance_us;
        const bool is_late = drawing_.is_dense && dice_.Chance(50U);
        const Time late = is_late ? Time{dice_.Below(tolerance - tolerance / 100U)} : 0; // By either counter.
        if (pace_ == Pace::kAlike || dice_.Chance(1U))
        {
            row_ = now_ + drawing_.config.cycle_us;
            const std::optional<Time> edge = model_->SilenceEndsBetween(row_, row_ + tolerance - 1);
            if (edge && pace_ == Pace::kAlike && dice_.Chance(30U))
            {
                row_ = *edge + (dice_.Chance(50U) ? 1 : 0);
                return row_;
            }
            row_ += is_late ? late : (dice_.Chance(10U) ? Time{dice_.Below(tolerance + 1U)} : 0);
            return row_;
        }
        row_ += drawing_.config.cycle_us;
        return std::max(row_, now_) + (is_late             ? late
                                       : dice_.Chance(30U) ? Time{1U + dice_.Below(dice_.Pick({1U, 3U, 40U}))}
                                                           : 0);
    }

    void MakeDevice()
    {
        pace_ = (!is_asked_ && dice_.Chance(30U)) ? Pace::kDrifting : Pace::kAlike;
        speaks_between_ = dice_.Chance(40U);
        drawing_ = Draw(dice_, is_asked_, pace_);
        drawing_.config.srdos = drawing_.setups.data();
        buttons_.Restart(drawing_.config.srdo_count, drawing_.window_cycles);
        const Drift drift = (pace_ == Pace::kDrifting) ? AnyDrift(dice_, drawing_) : Drift{};
        const Counters counters{dice_.Chance(50U) ? 0xFFFE0000U : 1000U, dice_.Chance(50U) ? 0xFFFD0000U : 77U, drift};
        rig_ = std::make_unique<Rig>(drawing_.config, drawing_.objects, counters);
        model_ = std::make_unique<Device>(drawing_.config, flaw_, drift);
        Require(rig_->Start() == StartResult::kStarted, "Start is refused", "it started");
        std::vector<SrdoObjects> objects;
        for (std::uint8_t number = 1U; number <= drawing_.config.srdo_count; ++number)
        {
            objects.push_back(ReadObjects(*rig_, number));
        }
        model_->Start(objects, rig_->Read({0x1300U, 0U}));
    }

    [[nodiscard]] const SrdoObjects& ObjectsOf(const std::uint8_t number) const
    {
        return model_->Configured().Objects(number - 1U);
    }

    void Tell(const std::string& line)
    {
        story_.push_back(std::to_string(now_) + " " + line);
        if (story_.size() > kStoryLines)
        {
            story_.pop_front();
        }
    }

    template <typename Found, typename Expected>
    void Compare(const std::string& what, const Found& found, const Expected& expected)
    {
        if (found != expected && result_.is_equal)
        {
            std::ostringstream text;
            text << std::hex << "at " << std::dec << now_ << " us " << what << ": 0x" << std::hex << +found
                 << ", expected 0x" << +expected;
            result_.is_equal = false;
            result_.difference = text.str();
        }
    }

    void Require(const bool holds, const std::string& what, const std::string& expected)
    {
        if (!holds && result_.is_equal)
        {
            result_.is_equal = false;
            result_.difference = "at " + std::to_string(now_) + " us " + what + ", expected " + expected;
        }
    }

    void Write(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value, const std::size_t size)
    {
        if (!GoesOn())
        {
            return;
        }
        const AbortCode found = rig_->Write({index, sub}, value, size);
        const AbortCode expected = model_->Write({index, sub}, value, size);
        std::ostringstream text;
        text << std::hex << "write " << index << ":" << +sub << " = " << value << " -> "
             << static_cast<std::uint32_t>(expected);
        Tell(text.str());
        result_.refusals += (expected != AbortCode::kNone) ? 1U : 0U;
        Compare(text.str(), static_cast<std::uint32_t>(found), static_cast<std::uint32_t>(expected));
        CompareState("write");
    }

    void Configure()
    {
        Write(0x1300U, 0U, dice_.Below(2U), 1U);
        for (std::uint8_t number = 1U; number <= drawing_.config.srdo_count && result_.is_equal; ++number)
        {
            ConfigureSrdo(number, AnyDirection());
        }
        Sign();
        SetNmt(NmtState::kPreOperational);
        SetNmt(NmtState::kOperational);
    }

    std::uint32_t AnyDirection()
    {
        const std::uint32_t consumers = (pace_ == Pace::kDrifting) ? 0U : 70U;
        return dice_.Chance(consumers) ? kDirectionConsumer : kDirectionProducer;
    }

    void ConfigureSrdo(const std::uint8_t number, const std::uint32_t direction)
    {
        const auto communication = static_cast<std::uint16_t>(0x1300U + number);
        const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
        Write(communication, 1U, 0U, 1U);
        Write(mapping, 0U, 0U, 1U);
        const std::uint32_t sct = drawing_.scts[number - 1U]; // The window of a told cause goes with it.
        Write(communication, 2U, sct, 2U);
        Write(communication, 3U, (sct > 3U) ? 2U + dice_.Below(sct - 3U) : 1U, 1U);
        Write(communication, 5U, 0xFFU + 2U * number, 4U);
        Write(communication, 6U, 0x100U + 2U * number, 4U);
        const bool is_strange = dice_.Chance(2U);
        const std::uint16_t base = ((direction == kDirectionProducer) != is_strange) ? 0x2000U : 0x2200U;
        // Mostly, SRDO n maps the objects of sub-indices that no other maps.
        const std::uint32_t owner = dice_.Chance(8U) ? (1U + dice_.Below(drawing_.config.srdo_count)) : number;
        const std::uint8_t first = static_cast<std::uint8_t>(2U * owner - 1U);
        const std::uint32_t pairs = 1U + dice_.Below(2U);
        for (std::uint8_t pair = 0U; pair < pairs; ++pair)
        {
            const auto sub = static_cast<std::uint8_t>(first + pair);
            const std::uint32_t bits = (sub <= 2U) ? 8U : ((sub <= 4U) ? 16U : 32U);
            const std::uint32_t low = (std::uint32_t{sub} << 8U) | bits;
            Write(mapping, static_cast<std::uint8_t>(1U + 2U * pair), (std::uint32_t{base} << 16U) | low, 4U);
            Write(mapping, static_cast<std::uint8_t>(2U + 2U * pair), ((std::uint32_t{base} + 0x100U) << 16U) | low,
                  4U);
        }
        Write(mapping, 0U, 2U * pairs, 1U);
        Write(communication, 1U, direction, 1U);
    }

    void Sign()
    {
        for (std::uint8_t number = 1U; number <= drawing_.config.srdo_count; ++number)
        {
            Write(0x13FFU, number, SignatureOf(ObjectsOf(number)) ^ (dice_.Chance(2U) ? 1U : 0U), 2U);
        }
        Write(0x13FEU, 0U, 0xA5U, 1U);
        if (GoesOn() && !model_->Configured().IsValid())
        {
            const std::optional<std::size_t> faulty = model_->Configured().FirstFaulty();
            const std::uint32_t expected = faulty ? 0x1300U + drawing_.setups[*faulty].number : 0U;
            Compare("first faulty SRDO", rig_->Facade().CheckConfiguration().index.value, expected);
            CompareState("check");
        }
    }

    void SetNmt(const NmtState state)
    {
        if (!GoesOn())
        {
            return;
        }
        std::ostringstream text;
        text << std::hex << "NMT " << static_cast<unsigned>(state);
        Tell(text.str());
        rig_->SetNmt(state, now_);
        model_->SetNmt(state);
        nmt_ = state;
        has_commanded_ = true;
        talkers_.clear();
        flights_.clear();
        if (state == NmtState::kOperational)
        {
            for (std::uint8_t number = 1U; number <= drawing_.config.srdo_count; ++number)
            {
                if (ObjectsOf(number).direction == kDirectionConsumer)
                {
                    talkers_.push_back({number, now_ + 1 + dice_.Below(20U * 1000U), now_, drawing_.is_dense});
                }
            }
        }
        CompareState("NMT");
    }

    /// Leaves OPERATIONAL, changes something, comes back; with a cycle in between or without.
    void Reconfigure()
    {
        if (model_->IsInLevel2())
        {
            EnterAgain();
            return;
        }
        SetNmt(dice_.Chance(50U) ? NmtState::kPreOperational : NmtState::kStopped);
        if (dice_.Chance(40U))
        {
            RunOtherCycle();
        }
        if (nmt_ == NmtState::kStopped)
        {
            SetNmt(NmtState::kPreOperational);
        }
        if (dice_.Chance(60U) && GoesOn())
        {
            const auto number = static_cast<std::uint8_t>(1U + dice_.Below(drawing_.config.srdo_count));
            ConfigureSrdo(number, dice_.Chance(10U) ? 0U : AnyDirection());
            if (dice_.Chance(50U))
            {
                RunOtherCycle();
            }
            Sign();
        }
        if (dice_.Chance(30U))
        {
            RunOtherCycle();
        }
        SetNmt(NmtState::kOperational);
    }

    /// Everything on the bus until `to`, in order.
    void Between(const Time from, const Time to)
    {
        while (result_.is_equal)
        {
            const auto speaks =
                std::min_element(talkers_.begin(), talkers_.end(),
                                 [](const Talker& left, const Talker& right) { return left.next < right.next; });
            const auto flies =
                std::min_element(flights_.begin(), flights_.end(),
                                 [](const Flight& left, const Flight& right) { return left.at < right.at; });
            const bool can_speak =
                speaks != talkers_.end() && speaks->next <= to && (speaks_between_ || !has_commanded_);
            const bool can_fly = flies != flights_.end() && flies->at <= to;
            if (can_fly && (!can_speak || flies->at <= speaks->next))
            {
                now_ = std::max(now_, flies->at);
                const Sent frame = flies->frame;
                flights_.erase(flies);
                Confirm(frame);
            }
            else if (can_speak)
            {
                now_ = std::max(now_, std::max(speaks->next, from));
                Speak(*speaks);
            }
            else
            {
                return;
            }
        }
    }

    /// What left the device comes to the bus, as a rule soon and as it was.
    void Launch(const Sent& frame)
    {
        const std::uint8_t number = static_cast<std::uint8_t>((frame.identifier - 0xFFU) / 2U);
        const Time srvt = kMs * ObjectsOf(number).srvt_ms;
        const Time after = dice_.Chance(80U)
                               ? 1 + Time{dice_.Below(static_cast<std::uint32_t>(std::min<Time>(srvt, 3 * kMs)))}
                               : dice_.Pick({srvt - 1, srvt, srvt + 1, 100 * srvt});
        Flight flight{frame, now_ + ((pace_ == Pace::kDrifting) ? AfterOf(srvt) : after)};
        if (dice_.Chance(2U))
        {
            flight.frame.data.front() ^= static_cast<std::uint8_t>(1U << dice_.Below(8U));
        }
        flights_.push_back(flight);
    }

    /// Up to two cycles, often just before or behind a call; the two limits now and then, by either counter.
    [[nodiscard]] Time AfterOf(const Time srvt)
    {
        const std::uint32_t cycle = drawing_.config.cycle_us;
        if (dice_.Chance(8U))
        {
            return dice_.Pick({srvt - 1, srvt, srvt + 1, 100 * srvt});
        }
        if (dice_.Chance(30U))
        {
            return std::max<Time>(1, row_ + Time{cycle * dice_.Below(3U)} + Time{dice_.Below(5U)} - 2 - now_);
        }
        return 1 + Time{dice_.Below(2U * cycle)};
    }

    void Confirm(const Sent& frame)
    {
        Tell("confirmed " + std::to_string(frame.identifier));
        Refuse(AnyRefusal(dice_));
        rig_->OnConfirm(frame, now_);
        model_->OnConfirm(frame, now_);
        CompareTold("confirmation");
    }

    /// What the controller does with the next frame.
    void Refuse(const std::optional<SrdoCause> cause)
    {
        rig_->RefuseNext(cause);
        model_->RefuseNext(cause);
        has_refused_ = cause.has_value();
    }

    /// The application leaves new pairs, mostly inverse, and asks for their transmission now and then.
    void Apply()
    {
        for (const MappableObject& object : drawing_.objects)
        {
            if (object.access == MapAccess::kProducer && object.index == 0x2000U)
            {
                const std::uint64_t all = (std::uint64_t{1U} << object.length_bits) - 1U;
                const std::uint64_t normal = dice_.Next() & all;
                const std::uint64_t wrong =
                    dice_.Chance(1U) ? (std::uint64_t{1U} << dice_.Below(object.length_bits)) : 0U;
                for (const bool is_inverse : {false, true})
                {
                    const Address address{static_cast<std::uint16_t>(object.index + (is_inverse ? 0x100U : 0U)),
                                          object.sub};
                    const std::uint64_t value = is_inverse ? (~normal & all) ^ wrong : normal;
                    rig_->Put(address, value);
                    model_->Put(address, value);
                }
            }
        }
        for (std::uint8_t number = 1U; number <= drawing_.config.srdo_count; ++number)
        {
            const bool is_near =
                pace_ == Pace::kDrifting && model_->NextRefresh(number) - now_ < 2 * drawing_.config.cycle_us;
            if (model_->StateOf(number) == SrdoState::kProducer && dice_.Chance(is_near ? 50U : 8U))
            {
                static_cast<void>(
                    rig_->Facade().Send(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)}));
                model_->Send(number);
                Tell("send " + std::to_string(number));
            }
        }
    }

    /// As a rule with pairs on their way and released ones; often with OPERATIONAL left, and entered again behind it.
    void DemandSafeState()
    {
        Tell("safe state demanded");
        rig_->Facade().DemandSafeState();
        model_->DemandSafeState();
        CompareState("demand");
        if (dice_.Chance(50U))
        {
            EnterAgain();
        }
    }

    void EnterAgain()
    {
        SetNmt(NmtState::kPreOperational);
        if (dice_.Chance(70U))
        {
            RunOtherCycle();
        }
        SetNmt(NmtState::kOperational);
    }

    /// Often two in a row, and behind a start before the first cycle.
    void SendGfc()
    {
        const bool is_first = result_.steps < 2U;
        if (nmt_ != NmtState::kOperational || !model_->Configured().IsValid() || !dice_.Chance(is_first ? 20U : 3U))
        {
            return;
        }
        Refuse(std::nullopt);
        const bool is_sent = rig_->Facade().SendGfc() == Result::kSuccessful;
        Tell("send GFC");
        Compare("sent GFC", is_sent, model_->SendGfc());
    }

    void Speak(Talker& talker)
    {
        const CanFrame frame = talker.Speak(ObjectsOf(talker.number), dice_);
        Tell("frame " + std::to_string(frame.identifier) + (talker.is_wrong ? " wrong" : "") + " length " +
             std::to_string(frame.length_bytes) + ((frame.kind == FrameKind::kData) ? "" : " no data frame"));
        rig_->OnFrame(frame, now_);
        model_->OnFrame(frame, now_);
        talker.Plan(ObjectsOf(talker.number), now_, dice_);
    }

    void CompareTold(const std::string& behind)
    {
        const Seen expected = model_->TakeSeen();
        const Seen found = rig_->TakeSeen();
        result_.releases += static_cast<std::uint32_t>(expected.events.size());
        result_.faults += static_cast<std::uint32_t>(expected.signals.size());
        const Sparing sparing{!is_asked_ && speaks_between_, !is_asked_ && !model_->Configured().IsValid()};
        const std::string right = TextOf(expected, sparing);
        if (!right.empty())
        {
            Tell("expected:" + right);
        }
        const std::string told = TextOf(found, sparing);
        Require(told == right, "told behind " + behind + ":" + told, right);
        for (const Sent& frame : expected.frames)
        {
            const bool is_srdo = !frame.data.empty();
            if (is_srdo && result_.is_equal && (!has_refused_ || &frame != &expected.frames.front()))
            {
                Launch(frame);
            }
        }
    }

    /// Out of the row.
    void RunOtherCycle()
    {
        row_ = now_ + drawing_.config.cycle_us;
        RunCycle(row_);
    }

    void RunCycle(const Time at)
    {
        if (!GoesOn())
        {
            return;
        }
        now_ = at;
        const Readings readings = buttons_.Next(dice_);
        Apply();
        SendGfc();
        Refuse(AnyRefusal(dice_));
        std::ostringstream text;
        text << "cycle, acknowledge " << readings.a << " " << readings.b;
        Tell(text.str());
        rig_->Cycle(now_, readings.a, readings.b);
        model_->Cycle(now_, readings.a, readings.b);
        ++result_.steps;
        if (model_->IsOpen() && !is_asked_)
        {
            result_.is_undecided = true;
            return;
        }
        Compare("device fault", static_cast<unsigned>(rig_->Facade().DeviceState().fault),
                static_cast<unsigned>(model_->IsInLevel2() ? DeviceFault::kApplication : DeviceFault::kNone));
        CompareState("cycle");
        Compare("open outputs", rig_->Open(now_), model_->Open());
        CompareTold("cycle");
        has_commanded_ = false;
    }

    void CompareState(const std::string& behind)
    {
        for (const MappableObject& object : drawing_.objects)
        {
            const std::uint64_t found = rig_->Variable({object.index, object.sub});
            const std::uint64_t expected = model_->Variable({object.index, object.sub});
            if (found != expected)
            {
                std::ostringstream name;
                name << std::hex << "object " << object.index << ":" << +object.sub << " behind " << behind;
                Compare(name.str(), found, expected);
            }
        }
        const bool is_asked = behind == "cycle" || model_->IsInLevel2();
        for (std::uint8_t number = 1U; is_asked && number <= drawing_.config.srdo_count; ++number)
        {
            const SrdoState found = rig_->StateOf(number);
            if (model_->IsInLevel2())
            {
                Require(found != SrdoState::kReleased, "SRDO " + std::to_string(number) + " is released",
                        "not in level 2");
                continue;
            }
            const SrdoState expected = model_->StateOf(number);
            if (found != expected)
            {
                Compare("state of SRDO " + std::to_string(number) + " behind " + behind, static_cast<unsigned>(found),
                        static_cast<unsigned>(expected));
            }
        }
        Compare("13FEh behind " + behind, rig_->Read({0x13FEU, 0U}) == 0xA5U, model_->Configured().IsValid());
    }

    Dice dice_;
    Flaw flaw_;
    Drawing drawing_{};
    std::unique_ptr<Rig> rig_;
    std::unique_ptr<Device> model_;
    std::vector<Talker> talkers_;
    std::vector<Flight> flights_;
    Buttons buttons_;
    bool has_refused_{false};
    bool has_commanded_{false};  ///< NMT, since the last cycle.
    bool speaks_between_{false}; ///< Frames between such a command and the cycle that shows it, too.
    bool is_asked_{false};
    Pace pace_{Pace::kAlike};
    Time row_{0}; ///< Of the last call that came in the row.
    NmtState nmt_{NmtState::kInitialising};
    Time now_{5000};
    SequenceResult result_{};
    std::deque<std::string> story_;
};
} // namespace

SequenceResult RunSequence(const std::uint64_t seed, const Flaw flaw, const Questions questions)
{
    return Sequence(seed, flaw, questions).Run();
}
} // namespace counterpoint::third_voice
