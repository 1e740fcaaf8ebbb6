// The floor while it is being furnished: what stands already, what must stay free, and what may
// still be placed.
#pragma once
#include <string>
#include <vector>

#include "layout/design.h"
#include "layout/layout.h"
#include "layout/module_spec.h"

namespace marketgen::layout {

// A line of modules to be placed.
struct Row {
  std::string run;  // its id
  const plan::Zone* zone;
  const ModuleSpec* spec;
  Side front;       // the side its (first) front faces
  RectMm band;      // where it may stand: as deep as the module
  int clear_mm;     // free floor needed before each front
  int max_modules;  // no more than this many
};

// A line of modules that was placed.
struct PlacedRun {
  std::string run;
  RectMm rect;
  int modules = 0;
};

// Where leftover length goes.
enum class Packing { low, middle, high };

class Site {
 public:
  explicit Site(const Design& design);

  const std::vector<Fixture>& fixtures() const { return fixtures_; }
  std::vector<Fixture> take_fixtures() { return std::move(fixtures_); }

  // The rectangle is on the floor and overlaps neither a fixture nor floor that must stay free.
  bool can_stand(const RectMm& footprint) const;
  // Nothing solid stands there: fixtures, columns, walls.
  bool is_clear(const RectMm& rect) const;

  // The stretches along the band on which modules may stand.
  std::vector<Span> free_spans(const Row& row) const;

  // Fills the free stretches with modules, one run each. A second stretch gets the run id "<run>b"
  // and so on.
  std::vector<PlacedRun> place(const Row& row, Packing align);
  // Places one fixture where it is; the caller has checked. Free floor is kept before its front.
  void add(Fixture fixture, int clear_mm);
  // The same for one that stood here before: where it is stocked from both sides, before both.
  void keep(Fixture fixture, int clear_mm);
  // One that takes no floor: the wall carries it.
  void hang(Fixture fixture) { fixtures_.push_back(std::move(fixture)); }
  void keep_clear(const RectMm& rect) { kept_clear_.push_back(rect); }

  // Distance from the rectangle's side to the nearest fixture, column or wall beyond it, at most
  // `reach_mm`.
  int free_beyond(const RectMm& rect, Side side, int reach_mm) const;

 private:
  // Appends the modules of one run from `start` on; returns the stretch they take.
  Span add_modules(const Row& row,
                   const std::string& run,
                   const std::vector<int>& widths,
                   int start);

  const Design& design_;
  std::vector<Fixture> fixtures_;
  std::vector<RectMm> fixed_;     // columns with their clearance, and what is not floor
  std::vector<RectMm> standing_;  // one rectangle per run segment
  std::vector<RectMm> kept_clear_;
};

}  // namespace marketgen::layout
