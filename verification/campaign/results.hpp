// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_RESULTS_HPP
#define VERIFICATION_CAMPAIGN_RESULTS_HPP

#include "verification/campaign/outcome.hpp"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// The part of a campaign that one machine runs: each `count`-th experiment, from `number` (from 1) on.
struct Shard
{
    std::uint32_t number{1U};
    std::uint32_t count{1U};
};

/// What a file of results belongs to. [SRS_CMG_800]
struct ResultsOf
{
    std::uint64_t plan{0U};  ///< Digest of its text.
    std::uint64_t total{0U}; ///< Experiments of the whole campaign.
    Shard shard{};
    std::uint64_t setting{0U}; ///< Digest of what is hit and how it is judged: scenario, DCFs, recording, limits.
    std::uint64_t program{0U};
    Strange (*strange_in)(const Outcome&){nullptr}; ///< Null: any outcome is taken. [SRS_CMG_802]
};

/// What is done with a file of results.
enum class Access : std::uint8_t
{
    kWrite, ///< Gone on with, or made.
    kRead,  ///< Joined: it may be one that nobody may write.
};

/// Memory that all processes of a campaign share.
class SharedBytes
{
  public:
    explicit SharedBytes(std::size_t length) noexcept;
    ~SharedBytes();
    SharedBytes(const SharedBytes&) = delete;
    SharedBytes& operator=(const SharedBytes&) = delete;

    /// @brief Null: there is no room.
    [[nodiscard]] std::uint8_t* Begin() const noexcept
    {
        return begin_;
    }

  private:
    std::size_t length_;
    std::uint8_t* begin_;
};

/// A file that is open, or none.
class OpenFile
{
  public:
    OpenFile() = default;
    ~OpenFile();
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    void Take(const int descriptor) noexcept
    {
        descriptor_ = descriptor;
    }
    [[nodiscard]] int Number() const noexcept
    {
        return descriptor_;
    }

  private:
    int descriptor_{-1};
};

/// A file with one outcome an experiment, and the same in memory that all processes share. Each outcome is written when
/// it is known: what was written is there whatever becomes of the processes. It is no memory of the system's that
/// somebody else can take away by making the file shorter. Each outcome, and what the file belongs to, has a check of
/// its own. [SRS_CMG_008, SRS_CMG_803]
class Results
{
  public:
    /// @brief Opens or makes the file; without a name the outcomes are kept in memory alone. Throws YamlError for a
    /// file that is no file of results, a damaged one, or one of something else, and where there is no room for all of
    /// it. Of one that is opened for reading nothing is put.
    Results(const std::string& file, const ResultsOf& of, Access access = Access::kWrite);
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;
    ~Results() = default;

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
    /// @brief All of it or nothing, whoever else writes, and whenever the process ends. Where it cannot be written,
    /// RequireThere says so.
    void Put(std::uint64_t index, const Outcome& outcome) noexcept;
    /// @brief Takes over what another file has. Throws YamlError for a damaged one, and one of something else.
    void Merge(const std::string& file);
    /// @brief How many are not tried yet.
    [[nodiscard]] std::uint64_t OpenCount() const noexcept;
    /// @brief Throws YamlError where the file has another size or another head than it was given, or an outcome could
    /// not be written. [SRS_CMG_803]
    void RequireThere() const;
    /// @brief The same, and where an outcome is not in the file as it was put. [SRS_CMG_803]
    void RequireKept() const;
    /// @brief The shard that a file holds. Throws YamlError.
    [[nodiscard]] static ResultsOf Read(const std::string& file);

  private:
    void Open(Access access);
    void ReadAll();
    void Begin();
    void TakeRoom(bool is_new) const;
    void RequireOf(bool can_begin) const;
    void RequireWhole() const;
    void RequireNothing() const;
    [[nodiscard]] std::uint32_t* Error() const noexcept;

    std::string file_;
    ResultsOf of_;
    std::uint64_t size_;
    std::size_t length_;
    SharedBytes memory_; ///< As the file; behind it the error number of a write that failed.
    OpenFile open_{};
    bool was_empty_{false};
};

constexpr std::uint64_t kNoDigest = 0xCBF29CE484222325U;
/// @brief One more number, or all bytes of these files whatever their names are, in a digest. [SRS_CMG_800]
[[nodiscard]] constexpr std::uint64_t With(const std::uint64_t digest, const std::uint64_t value) noexcept
{
    return (digest ^ value) * 0x100000001B3U;
}
[[nodiscard]] std::uint64_t WithFiles(std::uint64_t digest, const std::vector<std::string>& files);
/// @brief The digest of a program that tries faults, by its version, commit and objects: what another one found says
/// nothing of this one's. [SRS_CMG_501]
[[nodiscard]] std::uint64_t OfProgram(std::uint64_t digest, const char* program) noexcept;
/// @brief Says where the file was there with nothing in it. [SRS_CMG_330]
void TellEmpty(const Results& results, const std::string& file, std::ostream& err);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_RESULTS_HPP
