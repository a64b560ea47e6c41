// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_RESULTS_HPP
#define VERIFICATION_CAMPAIGN_RESULTS_HPP

#include "verification/campaign/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace counterpoint::campaign
{
/// The part of a campaign that one machine runs: each `count`-th experiment, from `number` (from 1) on.
struct Shard
{
    std::uint32_t number{1U};
    std::uint32_t count{1U};
};

/// What a file of results belongs to.
struct ResultsOf
{
    std::uint64_t digest{0U}; ///< Of plan, recording and program.
    std::uint64_t total{0U};  ///< Experiments of the whole campaign.
    Shard shard{};
};

/// A file with one outcome an experiment. It is memory that is shared by all processes and kept by the system: what was
/// written is there whatever becomes of them. Each outcome, and what the file belongs to, has a check of its own.
/// [SRS_CMG_008]
/// What is done with a file of results.
enum class Access : std::uint8_t
{
    kWrite, ///< Gone on with, or made.
    kRead,  ///< Joined: it may be one that nobody may write.
};

class Results
{
  public:
    /// @brief Opens or makes the file; without a name the outcomes are kept in memory alone. Throws YamlError for a
    /// file that is no file of results, a damaged one, or one of something else, and where there is no room for all of
    /// it. Of one that is opened for reading nothing is put.
    Results(const std::string& file, const ResultsOf& of, Access access = Access::kWrite);
    ~Results();
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    /// @brief Whether the file was there, with nothing in it: what begins then is no campaign that goes on.
    /// [SRS_CMG_330]
    [[nodiscard]] bool WasEmpty() const noexcept
    {
        return was_empty_;
    }
    /// @brief Number of experiments in it.
    [[nodiscard]] std::uint64_t Size() const noexcept
    {
        return size_;
    }
    /// @brief The number of the experiment at this place.
    [[nodiscard]] std::uint64_t NumberAt(const std::uint64_t index) const noexcept
    {
        return (index * of_.shard.count) + (of_.shard.number - 1U);
    }
    [[nodiscard]] Outcome At(std::uint64_t index) const noexcept;
    /// @brief All of it or nothing, whoever else writes, and whenever the process ends.
    void Put(std::uint64_t index, const Outcome& outcome) noexcept;
    /// @brief Takes over what another file has. Throws YamlError for a damaged one, and one of something else.
    void Merge(const std::string& file);
    /// @brief How many are not tried yet.
    [[nodiscard]] std::uint64_t OpenCount() const noexcept;
    /// @brief The shard that a file holds. Throws YamlError.
    [[nodiscard]] static ResultsOf Read(const std::string& file);

  private:
    void Take(const std::string& file, Access access);
    void TakeRoom(int descriptor, const std::string& file, bool is_new) const;
    void Map(int descriptor, const std::string& file, Access access);
    void RequireWhole(const std::string& file);
    void RequireNothing(const std::string& file);

    ResultsOf of_;
    std::uint64_t size_;
    std::uint8_t* bytes_{nullptr};
    std::size_t length_;
    bool was_empty_{false};
};
/// @brief The digest of a campaign, and of the program that tries it, by its version, commit and objects: what another
/// one found says nothing of this one's. [SRS_CMG_501]
[[nodiscard]] std::uint64_t OfProgram(std::uint64_t digest, const char* program) noexcept;
/// @brief Says where the file was there with nothing in it. [SRS_CMG_330]
void TellEmpty(const Results& results, const std::string& file, std::ostream& err);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_RESULTS_HPP
