// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/third_voice/sequence.hpp"

#include "verification/third_voice/device.hpp"
#include "verification/third_voice/rig.hpp"

#include <algorithm>
#include <deque>
#include <initializer_list>
#include <memory>
#include <sstream>
#include <vector>

namespace counterpoint::third_voice
{
namespace
{
constexpr Time kMs = 1000;
constexpr std::size_t kStoryLines = 40U;
constexpr std::uint32_t kCycles = 300U;

class Dice
{
  public:
    explicit Dice(const std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U + 0x1234567U)
    {
    }
    std::uint64_t Next()
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return state_;
    }
    /// @brief From 0 to `count` - 1.
    std::uint32_t Below(const std::uint32_t count)
    {
        return static_cast<std::uint32_t>((Next() >> 20U) % count);
    }
    bool Chance(const std::uint32_t percent)
    {
        return Below(100U) < percent;
    }
    template <typename Value> Value Pick(std::initializer_list<Value> values)
    {
        return *(values.begin() + Below(static_cast<std::uint32_t>(values.size())));
    }

  private:
    std::uint64_t state_;
};

/// Somebody who sends the pairs of one SRDO, mostly well.
struct Talker
{
    std::uint8_t number{0U};
    Time next{0};
    bool is_inverse{false};
    std::uint64_t data{0U};
    Time normal_at{0};
};

class Sequence
{
  public:
    Sequence(const std::uint64_t seed, const Flaw flaw) : dice_(seed), flaw_(flaw)
    {
    }

    SequenceResult Run()
    {
        MakeDevice();
        Configure();
        for (std::uint32_t cycle = 0U; cycle < kCycles && result_.is_equal; ++cycle)
        {
            const Time last = now_;
            const Time due =
                last + config_.cycle_us + (dice_.Chance(10U) ? Time{dice_.Below(config_.cycle_tolerance_us + 1U)} : 0);
            Between(last, due);
            if (result_.is_equal)
            {
                RunCycle(due);
            }
            if (result_.is_equal && dice_.Chance(3U))
            {
                Reconfigure();
            }
        }
        for (const std::string& line : story_)
        {
            result_.story += line + "\n";
        }
        return result_;
    }

  private:
    void MakeDevice()
    {
        count_ = static_cast<std::uint8_t>(1U + dice_.Below(3U));
        for (std::uint8_t number = 1U; number <= count_; ++number)
        {
            SrdoSetup setup{};
            setup.number = number;
            setup.policy = ReleasePolicy::kAutomatic;
            setup.form = ProducerForm::kProviderCalled;
            setup.detection = dice_.Chance(50U) ? SrvtDetection::kLate : SrvtDetection::kEarly;
            setup.safe_value = {0x5AU, 0U};
            setups_.push_back(setup);
        }
        for (const MapAccess access : {MapAccess::kProducer, MapAccess::kConsumer})
        {
            const auto base = static_cast<std::uint16_t>((access == MapAccess::kProducer) ? 0x2000U : 0x2200U);
            for (const std::uint16_t side : {std::uint16_t{0U}, std::uint16_t{0x100U}})
            {
                for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
                {
                    const std::uint8_t bits = (sub <= 2U) ? 8U : ((sub <= 4U) ? 16U : 32U);
                    objects_.push_back({static_cast<std::uint16_t>(base + side), sub, bits, access, nullptr});
                }
            }
        }
        std::sort(objects_.begin(), objects_.end(), [](const MappableObject& left, const MappableObject& right)
                  { return left.index != right.index ? left.index < right.index : left.sub < right.sub; });
        config_.srdos = setups_.data();
        config_.srdo_count = count_;
        config_.node_id = static_cast<std::uint8_t>(1U + dice_.Below(127U));
        config_.granularity_bits = 8U;
        config_.map_entries = Rig::kEntries;
        config_.dummies = DummyMapping::kRefused;
        config_.gaps = NumberGaps::kRefused;
        config_.gfc = GfcUse::kPresent;
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kFirst;
        config_.cycle_us = dice_.Pick({1000U, 2000U, 5000U});
        config_.cycle_tolerance_us = config_.cycle_us / 2U;
        config_.discrepancy_us = 20U * config_.cycle_us;
        config_.acknowledge_window_us = 40U * config_.cycle_us;
        config_.diagnostic_interval_us = 40U * config_.cycle_us;
        config_.test_interval_us = 20U * config_.cycle_us;
        config_.clock_tolerance_us = 200U;
        config_.clock_interval_us = 100000U;
        config_.output_time_us = 1000U;
        const Counters counters{dice_.Chance(50U) ? 0xFFFE0000U : 1000U, dice_.Chance(50U) ? 0xFFFD0000U : 77U};
        rig_ = std::make_unique<Rig>(config_, objects_, counters);
        model_ = std::make_unique<Device>(config_, flaw_);
        Require(rig_->Start() == StartResult::kStarted, "Start is refused", "it started");
        for (std::uint8_t number = 1U; number <= count_; ++number)
        {
            model_->SetInitial(number, ReadObjects(number));
        }
        model_->SetGfcParameter(rig_->Read({0x1300U, 0U}));
        model_->Start();
    }

