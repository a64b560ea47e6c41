// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_PROTOCOLS_REPLAY_HPP
#define VERIFICATION_PROOF_PROTOCOLS_REPLAY_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <istream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::protocols
{

using Numbers = std::vector<std::int32_t>;

/// One transition of a model: its states by their text, what goes in, what is to be seen.
struct Transition
{
    std::string before;
    Numbers input;
    std::string after;
    Numbers shown;
};

/// All transitions of a model, each once, by the state that they leave.
struct Model
{
    std::string first; ///< The state that the model begins in.
    std::map<std::string, std::vector<Transition>> from;
    std::size_t count;
};

/// @brief Reads "T before | input | after | shown" lines; others are passed over. Throws std::runtime_error on a line
/// that is no transition.
[[nodiscard]] Model ReadModel(std::istream& lines);

/// @brief A line of numbers, for people.
[[nodiscard]] std::string TextOf(const Numbers& numbers);

/// What a replay found.
struct Replayed
{
    std::size_t states;      ///< Of the model, reached in the code.
    std::size_t transitions; ///< Of the model, driven through the code at least once.
    std::size_t steps;   ///< Driven in all: each state as it was reached over each edge of the model that leads to it.
    std::string refused; ///< Empty: the code shows what the model says.
    std::vector<std::string> story; ///< Inputs that lead to what was refused.
};

/// Drives a rig, which is the code in one of its states and can be copied, through every transition of a model, from
/// each state of the model as it was reached over each of its edges.
template <typename Rig> class Replay
{
  public:
    explicit Replay(const Model& model) : model_(model)
    {
    }

    [[nodiscard]] Replayed Run(const Rig& rig)
    {
        Add(model_.first, rig, kNone, Numbers{});
        for (std::size_t place = 0U; (place < arrivals_.size()) && result_.refused.empty(); ++place)
        {
            DriveAll(place);
        }
        result_.states = reached_.size();
        if (result_.refused.empty() && (result_.transitions != model_.count))
        {
            result_.refused = "the code was driven through " + std::to_string(result_.transitions) +
                              " transitions of " + std::to_string(model_.count);
        }
        return result_;
    }

  private:
    /// The code in a state of the model, and how it came there.
    struct Arrival
    {
        std::string state;
        Rig rig;
        std::size_t before;
        Numbers input;
    };

    void Add(const std::string& state, const Rig& rig, const std::size_t before, const Numbers& input)
    {
        arrivals_.push_back(Arrival{state, rig, before, input});
        reached_.insert(state);
    }

    void DriveAll(const std::size_t place)
    {
        const std::string state = arrivals_[place].state;
        const bool is_new = driven_.insert(state).second;
        const auto found = model_.from.find(state);
        if (found == model_.from.end())
        {
            return;
        }
        for (const Transition& transition : found->second)
        {
            Rig rig = arrivals_[place].rig;
            const Numbers shown = rig.Apply(transition.input);
            ++result_.steps;
            result_.transitions += is_new ? 1U : 0U;
            if (shown != transition.shown)
            {
                result_.refused = "model shows " + TextOf(transition.shown) + ", code shows " + TextOf(shown);
                Tell(place, transition.input);
                return;
            }
            if (edges_.insert(state + ">" + transition.after).second)
            {
                Add(transition.after, rig, place, transition.input);
            }
        }
    }

    void Tell(std::size_t place, const Numbers& last)
    {
        result_.story.push_back(TextOf(last));
        for (; arrivals_[place].before != kNone; place = arrivals_[place].before)
        {
            result_.story.insert(result_.story.begin(), TextOf(arrivals_[place].input));
        }
    }

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    const Model& model_;
    std::deque<Arrival> arrivals_{};
    std::set<std::string> edges_{};
    std::set<std::string> driven_{};
    std::set<std::string> reached_{};
    Replayed result_{};
};

} // namespace counterpoint::protocols

#endif
