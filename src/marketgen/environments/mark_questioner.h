// What `vlm` asks with, which all of its modules share.
#pragma once
#include <memory>
#include <vector>

#include "environments/arena.h"
#include "environments/policy_name.h"
#include "perception/mark_question.h"
#include "perception/model_targets.h"

namespace marketgen::environments {

// Null for a policy that has no model. Errors: those of Arena::model.
Result<std::shared_ptr<perception::MarkQuestioner>> mark_questioner(const PolicyName& name,
                                                                    Arena& arena);

// As instructions would name what the store sells. `stock` is kept.
perception::ProductWords product_words(std::shared_ptr<const std::vector<catalog::Product>> stock);

}  // namespace marketgen::environments
