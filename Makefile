# The commands a contributor needs; `make help` lists them. What they run is in tools/ and CMakePresets.json.
.PHONY: help setup build viewer docs demo gallery test slow sanitize fuzz bench format lint clean
.DEFAULT_GOAL := help

# WERROR=ON: warnings stop the release build, as in CI. TIDY: what `make test` gives to clang-tidy: CHANGED (75 s at
# most, newest files first; what was found clean is kept), ALL or OFF.
WERROR ?= OFF
TIDY ?= CHANGED
MARKETGEN := build/release/marketgen
DEMO := out/demo
FUZZ_SECONDS ?= 120
DEMO_PROMPT := A bright neighbourhood supermarket with a fresh produce market by the entrance, a bakery, \
dairy along the back wall, two rows of frozen food, seven aisles of groceries and snacks, and three checkouts

help: ## list the targets
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/  make \1\t\2/p' Makefile | expand -t 16

setup: ## install everything that building and testing need (Debian 12, root)
	tools/setup all

build: ## the program: build/release/marketgen
	tools/setup build
	cmake --preset release -DMARKETGEN_TESTS=OFF -DMARKETGEN_WERROR=$(WERROR)
	cmake --build --preset release

viewer: ## the page of `marketgen view`: viewer/dist
	tools/setup build
	cmake --preset release -DMARKETGEN_TESTS=OFF -DMARKETGEN_WERROR=$(WERROR)
	cmake --build --preset release --target marketgen_page

docs: build ## the documentation as a web site: build/site
	tools/docs

demo: build ## make, draw and check a 24 x 15 m store in out/demo; film a robot at both tasks in it
	rm -rf $(DEMO)
	@mkdir -p $(dir $(DEMO))
	$(MARKETGEN) generate "$(DEMO_PROMPT)" --size 24x15m --seed 7 -o $(DEMO)
	$(MARKETGEN) check $(DEMO)
	$(MARKETGEN) render $(DEMO) --camera aisle --size 1280x720 -o out/demo-aisle.png
	for track in checkout aisle; do \
	  $(MARKETGEN) episodes $(DEMO) --track $$track --count 1 --seed 7 -o out/demo-$$track.jsonl && \
	  $(MARKETGEN) replay --episodes out/demo-$$track.jsonl --episode 0 --speed 8 --film out/demo-$$track.mp4 \
	    --strip out/demo-$$track-strip.png || exit 1; done
	@printf '\nstore     %s\n' "$(CURDIR)/$(DEMO)"
	@ls -1 $(CURDIR)/$(DEMO)/*.png $(CURDIR)/$(DEMO)/previews/*.png $(CURDIR)/out/demo-*.png | sed 's/^/picture   /'
	@ls -1 $(CURDIR)/out/demo-*.mp4 | sed 's/^/film      /'

gallery: build ## the stores and stills of docs/gallery.md; about 20 minutes
	tools/gallery

test: ## everything CI checks; ends with the release tests' summary
	tools/test --werror=$(WERROR) --lint=$(TIDY)

slow: ## the tests that `make test` leaves out: long samples, of which it has short ones; about 20 minutes
	tools/setup all
	cmake --preset release -DMARKETGEN_TESTS=ON -DMARKETGEN_WERROR=$(WERROR)
	cmake --build --preset release
	ctest --preset slow

sanitize: ## the whole chain over every value of a plan, under address and undefined-behaviour sanitizers
	cmake --preset asan -DMARKETGEN_MODULES=export && cmake --build --preset asan --target test_export
	MARKETGEN_CHAINS=all ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1 \
	  ASAN_SYMBOLIZER_PATH=/usr/lib/llvm-16/bin/llvm-symbolizer UBSAN_OPTIONS=print_stacktrace=1 \
	  LSAN_OPTIONS=suppressions=cmake/lsan.supp \
	  build/asan/tests/test_export --gtest_filter='*Chain*:PlanSampler*'

fuzz: ## every fuzz target for two minutes from a new seed (FUZZ_SECONDS=120)
	cmake --preset asan && cmake --build --preset asan
	tools/fuzz $(FUZZ_SECONDS)

bench: build ## the committed benchmarks, one JSON line a figure
	$(MARKETGEN) bench

format: ## clang-format over every C++ file
	tools/format

lint: ## clang-tidy over every C++ file
	tools/lint

clean: ## remove build/ and out/
	rm -rf build out