    SrdoObjects ReadObjects(const std::uint8_t number)
    {
        const auto communication = static_cast<std::uint16_t>(0x1300U + number);
        const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
        SrdoObjects objects;
        objects.direction = rig_->Read({communication, 1U});
        objects.sct_ms = rig_->Read({communication, 2U});
        objects.srvt_ms = rig_->Read({communication, 3U});
        objects.transmission_type = rig_->Read({communication, 4U});
        objects.cob_id_1 = rig_->Read({communication, 5U});
        objects.cob_id_2 = rig_->Read({communication, 6U});
        objects.count = rig_->Read({mapping, 0U});
        for (std::uint8_t sub = 1U; sub <= Rig::kEntries; ++sub)
        {
            objects.entries.push_back(rig_->Read({mapping, sub}));
        }
        objects.signature = rig_->Read({0x13FFU, number});
        return objects;
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
        for (std::uint8_t number = 1U; number <= count_ && result_.is_equal; ++number)
        {
            ConfigureSrdo(number, 2U);
        }
        Sign();
        SetNmt(NmtState::kPreOperational);
        SetNmt(NmtState::kOperational);
    }

    void ConfigureSrdo(const std::uint8_t number, const std::uint32_t direction)
    {
        const auto communication = static_cast<std::uint16_t>(0x1300U + number);
        const auto mapping = static_cast<std::uint16_t>(0x1380U + number);
        Write(communication, 1U, 0U, 1U);
        Write(mapping, 0U, 0U, 1U);
        const std::uint32_t sct = 10U + dice_.Below(40U);
        Write(communication, 2U, sct, 2U);
        Write(communication, 3U, 2U + dice_.Below(sct - 3U), 1U);
        Write(communication, 5U, 0xFFU + 2U * number, 4U);
        Write(communication, 6U, 0x100U + 2U * number, 4U);
        const std::uint16_t base = (direction == 1U) ? 0x2000U : 0x2200U;
        // SRDO n maps the objects of sub-indices that no other maps.
        const std::uint8_t first = static_cast<std::uint8_t>(2U * number - 1U);
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
        for (std::uint8_t number = 1U; number <= count_; ++number)
        {
            Write(0x13FFU, number, SignatureOf(model_->Objects(number)) ^ (dice_.Chance(2U) ? 1U : 0U), 2U);
        }
        Write(0x13FEU, 0U, 0xA5U, 1U);
    }

    void SetNmt(const NmtState state)
    {
        if (!result_.is_equal)
        {
            return;
        }
        std::ostringstream text;
        text << std::hex << "NMT " << static_cast<unsigned>(state);
        Tell(text.str());
        rig_->SetNmt(state, now_);
        model_->SetNmt(state);
        nmt_ = state;
        talkers_.clear();
        if (state == NmtState::kOperational)
        {
            for (std::uint8_t number = 1U; number <= count_; ++number)
            {
                if (model_->Objects(number).direction == kDirectionConsumer)
                {
                    talkers_.push_back({number, now_ + 1 + dice_.Below(20U * 1000U), false, 0U, now_});
                }
            }
        }
        CompareState("NMT");
    }

