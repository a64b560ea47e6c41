// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/crc.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/checksum.hpp"
#include "verification/proof/checksum.hpp"
#include "verification/proof/runs.hpp"
#include "verification/proof/signature.hpp"

#include <CLI/CLI.hpp>

#include <ctime>
#include <iostream>
#include <string>

using namespace counterpoint;
using namespace counterpoint::proof;

namespace
{
constexpr std::uint32_t kDraws = 4000000U;
constexpr std::uint32_t kDigests = 100000U;
constexpr std::uint32_t kAllBytes = 256U;

/// What is asked.
struct Wish
{
    bool is_long{false};
    std::string domain{};
    std::uint32_t depth{100U};
    bool by_bytes{false};
};

/// Prints, and counts what holds.
class Table
{
  public:
    void Add(const std::string& name, const Shown& shown)
    {
        Count(shown.refused);
        std::cout << name << ": " << shown.steps << " steps"
                  << (shown.refused.empty() ? "" : ", REFUSED: " + shown.refused) << Elapsed() << std::endl;
    }
    void Add(const std::string& name, const Result& result)
    {
        Count(result.refused);
        std::cout << name << ": depth " << result.depth << (result.is_closed ? " (closed)" : "") << ", "
                  << result.states << " states, " << result.transitions << " transitions, " << result.releases
                  << " releases, " << result.faults << " faults, " << result.twins << " twins"
                  << (result.refused.empty() ? "" : ", REFUSED: " + result.refused) << Elapsed() << std::endl;
        for (const std::string& step : result.story)
        {
            std::cout << "    " << step << "\n";
        }
    }
    [[nodiscard]] int End() const
    {
        std::cout << "proof: " << shown_ << " shown, " << refused_ << " refused"
                  << ((refused_ == 0U) ? ": pass" : ": FAIL") << std::endl;
        return (refused_ == 0U) ? 0 : 1;
    }

  private:
    void Count(const std::string& refused)
    {
        (refused.empty() ? shown_ : refused_) += 1U;
    }
    /// @brief Processor time since the last line.
    std::string Elapsed()
    {
        const std::clock_t now = std::clock();
        const long tenths = (now - last_) / (CLOCKS_PER_SEC / 10);
        last_ = now;
        return ", " + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
    }

    std::uint32_t shown_{0U};
    std::uint32_t refused_{0U};
    std::clock_t last_{std::clock()};
};

void ProveChecksums(Table& table, const bool is_long)
{
    table.Add("CRC-16 of channel A, each state and byte", ProveSixteen<channel_a::Crc16>());
    table.Add("CRC-16 of channel B, each state and byte", ProveSixteen<channel_b::Crc16>());
    table.Add("CRC-32 of channel A, bytes", ProveThirtyTwo<channel_a::Crc32>(kDraws));
    table.Add("CRC-32 of channel B, bytes", ProveThirtyTwo<channel_b::Crc32>(kDraws));
    if (is_long)
    {
        table.Add("CRC-32 of channel A, each state", ProveEachState<channel_a::Crc32>());
        table.Add("CRC-32 of channel B, each state", ProveEachState<channel_b::Crc32>());
    }
    channel_a::StorageFor<2U, 2U> storage_a{};
    channel_b::StorageFor<2U, 2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    const std::uint32_t srvts = is_long ? kAllBytes : 4U;
    table.Add("signature by channel A", SignatureRig{a}.ProveSignature(srvts));
    table.Add("signature by channel B", SignatureRig{b}.ProveSignature(srvts));
    table.Add("digest by channel A", SignatureRig{a}.ProveDigest(kDigests));
    table.Add("digest by channel B", SignatureRig{b}.ProveDigest(kDigests));
}

void Explore(Table& table, const std::vector<Exploration>& explorations)
{
    for (const Exploration& exploration : explorations)
    {
        for (const ConsumerSetup& setup : MakeSetups())
        {
            const std::string how = (exploration.sight == Sight::kBytes) ? " by bytes" : " by what is shown";
            table.Add("consumer, " + NameOf(setup) + ", " + exploration.domain + how +
                          (exploration.is_wrapping ? ", counter wraps" : ""),
                      RunExploration(exploration, setup, nullptr, nullptr));
        }
    }
}
} // namespace

int main(const int count, char** const words)
{
    CLI::App app{"Proves the checksums of both channels by exhaustion, and explores every sequence of inputs of a "
                 "consumer in both."};
    Wish wish;
    app.add_flag("--long", wish.is_long,
                 "Every state of CRC-32, every SRVT of the signature, all letters together: minutes");
    app.add_option("--domain", wish.domain, "This set of letters alone: timing, frames, calls or all")
        ->check(CLI::IsMember({"timing", "frames", "calls", "all"}));
    app.add_option("--depth", wish.depth, "With --domain: so many letters in a row at most")->needs("--domain");
    app.add_flag("--bytes", wish.by_bytes, "With --domain: states are told apart by their bytes")->needs("--domain");
    CLI11_PARSE(app, count, words);
    Table table;
    if (!wish.domain.empty())
    {
        Explore(table, {{wish.domain, wish.by_bytes ? Sight::kBytes : Sight::kShown, wish.depth, false}});
        return table.End();
    }
    ProveChecksums(table, wish.is_long);
    Explore(table, ExplorationsOf(false));
    if (wish.is_long)
    {
        Explore(table, ExplorationsOf(true));
    }
    return table.End();
}
