# Everything runs in .venv. The first target that needs it sets it up. You need Python 3.11+ and make.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DEMO := fixtures/cases/demo/prog.py

# Tests and checks start many processes; without bytecode each would compile all that it imports.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test tests fuzz lint types golden docs bench clean

$(VENV)/ready: pyproject.toml scripts/dev_requirements.py
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "clickgen needs Python 3.11 or newer; name one with make PYTHON=python3.12"; exit 1; }
	$(PYTHON) -m venv $(VENV)
	$(PYTHON) scripts/dev_requirements.py > $(VENV)/dev-requirements.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e . -r $(VENV)/dev-requirements.txt
	@touch $@

demo: $(VENV)/ready  ## build the demo program and show its listing
	@mkdir -p build/demo-source
	@cp fixtures/cases/demo/prog.py build/demo-source/demo.py
	@$(BIN)/clickgen build build/demo-source/demo.py -o build/demo
	@echo
	@echo "The listing begins:"
	@sed -n '1,40p' build/demo/listing.txt

test: $(VENV)/ready  ## run all checks and tests
	@$(MAKE) --no-print-directory -j 3 lint types tests

tests: $(VENV)/ready
	$(BIN)/python -m pytest -q -n auto --dist worksteal

fuzz: $(VENV)/ready  ## run the properties on many new examples; FUZZ="--minutes 60" repeats it for an hour
	$(BIN)/python tests/fuzz.py $(FUZZ)

lint: $(VENV)/ready
	$(BIN)/ruff check
	$(BIN)/ruff format --check

types: $(VENV)/ready
	$(BIN)/mypy

golden: $(VENV)/ready  ## rewrite the golden files; read the diff before you commit it
	$(BIN)/python scripts/golden.py

docs: $(VENV)/ready  ## write the parts of the documentation and of clickgen.dsl that come from the code
	$(BIN)/python scripts/docs.py
	$(BIN)/python scripts/dsl_stub.py

bench: $(VENV)/ready  ## measure ratios and growth in one run
	$(BIN)/python scripts/bench.py

clean:
	rm -rf build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
