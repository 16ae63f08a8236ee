# Two commands do it all on a fresh Debian 12: `make run` and `make test`.
SHELL := /bin/bash
INPUT ?=
OUT ?= out
JOBS ?= $(shell nproc)

.PHONY: all setup build run python test bench format check clean

all: build

setup:  ## installs the packages that building needs, where they are missing
	@tools/install_packages.sh build

build: setup  ## build/release/scanfuse
	@cmake --preset release -DSCANFUSE_BUILD_TESTS=OFF > build.log 2>&1 || (cat build.log; exit 1)
	@rm -f build.log
	@cmake --build --preset release -j $(JOBS) --target scanfuse_cli

run: build  ## tracks the paper's second scenario and, if given, INPUT=recording
	@tools/run_demo.sh "$(OUT)" "$(INPUT)"

python: setup  ## `import scanfuse`, in build/release/python
	@tools/install_packages.sh python
	@cmake --preset release -DSCANFUSE_BUILD_PYTHON=ON -DSCANFUSE_BUILD_TESTS=OFF > /dev/null
	@cmake --build --preset release -j $(JOBS) --target scanfuse_python_package
	@echo "PYTHONPATH=$(CURDIR)/build/release/python python3 -c 'import scanfuse; help(scanfuse)'"

test: ## unit tests, end-to-end tests, layers, format, install
	@tools/install_packages.sh build test python bench
	@tools/run_tests.sh

bench: ## accuracy and speed, with peers where they are installed
	@tools/install_packages.sh build bench
	@tools/run_bench.sh "$(OUT)"

format: ## clang-format over all sources
	@tools/install_packages.sh test
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format-19 -i

check: ## layers, lengths, citations, format, clang-tidy
	@tools/install_packages.sh build test
	@tools/check_style.sh

clean:
	@rm -rf build out
