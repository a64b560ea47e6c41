// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/latency.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::size_t kFinestUs = 100000U;
constexpr std::size_t kBarLetters = 40U;

std::string Padded(const std::string& text, const std::size_t width)
{
    return std::string(width > text.size() ? width - text.size() : 0U, ' ') + text;
}
} // namespace

void NodeLatency::Add(const std::uint64_t ns)
{
    const std::uint64_t us = ns / kNsPerUs;
    counts_.resize(kFinestUs + 1U);
    ++counts_[std::min<std::uint64_t>(us, kFinestUs)];
    least_us_ = (count_ == 0U) ? us : std::min(least_us_, us);
    greatest_us_ = std::max(greatest_us_, us);
    ++count_;
}

std::uint64_t NodeLatency::Percentile(const unsigned percent) const
{
    const std::uint64_t wanted = (count_ * percent + 99U) / 100U;
    std::uint64_t seen = 0U;
    for (std::size_t us = 0U; us < counts_.size(); ++us)
    {
        seen += counts_[us];
        if (seen >= wanted && us < kFinestUs)
        {
            return us;
        }
    }
    return greatest_us_;
}

/// Counts of 0 to 1 us, 2 to 3, 4 to 7 and so on, up to the greatest; there is at least one.
std::vector<std::uint64_t> NodeLatency::Doubling() const
{
    std::vector<std::uint64_t> bins;
    std::size_t from = 0U;
    for (std::size_t to = 2U; from <= std::min<std::uint64_t>(greatest_us_, kFinestUs); to *= 2U)
    {
        std::uint64_t sum = 0U;
        for (std::size_t us = from; us < std::min(to, counts_.size()); ++us)
        {
            sum += counts_[us];
        }
        bins.push_back(sum);
        from = to;
    }
    return bins;
}

std::string NodeLatency::Text() const
{
    if (count_ == 0U)
    {
        return "receive stamp to released output: no pair was released\n";
    }
    std::string text = "receive stamp to released output [us]: " + std::to_string(count_) + " pairs, least " +
                       std::to_string(least_us_) + ", median " + std::to_string(Percentile(50U)) + ", 99 % " +
                       std::to_string(Percentile(99U)) + ", greatest " + std::to_string(greatest_us_) + "\n";
    const std::vector<std::uint64_t> bins = Doubling();
    const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
    std::uint64_t below = 2U;
    for (const std::uint64_t bin : bins)
    {
        if (bin != 0U)
        {
            text += "  < " + Padded(std::to_string(below), 7U) + "  " + Padded(std::to_string(bin), 9U) + "  " +
                    std::string(static_cast<std::size_t>(1U + (bin * (kBarLetters - 1U)) / most), '#') + "\n";
        }
        below *= 2U;
    }
    return text;
}

nlohmann::ordered_json NodeLatency::Json() const
{
    nlohmann::ordered_json answer{{"pairs", count_}};
    if (count_ != 0U)
    {
        answer.update({{"least_us", least_us_},
                       {"median_us", Percentile(50U)},
                       {"percentile_99_us", Percentile(99U)},
                       {"greatest_us", greatest_us_}});
        answer["below_us"] = nlohmann::ordered_json::object();
        std::uint64_t below = 2U;
        for (const std::uint64_t bin : Doubling())
        {
            answer["below_us"][std::to_string(below)] = bin;
            below *= 2U;
        }
    }
    return answer;
}
} // namespace counterpoint::runtime
