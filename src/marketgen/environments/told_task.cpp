#include "environments/told_task.h"

namespace marketgen::environments {

ToldTask told_task(const episodes::EpisodeSpec& spec) {
  ToldTask task;
  task.track = spec.track;
  task.station = spec.station;
  task.robot = spec.robot;
  task.tools = spec.tools;
  task.cameras = spec.cameras;
  task.instruction = spec.instruction;
  task.goals = episodes::told_goals(spec);
  task.categories = episodes::told_categories(spec);
  task.limit_s = spec.limit_s;
  return task;
}

}  // namespace marketgen::environments
