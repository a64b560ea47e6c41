// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_EXPLORER_HPP
#define VERIFICATION_PROOF_EXPLORER_HPP

#include "verification/proof/image.hpp"
#include "verification/proof/world.hpp"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace counterpoint::proof
{

/// How far an exploration goes.
struct Reach
{
    std::uint32_t depth;       ///< Letters in a row.
    std::uint64_t most_states; ///< It stops before a depth that would begin with more.
    std::uint32_t base_us;     ///< The counter at power-on.
    Sight sight;
    std::uint32_t most_twins; ///< Of one state.
};

/// What it came to.
struct Result
{
    std::string refused{};            ///< What does not hold, by name; empty: all holds.
    std::vector<std::string> story{}; ///< A sequence that leads there.
    std::uint64_t states{0U};
    std::uint64_t transitions{0U};
    std::uint64_t releases{0U}; ///< Transitions that release,
    std::uint64_t faults{0U};   ///< and that come to a fault.
    std::uint64_t twins{0U};    ///< States met again with other bytes, and driven through every letter, too.
    std::uint32_t depth{0U};    ///< All sequences of so many letters were looked at.
    bool is_closed{false};      ///< No new state came at that depth: longer sequences lead to no others.
    std::string words{};        ///< What the key makes of the bytes.
};

/// All sequences of the letters of a domain, breadth first; each state once.
class Explorer
{
  public:
    Explorer(World& world, const Domain& domain, const Reach& reach);
    [[nodiscard]] Result Run();

  private:
    struct Hash
    {
        std::size_t operator()(const Key& key) const
        {
            return static_cast<std::size_t>(key[0]);
        }
    };
    struct Origin
    {
        std::uint32_t from;
        std::uint8_t letter;
    };
    struct Standing
    {
        std::uint32_t state;
        std::uint32_t path; ///< How it was met; a twin's is another than its state's.
        Snapshot snapshot;
    };

    /// @brief Every letter from here; a digest of all that comes of it.
    [[nodiscard]] std::uint64_t Drive(const Standing& standing, bool is_twin);
    void Meet(const Marked& marked, const Standing& from, std::size_t letter);
    void DriveTwins();
    [[nodiscard]] std::vector<std::string> StoryOf(std::uint32_t path) const;

    World& world_;
    const Domain& domain_;
    Reach reach_;
    Image image_{};
    std::unordered_map<Key, std::uint32_t, Hash> known_;
    std::vector<Origin> paths_;
    std::vector<std::uint64_t> futures_; ///< Of each state that was driven.
    std::vector<std::uint32_t> twin_counts_;
    std::unordered_set<std::uint64_t> marks_;
    std::vector<Standing> next_;
    std::vector<Standing> twins_;
    Result result_{};
};

} // namespace counterpoint::proof

#endif