    /// Leaves OPERATIONAL, changes something, comes back; with a cycle in between or without.
    void Reconfigure()
    {
        SetNmt(dice_.Chance(50U) ? NmtState::kPreOperational : NmtState::kStopped);
        if (dice_.Chance(40U))
        {
            RunCycle(now_ + config_.cycle_us);
        }
        if (nmt_ == NmtState::kStopped)
        {
            SetNmt(NmtState::kPreOperational);
        }
        if (dice_.Chance(60U) && result_.is_equal)
        {
            const auto number = static_cast<std::uint8_t>(1U + dice_.Below(count_));
            ConfigureSrdo(number, dice_.Chance(10U) ? 0U : 2U);
            if (dice_.Chance(50U))
            {
                RunCycle(now_ + config_.cycle_us);
            }
            Sign();
        }
        if (dice_.Chance(30U))
        {
            RunCycle(now_ + config_.cycle_us);
        }
        SetNmt(NmtState::kOperational);
    }

    void Between(const Time from, const Time to)
    {
        while (result_.is_equal)
        {
            Talker* first = nullptr;
            for (Talker& talker : talkers_)
            {
                first = (talker.next <= to && (first == nullptr || talker.next < first->next)) ? &talker : first;
            }
            if (first != nullptr)
            {
                now_ = std::max(now_, std::max(first->next, from));
                Speak(*first);
            }
            else
            {
                return;
            }
        }
    }

    void Speak(Talker& talker)
    {
        const SrdoObjects& objects = model_->Objects(talker.number);
        std::uint32_t bits = 0U;
        for (std::uint32_t entry = 0U; entry < objects.count; entry += 2U)
        {
            bits += objects.entries[entry] & 0xFFU;
        }
        std::size_t length = bits / 8U;
        const Time sct = kMs * objects.sct_ms;
        const Time srvt = kMs * objects.srvt_ms;
        if (!talker.is_inverse)
        {
            talker.data = dice_.Next();
        }
        std::uint64_t word = talker.is_inverse ? ~talker.data : talker.data;
        const bool is_wrong = dice_.Chance(3U);
        length = (is_wrong && dice_.Chance(50U)) ? (length + 1U) % 9U : length;
        word ^= is_wrong ? (std::uint64_t{1U} << dice_.Below(std::max(bits, 1U))) : 0U;
        CanFrame frame{talker.is_inverse ? objects.cob_id_2 : objects.cob_id_1,
                       FrameKind::kData,
                       CanPortId::kFirst,
                       static_cast<std::uint8_t>(length),
                       {}};
        if (dice_.Chance(1U))
        {
            frame.kind = dice_.Pick({FrameKind::kRemote, FrameKind::kExtended, FrameKind::kFlexibleDataRate});
        }
        if (dice_.Chance(1U))
        {
            frame.identifier = 1U;
            frame.length_bytes = static_cast<std::uint8_t>(dice_.Chance(80U) ? 0U : 1U);
        }
        for (std::size_t byte = 0U; byte < frame.length_bytes; ++byte)
        {
            frame.data[byte] = static_cast<std::uint8_t>(word >> (8U * byte));
        }
        Tell("frame " + std::to_string(frame.identifier) + (is_wrong ? " wrong" : "") + " length " +
             std::to_string(frame.length_bytes) + ((frame.kind == FrameKind::kData) ? "" : " no data frame"));
        rig_->OnFrame(frame, now_);
        model_->OnFrame(frame, now_);
        const bool slips = dice_.Chance(6U); // Leaves the alternation.
        if (!talker.is_inverse)
        {
            talker.normal_at = now_;
            talker.next = now_ + (dice_.Chance(75U)
                                      ? 1 + Time{dice_.Below(static_cast<std::uint32_t>(srvt))}
                                      : dice_.Pick({srvt - 1, srvt, srvt + 1, srvt + 1 + Time{dice_.Below(5000U)}}));
        }
        else
        {
            talker.next = std::max(
                now_ + 1,
                talker.normal_at + (dice_.Chance(75U) ? sct / 4 + Time{dice_.Below(static_cast<std::uint32_t>(sct / 2))}
                                                      : dice_.Pick({sct - 1, sct, sct + 1, 2 * sct})));
        }
        talker.is_inverse = (talker.is_inverse == slips);
    }

