// Certificates in physics: an episode is carried out as it is, and again in worlds that are a
// little other. A certificate says that the task can be done by an arm with this hand.
//
// Any one of several actors may do it, so that the oracle is not its own examiner. All of them know
// the truth of the world that they act in, also of a perturbed one: they plan anew in each, and as
// things move. Errors of knowledge are another matter, and the policies'.
#pragma once
#include <string>
#include <vector>

#include "environments/arena.h"
#include "episodes/certificate.h"
#include "episodes/episode_spec.h"

namespace marketgen::environments {

struct CertificateRules {
  int replays = 10, needed = 9;
  episodes::PerturbationSizes perturbation;
  // Policies, in their order: the quickest first.
  std::vector<std::string> actors{"oracle-plain", "oracle", "oracle-thorough"};
};

// A run holds when all goals are met. An actor's replays end as soon as they are decided; those
// that follow the first actor that has done it are not tried. Perturbed world k is the same for all
// actors: its seed is a named stream of the episode's. Errors: those of Arena::open and
// Arena::policy; an interrupt.
Result<episodes::PhysicsProof> prove(Arena& arena,
                                     const episodes::EpisodeSpec& spec,
                                     const CertificateRules& rules = {});

// The world in which that replay happens, from 0.
episodes::Perturbation replay_perturbation(const episodes::EpisodeSpec& spec,
                                           const episodes::PerturbationSizes& sizes,
                                           int replay);

}  // namespace marketgen::environments
