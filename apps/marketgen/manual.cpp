// marketgen manual: writes the manual pages.
#include "command.h"
#include "io/output.h"
#include "manual_pages.h"

namespace marketgen::app {
namespace {

Result<void> write_pages(const CLI::App& program, const std::string& folder) {
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add_folder(folder));
  for (const ManualPage& page : manual_pages(command_tree(program)))
    MARKETGEN_CHECK(outputs.put(std::filesystem::path(folder) / page.file, page.text));
  return outputs.commit();
}

}  // namespace

Run add_manual(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "manual", "Write the manual pages; an installation has them: man marketgen");
  add_output(*command, "-o,--output", *folder, "folder for marketgen.1 and a page of every command")
      ->required();
  command->footer("Example:  marketgen manual -o man && man -l man/marketgen-export.1");
  return [folder, &app] {
    const auto done = write_pages(app, *folder);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