    /// What both told since the last look; the model's stands in the story.
    void TakeTold()
    {
        static_cast<void>(rig_->TakeSeen());
        const Seen expected = model_->TakeSeen();
        const auto text_of = [](const Seen& seen)
        {
            std::ostringstream text;
            for (const auto& [number, cause] : seen.signals)
            {
                text << " cause " << static_cast<unsigned>(cause) << " of " << +number;
            }
            for (const std::uint8_t number : seen.events)
            {
                text << " event of " << +number;
            }
            text << (seen.gfcs > 0 ? " GFC" : "") << (seen.is_configuration_invalid ? " configuration invalid" : "");
            return text.str();
        };
        const std::string right = text_of(expected);
        if (!right.empty())
        {
            Tell("expected:" + right);
        }
        result_.releases += static_cast<std::uint32_t>(expected.events.size());
        result_.faults += static_cast<std::uint32_t>(expected.signals.size());
    }

    void RunCycle(const Time at)
    {
        if (!result_.is_equal)
        {
            return;
        }
        now_ = at;
        if (dice_.Chance(8U))
        {
            level_ = dice_.Chance(50U) ? ~SrdoMask{0U} : SrdoMask{0U};
        }
        levels_.push_front(level_);
        levels_.resize(5U, 0U);
        skew_ = dice_.Chance(2U) ? dice_.Below(4U) : skew_;
        const SrdoMask a = levels_[0];
        const SrdoMask b = levels_[skew_];
        Tell("cycle, acknowledge " + std::to_string(a & 1U) + std::to_string(b & 1U));
        rig_->Cycle(now_, a, b);
        model_->Cycle(now_, a, b);
        ++result_.steps;
        TakeTold();
        CompareState("cycle");
        Compare("open outputs", rig_->Open(now_), model_->Open());
        Compare("device fault", static_cast<unsigned>(rig_->Fault()), static_cast<unsigned>(DeviceFault::kNone));
    }

    void CompareState(const std::string& behind)
    {
        for (const MappableObject& object : objects_)
        {
            if (object.access == MapAccess::kConsumer)
            {
                std::ostringstream name;
                name << std::hex << "object " << object.index << ":" << +object.sub << " behind " << behind;
                Compare(name.str(), rig_->Variable({object.index, object.sub}),
                        model_->Variable({object.index, object.sub}));
            }
        }
        for (std::uint8_t number = 1U; behind == "cycle" && number <= count_; ++number)
        {
            Compare("state of SRDO " + std::to_string(number) + " behind " + behind,
                    static_cast<unsigned>(rig_->StateOf(number)), static_cast<unsigned>(model_->StateOf(number)));
        }
        Compare("13FEh behind " + behind, rig_->Read({0x13FEU, 0U}) == 0xA5U, model_->IsValid());
    }

    Dice dice_;
    Flaw flaw_;
    std::uint8_t count_{0U};
    std::vector<SrdoSetup> setups_;
    std::vector<MappableObject> objects_;
    DeviceConfig config_{};
    std::unique_ptr<Rig> rig_;
    std::unique_ptr<Device> model_;
    std::vector<Talker> talkers_;
    std::deque<SrdoMask> levels_;
    SrdoMask level_{0U};
    std::size_t skew_{0U};
    NmtState nmt_{NmtState::kInitialising};
    Time now_{5000};
    SequenceResult result_{};
    std::deque<std::string> story_;
};
} // namespace

SequenceResult RunSequence(const std::uint64_t seed, const Flaw flaw)
{
    return Sequence(seed, flaw).Run();
}
} // namespace counterpoint::third_voice
