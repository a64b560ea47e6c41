// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_OPTIONS_HPP
#define TOOLS_COMMAND_LINE_OPTIONS_HPP

#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace counterpoint::tools
{
/// Says in words what is wrong with a value; an empty text: nothing.
using Problem = std::string (*)(const std::string& text);

/// A file name is wrong when it is empty, which would count as not given. [SRS_CLI_020]
[[nodiscard]] std::string ProblemOfFileName(const std::string& text);
/// The address of a bus is wrong when it is empty. [SRS_CLI_020]
[[nodiscard]] std::string ProblemOfAddress(const std::string& text);

/// Any other text is wrong when it is empty; of options that name no other check. [SRS_CLI_020]
[[nodiscard]] std::string ProblemOfAnyText(const std::string& text);

/// How many values an option takes.
struct ValueCount
{
    int least;
    int most;
};

/// One option or positional argument of a command. Of the sources only run.cpp includes the library that reads command
/// lines, because that library takes long to compile.
struct Option
{
    /// Where the value goes. A flag is a bool; a number is refused where people read it otherwise than the library
    /// does, such as 010, which would be 8. [SRS_CLI_020]
    using Target = std::variant<bool*, int*, std::string*, std::vector<std::string>*>;

    std::string name;
    Target target;
    std::string description;
    bool is_required{false};
    bool shows_default{false};
    bool takes_one_value{false};           ///< Where the option may be given several times: one value each time.
    std::optional<std::string> type;       ///< What the help shows for its value; empty: nothing.
    std::optional<std::string> if_alone;   ///< The value where none follows the option.
    std::optional<ValueCount> value_count; ///< How many values may follow each time it is given.
    Problem problem{nullptr};
    std::optional<std::pair<int, int>> range;
    std::set<int> numbers;          ///< The only ones allowed; empty: all.
    std::vector<std::string> words; ///< The only ones allowed; empty: all. A `problem` refuses others in its own words.
    std::string excluded;           ///< Name of an option that may not stand beside it.
    std::string needed;             ///< Name of an option that must be given beside it.
    std::size_t times{0U};          ///< How often it was given.

    /// Each of the following sets the property of its name and returns the option itself.
    Option& Required()
    {
        is_required = true;
        return *this;
    }
    Option& ShowDefault()
    {
        shows_default = true;
        return *this;
    }
    Option& OneValueEach()
    {
        takes_one_value = true;
        return *this;
    }
    Option& Type(std::string text)
    {
        type = std::move(text);
        return *this;
    }
    Option& IfAlone(std::string value)
    {
        if_alone = std::move(value);
        return *this;
    }
    Option& Values(const int least, const int most)
    {
        value_count = ValueCount{least, most};
        return *this;
    }
    Option& Check(const Problem problem_of_value)
    {
        problem = problem_of_value;
        return *this;
    }
    Option& Range(const int lowest, const int highest)
    {
        range = {lowest, highest};
        return *this;
    }
    Option& OneOf(std::set<int> allowed)
    {
        numbers = std::move(allowed);
        return *this;
    }
    Option& Words(std::vector<std::string> allowed)
    {
        words = std::move(allowed);
        return *this;
    }
    Option& Excludes(std::string other)
    {
        excluded = std::move(other);
        return *this;
    }
    Option& Needs(std::string other)
    {
        needed = std::move(other);
        return *this;
    }
};

/// What a command takes; it lives as long as the command.
class Options
{
  public:
    /// A name without hyphens is that of a positional.
    Option& Add(std::string name, Option::Target target, std::string description)
    {
        Option option{};
        option.name = std::move(name);
        option.target = target;
        option.description = std::move(description);
        options_.push_back(std::move(option));
        return options_.back();
    }
    /// Sets the text below the options in the help.
    void Footer(std::string text)
    {
        footer_ = std::move(text);
    }

    /// Whether this option was on the command line.
    [[nodiscard]] bool IsGiven(const std::string& name) const;
    /// How many options were given.
    [[nodiscard]] std::size_t GivenCount() const;

    /// All options, in the order in which they were added.
    [[nodiscard]] std::deque<Option>& All()
    {
        return options_;
    }
    [[nodiscard]] const std::deque<Option>& All() const
    {
        return options_;
    }
    /// What Footer set.
    [[nodiscard]] const std::string& FooterText() const
    {
        return footer_;
    }

  private:
    std::deque<Option> options_; // Adding one moves no other.
    std::string footer_;
};
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_OPTIONS_HPP
