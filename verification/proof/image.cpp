// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/image.hpp"

#include <algorithm>
#include <cstring>

namespace counterpoint::proof
{

namespace
{
constexpr std::size_t kWordBytes = 4U;
constexpr std::size_t kHalfBytes = 2U;
constexpr std::uint32_t kOldestUs = kSctUs + kSrvtUs + (4U * kCycleUs); ///< Beyond all limits.
constexpr std::uint32_t kMovedUs = 0xE579BDF0U;
constexpr std::uint32_t kSteps = 6000U;

/// Mostly good pairs and calls on time, so that pairs are counted; now and then any letter.
std::vector<std::size_t> Script(const std::vector<Letter>& letters)
{
    const auto find = [&letters](const char* const text)
    {
        const auto found =
            std::find_if(letters.begin(), letters.end(), [text](const Letter& letter) { return letter.text == text; });
        return static_cast<std::size_t>(found - letters.begin());
    };
    const std::size_t good[] = {find("normal"), find("inverse"), find("call"), find("call, acknowledge")};
    std::vector<std::size_t> script;
    std::uint32_t drawn = 1U;
    for (std::uint32_t step = 0U; step < kSteps; ++step)
    {
        drawn = (drawn * 1664525U) + 1013904223U;
        const std::uint32_t turn = step % 3U;
        const bool is_high = ((step / 30U) % 2U) != 0U;
        const bool is_any = (step / 120U) % 2U != 0U;
        script.push_back(is_any ? ((drawn >> 16U) % letters.size()) : good[((turn == 2U) && is_high) ? 3U : turn]);
    }
    return script;
}

std::uint64_t Mixed(std::uint64_t digest, const std::uint64_t word, const std::uint64_t factor)
{
    digest = (digest ^ word) * factor;
    return digest ^ (digest >> 31U);
}

Key KeyOf(const std::vector<std::uint32_t>& words)
{
    Key key{0x243F6A8885A308D3U, 0x13198A2E03707344U};
    for (const std::uint32_t word : words)
    {
        key[0] = Mixed(key[0], word, 0x9E3779B97F4A7C15U);
        key[1] = Mixed(key[1], word, 0xC2B2AE3D27D4EB4FU);
    }
    return key;
}

std::uint64_t Digest(const std::vector<std::uint8_t>& bytes)
{
    std::uint64_t digest = 0U;
    for (std::size_t at = 0U; at < bytes.size(); at += kWordBytes)
    {
        std::uint32_t word = 0U;
        std::memcpy(&word, &bytes[at], kWordBytes);
        digest = Mixed(digest, word, 0x9E3779B97F4A7C15U);
    }
    return digest;
}
} // namespace

void Image::Read(const World& world)
{
    bytes_.clear();
    for (const Region& region : world.Regions())
    {
        const std::uint8_t* const first = static_cast<const std::uint8_t*>(region.first);
        bytes_.insert(bytes_.end(), first, first + region.bytes);
        bytes_.resize((bytes_.size() + kWordBytes - 1U) / kWordBytes * kWordBytes);
    }
}

std::uint32_t Image::Word(const std::size_t word) const
{
    std::uint32_t value = 0U;
    std::memcpy(&value, &bytes_[word * kWordBytes], kWordBytes);
    return value;
}

/// Takes out of the candidates what is not equal to what is shown.
void Image::NarrowDown(const World& world)
{
    const Counted counted = world.Counts();
    const bool is_call = world.Now().frame_us == 0U;
    for (std::size_t word = 0U; word < rules_.size(); ++word)
    {
        const std::uint32_t value = Word(word);
        cycles_[word] = cycles_[word] && (value == counted.cycles);
        ordinals_[word] = ordinals_[word] && (value == counted.ordinal);
        elapsed_[word] = elapsed_[word] && (world.Now().is_left || !is_call || (value == counted.active_us));
    }
    for (std::size_t half = 0U; half < errors_.size(); ++half)
    {
        std::uint16_t value = 0U;
        std::memcpy(&value, &bytes_[half * kHalfBytes], kHalfBytes);
        errors_[half] = errors_[half] && (value == counted.errors);
    }
}

std::string Image::Learn(World& world, const std::vector<Letter>& letters, const std::uint32_t base_us)
{
    const std::vector<std::size_t> script = Script(letters);
    std::vector<std::vector<std::uint8_t>> seen;
    world.Start(base_us);
    Read(world);
    rules_.assign(bytes_.size() / kWordBytes, Rule::kAsItIs);
    cycles_.assign(rules_.size(), true);
    ordinals_ = cycles_;
    elapsed_ = cycles_;
    errors_.assign(bytes_.size() / kHalfBytes, true);
    for (const std::size_t letter : script)
    {
        static_cast<void>(world.Apply(letters[letter]));
        Read(world);
        NarrowDown(world);
        seen.push_back(bytes_);
    }
    world.Start(base_us + kMovedUs);
    for (std::size_t step = 0U; step < script.size(); ++step)
    {
        static_cast<void>(world.Apply(letters[script[step]]));
        Read(world);
        for (std::size_t word = 0U; word < rules_.size(); ++word)
        {
            std::uint32_t before = 0U;
            std::memcpy(&before, &seen[step][word * kWordBytes], kWordBytes);
            const std::uint32_t moved = Word(word) - before;
            if ((moved != 0U) && (moved != kMovedUs))
            {
                return "word " + std::to_string(word) + " changes with the counter's start and is no instant";
            }
            rules_[word] = (moved != 0U) ? Rule::kInstant : rules_[word];
        }
    }
    Collect(world);
    return {};
}

void Image::Collect(const World& world)
{
    for (std::size_t word = 0U; word < rules_.size(); ++word)
    {
        rules_[word] = elapsed_[word] ? Rule::kElapsed : rules_[word];
        rules_[word] = ordinals_[word] ? Rule::kOrdinal : rules_[word];
        rules_[word] = cycles_[word] ? Rule::kLeftOut : rules_[word];
    }
    for (const std::size_t place : world.Budgets())
    {
        rules_[place / kWordBytes] = Rule::kBudget;
    }
    half_words_.clear();
    for (std::size_t half = 0U; half < errors_.size(); ++half)
    {
        if (errors_[half])
        {
            half_words_.push_back(half * kHalfBytes);
        }
    }
}

void Image::AddBytes(const std::uint32_t now)
{
    for (const std::size_t half : half_words_)
    {
        bytes_[half] = 0U;
        bytes_[half + 1U] = 0U;
    }
    for (std::size_t word = 0U; word < rules_.size(); ++word)
    {
        const std::uint32_t value = Word(word);
        switch (rules_[word])
        {
        case Rule::kAsItIs:
            key_.push_back(value);
            break;
        case Rule::kInstant:
            key_.push_back((value != 0U) ? std::min(now - value, kOldestUs) : kOldestUs); // 0: not written yet.
            break;
        case Rule::kElapsed:
            key_.push_back(std::min(value, kOldestUs));
            break;
        case Rule::kBudget:
            key_.push_back((value > kOldestUs) ? kOldestUs : value);
            break;
        case Rule::kOrdinal:
            key_.push_back((value != 0U) ? 1U : 0U);
            break;
        case Rule::kLeftOut:
            break;
        }
    }
}

void Image::AddShown(const World& world)
{
    const Course& course = world.Now();
    const std::int64_t here = course.called_us + course.frame_us;
    course.witness.AddTo(key_, here, kOldestUs);
    for (const third_voice::Time part : course.model.StandingAt(here))
    {
        key_.push_back(static_cast<std::uint32_t>(std::min<third_voice::Time>(part, kOldestUs)));
    }
    key_.push_back(course.frame_us | (course.has_gfc ? 0x100U : 0U) | (course.is_left ? 0x200U : 0U));
    key_.push_back(course.told);
    key_.push_back((static_cast<std::uint32_t>(course.state) << 8U) | static_cast<std::uint32_t>(course.first_cause));
    key_.push_back(world.Objects());
}

Marked Image::MarkedOf(const World& world, const Sight sight)
{
    Read(world);
    const std::uint64_t raw = Digest(bytes_);
    key_.clear();
    AddShown(world);
    const Key shown = KeyOf(key_);
    AddBytes(world.NowUs());
    const Key whole = KeyOf(key_);
    return (sight == Sight::kBytes) ? Marked{whole, raw} : Marked{shown, whole[0]};
}

std::string Image::Summary() const
{
    std::size_t counts[6] = {};
    for (const Rule rule : rules_)
    {
        ++counts[static_cast<std::size_t>(rule)];
    }
    return std::to_string(rules_.size()) + " words: " + std::to_string(counts[1]) + " instants, " +
           std::to_string(counts[2]) + " elapsed, " + std::to_string(counts[3]) + " budgets, " +
           std::to_string(counts[4]) + " ordinals, " + std::to_string(counts[5]) + " and " +
           std::to_string(half_words_.size()) + " halves left out";
}

} // namespace counterpoint::proof
