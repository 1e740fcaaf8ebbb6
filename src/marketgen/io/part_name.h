// Names of what is being written: files and folders that become outputs only when they are whole.
// A name says which process it belongs to, so that those of dead processes can be swept.
#pragma once
#include <filesystem>
#include <string>

namespace marketgen::io {

// A hidden name in `folder` that nobody else uses, with the same extension or none: for what will
// be called `name`.
std::filesystem::path part_in(const std::filesystem::path& folder, const std::string& name);

// Removes from `folder` what processes left that were ended before they could: of this machine (and
// container) only, and only when no process has that number and start any more.
void sweep_parts(const std::filesystem::path& folder);
// The same, but once a process: for folders that are written to often (caches).
void sweep_parts_once(const std::filesystem::path& folder);

}  // namespace marketgen::io
