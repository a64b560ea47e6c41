// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/comparator_rig.hpp"
#include "verification/proof/protocols/election_rig.hpp"
#include "verification/proof/protocols/link_rig.hpp"
#include "verification/proof/protocols/producer_rig.hpp"
#include "verification/proof/protocols/replay.hpp"

#include <exception>
#include <iostream>
#include <stdexcept>

using namespace counterpoint::protocols;

namespace
{

/// A defect by its name on the command line.
template <typename Defect> struct Named
{
    const char* name;
    Defect defect;
};

constexpr Named<ComparatorDefect> kComparatorDefects[] = {{"way_out", ComparatorDefect::kWayOut},
                                                          {"longer_limit", ComparatorDefect::kLongerLimit},
                                                          {"one_is_enough", ComparatorDefect::kOneIsEnough}};
constexpr Named<LinkDefect> kLinkDefects[] = {{"longer_timeout", LinkDefect::kLongerTimeout},
                                              {"takes_foreign", LinkDefect::kTakesForeign},
                                              {"older_answers", LinkDefect::kOlderAnswers}};
constexpr Named<ElectionDefect> kElectionDefects[] = {{"unbounded", ElectionDefect::kUnbounded},
                                                      {"deaf_to_force", ElectionDefect::kDeafToForce},
                                                      {"wrong_priority", ElectionDefect::kWrongPriority}};
constexpr Named<ProducerDefect> kProducerDefects[] = {{"longer_srvt", ProducerDefect::kLongerSrvt},
                                                      {"forgets_faults", ProducerDefect::kForgetsFaults},
                                                      {"confirms_itself", ProducerDefect::kConfirmsItself}};

int Print(const Replayed& replayed)
{
    std::cout << "replay: " << replayed.states << " states, " << replayed.transitions << " transitions, "
              << replayed.steps << " steps of the code"
              << (replayed.refused.empty() ? "" : ", REFUSED: " + replayed.refused) << "\n";
    for (const std::string& step : replayed.story)
    {
        std::cout << "    " << step << "\n";
    }
    return replayed.refused.empty() ? 0 : 1;
}

/// The code as it is without `wish`, with the defect of that name, or the names of all.
template <typename Rig, typename Defect, std::size_t kCount>
int Run(const Named<Defect> (&defects)[kCount], const std::string& wish)
{
    if (wish.empty())
    {
        const Model model = ReadModel(std::cin);
        return Print(Replay<Rig>{model}.Run(Rig{}));
    }
    for (const Named<Defect>& named : defects)
    {
        if (wish == "--defects")
        {
            std::cout << named.name << "\n";
        }
        else if (wish == named.name)
        {
            const Model model = ReadModel(std::cin);
            return Print(Replay<Rig>{model}.Run(Rig{named.defect}));
        }
    }
    return (wish == "--defects") ? 0 : throw std::runtime_error("no defect '" + wish + "', see --defects");
}

} // namespace

int main(const int count, char** const words)
{
    const std::string name = (count >= 2) ? words[1] : "";
    const std::string wish = (count >= 3) ? words[2] : "";
    try
    {
        if (name == "comparator")
        {
            return Run<ComparatorRig>(kComparatorDefects, wish);
        }
        if (name == "link")
        {
            return Run<LinkRig>(kLinkDefects, wish);
        }
        if (name == "election")
        {
            return Run<ElectionRig>(kElectionDefects, wish);
        }
        if (name == "producer")
        {
            return Run<ProducerRig>(kProducerDefects, wish);
        }
    }
    catch (const std::exception& error)
    {
        std::cerr << "counterpoint_replay: " << error.what() << "\n";
        return 2;
    }
    std::cerr << "usage: counterpoint_replay comparator|election|link|producer [DEFECT | --defects] < TRANSITIONS\n";
    return 2;
}
