# sph-render: options first, then flags, then targets.
# Each option is detected and can be set: make EGL=0 OSMESA=0 LIBAV=0 CAIRO=0 MUPARSER=0 CUDA=0 MPI=0
# V=1 shows whole commands; WERROR=-Werror makes warnings errors.

ifeq ($(origin CC),default)
CC       := gcc
endif
BUILD    ?= build
PREFIX   ?= /usr/local
OPT      ?= -O2 -g
WERROR   ?=
JOBS     ?= $(shell nproc 2>/dev/null || echo 1)
V        ?= 0
quiet    = $(if $(filter 0,$(V)),@echo '  $(1)' &&)

have      = $(shell pkg-config --exists $(1) 2>/dev/null && echo 1 || echo 0)
EGL      ?= $(call have,egl gl)
OSMESA   ?= $(call have,osmesa)
LIBAV    ?= $(call have,libavformat libavcodec libswscale libavutil)
CAIRO    ?= $(call have,cairo)
MUPARSER ?= $(call have,muparser)
NVCC     ?= $(firstword $(wildcard /usr/local/cuda/bin/nvcc) $(shell command -v nvcc 2>/dev/null))
CUDA     ?= $(if $(NVCC),1,0)
MPICC    ?= $(shell command -v mpicc 2>/dev/null)
MPI      ?= $(if $(MPICC),1,0)

OPTIONS       := EGL OSMESA LIBAV CAIRO MUPARSER CUDA
EGL_doc       := draws on a GPU or by Mesa software without a screen
EGL_needs     := libegl-dev libgl-dev
OSMESA_doc    := draws by Mesa software into memory
OSMESA_needs  := libosmesa6-dev
LIBAV_doc     := writes films: mp4, webm, mkv, gif, apng, y4m
LIBAV_needs   := libavformat-dev libavcodec-dev libswscale-dev libavutil-dev
CAIRO_doc     := writes colour bar, title and time over frames; pdf, svg
CAIRO_needs   := libcairo2-dev
MUPARSER_doc   := understands formulas in studies
MUPARSER_needs := libmuparser-dev
CUDA_doc      := computes on GPUs of NVIDIA
CUDA_needs    := the CUDA toolkit, 12.4 or later (NVCC=/path/to/nvcc)

VERSION  := 0.1.0
PACKAGES := libpng $(if $(filter 1,$(CAIRO)),cairo) $(if $(filter 1,$(MUPARSER)),muparser) $(if $(filter 1,$(LIBAV)),libavformat libavcodec libswscale libavutil)
DEFINES  := -DSPH_VERSION='"$(VERSION)"' $(foreach o,$(OPTIONS),-DHAVE_$(o)=$($(o)))
OPENMP   := -fopenmp
# Same bits on every target: no contraction of a*b+c, no reassociation, IEEE square root and division.
SAFE     := -ffp-contract=off -fno-math-errno -fno-trapping-math
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes $(WERROR)
CFLAGS_  := -std=c11 -D_GNU_SOURCE $(OPT) $(WARN) $(SAFE) $(OPENMP) -Isrc -I$(BUILD)/gen $(DEFINES) \
            $(shell pkg-config --cflags $(PACKAGES) 2>/dev/null) $(CFLAGS)
LIBS     := $(shell pkg-config --libs $(PACKAGES) 2>/dev/null) -ldl -lm -lpthread

# The toolkit that nvcc belongs to; machine code for GPUs that it knows, and PTX for later ones. The runtime
# is linked in, and finds the driver when it is first used, if there is one.
ifeq ($(CUDA),1)
CUDA_ROOT  := $(patsubst %/bin/nvcc,%,$(realpath $(NVCC)))
CUDA_KNOWN := $(shell $(NVCC) --list-gpu-code 2>/dev/null | sed 's/sm_//')
CUDA_ARCHS ?= $(filter $(CUDA_KNOWN),75 80 86 90)
NVCCFLAGS  := -std=c++20 -O3 --fmad=false -lineinfo -Isrc -DHAVE_EGL=$(EGL) $(if $(filter clang,$(CC)),,-ccbin g++) \
              $(foreach a,$(CUDA_ARCHS),-gencode arch=compute_$(a),code=sm_$(a)) \
              -gencode arch=compute_$(lastword $(CUDA_ARCHS)),code=compute_$(lastword $(CUDA_ARCHS))
CUDA_LIB   := $(firstword $(wildcard $(CUDA_ROOT)/lib64/libcudart_static.a \
              $(CUDA_ROOT)/targets/*/lib/libcudart_static.a))
LIBS       += $(or $(CUDA_LIB),-lcudart_static) -lrt -ldl -lpthread -lstdc++
endif

SOURCES  := $(sort $(shell find src -name '*.c'))
SOURCES_CU := $(if $(filter 1,$(CUDA)),$(sort $(shell find src -name '*.cu')))
OBJECTS  := $(SOURCES:%.c=$(BUILD)/%.o) $(SOURCES_CU:%.cu=$(BUILD)/%.cu.o)
LIBRARY  := $(BUILD)/libsph-render.a
PROGRAM  := $(BUILD)/sph-render
SHADERS  := $(wildcard shaders/*)
SHADER_H := $(SHADERS:shaders/%=$(BUILD)/gen/shaders/%.h)
TESTS_C  := $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/t*.c))

.PHONY: all movie test run-tests validate study bench test-gpu bench-gpu info install clean FORCE
.SECONDARY: $(SHADER_H)
all: $(PROGRAM)

$(PROGRAM): $(BUILD)/src/main.o $(LIBRARY)
	$(call quiet,LINK $@) $(CC) $(CFLAGS_) $(LDFLAGS) -o $@ $^ $(LIBS)

$(LIBRARY): $(filter-out $(BUILD)/src/main.o,$(OBJECTS))
	@rm -f $@
	$(call quiet,AR   $@) ar rcs $@ $^

$(BUILD)/src/backend/cpu/isa_avx2.o:   ISA := -mavx2 -mfma
$(BUILD)/src/backend/cpu/isa_avx512.o: ISA := -mavx512f -mavx512dq -mavx512vl -mavx512bw -mavx2 -mfma -mprefer-vector-width=512

# The cpu renderer's loops are plain C that the compiler makes vectors of.
$(BUILD)/src/render/splat_scalar.o: ISA := -O3
$(BUILD)/src/render/splat_avx2.o:   ISA := -O3 -mavx2
$(BUILD)/src/render/splat_avx512.o: ISA := -O3 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mprefer-vector-width=512

# Flags are part of every object: a change of options rebuilds.
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(subst ','\'',$(CFLAGS_)) $(NVCCFLAGS)' | cmp -s - $@ || \
	    echo '$(CC) $(subst ','\'',$(CFLAGS_)) $(NVCCFLAGS)' > $@
FORCE:

$(BUILD)/%.o: %.c $(BUILD)/flags | $(SHADER_H)
	@mkdir -p $(@D)
	$(call quiet,CC   $<) $(CC) $(CFLAGS_) $(ISA) -MMD -MP -c -o $@ $<

$(BUILD)/%.cu.o: %.cu $(BUILD)/flags
	@mkdir -p $(@D)
	$(call quiet,NVCC $<) $(NVCC) $(NVCCFLAGS) -MMD -MF $(@:.o=.d) -c -o $@ $<

# A shader becomes a C string: #include "shaders/NAME.h" as an initializer.
$(BUILD)/gen/shaders/%.h: shaders/%
	@mkdir -p $(@D)
	@sed 's/\\/\\\\/g; s/"/\\"/g; s/^/"/; s/$$/\\n"/' $< > $@

$(BUILD)/tests/%: tests/%.c $(LIBRARY)
	@mkdir -p $(@D)
	$(call quiet,CC   $<) $(CC) $(CFLAGS_) -Itests -MMD -MP -o $@ $< $(LIBRARY) $(LIBS) -lcmocka $(LDFLAGS)

# The .cu files on a model of a GPU, for tests without one; its objects come before the library's.
MODEL_CU   := $(sort $(shell find src -name '*.cu')) $(sort $(wildcard tests/gpu_model/*.cpp))
MODEL_O    := $(patsubst %,$(BUILD)/model/%.o,$(MODEL_CU))
MODEL_FLAGS := -std=c++20 -O1 -g -ffp-contract=off -Itests/gpu_model -Isrc -DHAVE_EGL=$(EGL) -x c++ -include cuda_runtime.h
MODEL_TESTS := $(BUILD)/tests/t444_gpu_model $(BUILD)/tests/t445_model_frames
$(BUILD)/model/%.o: % $(BUILD)/flags
	@mkdir -p $(@D)
	$(call quiet,CXX  $<) g++ $(MODEL_FLAGS) -MMD -MP -c -o $@ $<
$(MODEL_TESTS): $(BUILD)/tests/%: tests/%.c $(MODEL_O) $(LIBRARY)
	@mkdir -p $(@D)
	$(call quiet,CC   $<) $(CC) $(CFLAGS_) -Itests -MMD -MP -o $@ $< $(MODEL_O) $(LIBRARY) $(LIBS) -lcmocka -lstdc++ $(LDFLAGS)

# The program on the model, for the scripts of test-gpu and bench-gpu.
$(BUILD)/model/sph-render: $(BUILD)/src/main.o $(MODEL_O) $(LIBRARY)
	$(call quiet,LINK $@) $(CC) $(CFLAGS_) -o $@ $^ $(LIBS) -lstdc++ $(LDFLAGS)

# The same with kernels that ThreadSanitizer watches.
RACES_CU := $(filter %kernels_cuda.cu %fibers.cpp,$(MODEL_CU))
RACES_O  := $(patsubst %,$(BUILD)/races/%.o,$(RACES_CU))
$(BUILD)/races/%.o: % $(BUILD)/flags
	@mkdir -p $(@D)
	$(call quiet,CXX  $< (races)) g++ $(MODEL_FLAGS) -DMODEL_RACES $(if $(filter %.cu,$<),-fsanitize=thread) \
	    -MMD -MP -c -o $@ $<
$(BUILD)/races/sph-render: $(BUILD)/src/main.o $(RACES_O) $(filter-out $(RACES_CU:%=$(BUILD)/model/%.o),$(MODEL_O)) $(LIBRARY)
	$(call quiet,LINK $@) g++ -fsanitize=thread -fopenmp -o $@ $^ $(LIBS) $(LDFLAGS)

# Detection happens when the Makefile is read, so a make of its own follows the installation.
parallel  = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(JOBS))
movie:
	@tools/install-deps
	@$(MAKE) --no-print-directory $(parallel) all
	@mkdir -p out
	$(PROGRAM) scenes/dambreak.json -o out/dambreak.mp4

test:
	@tools/install-deps test
	@$(MAKE) --no-print-directory $(parallel) run-tests
# ThreadSanitizer's program is gcc's; without CUDA an earlier build's are not to be tested.
MODEL_PROGRAMS := $(if $(filter 1,$(CUDA)),$(BUILD)/model/sph-render $(if $(findstring clang,$(CC)),,$(BUILD)/races/sph-render))
run-tests: all $(TESTS_C) $(MODEL_PROGRAMS)
	@rm -f $(filter-out $(MODEL_PROGRAMS),$(BUILD)/model/sph-render $(BUILD)/races/sph-render)
	@BUILD=$(BUILD) CC='$(CC)' tests/run

validate: all
	@mkdir -p out
	$(PROGRAM) study studies/validation/*.json -o out/validation

# The figures and tables of the README, within half an hour on two quiet cores; what this build has
# left in out/ is not run again.
study: all
	@tools/install-deps study
	@mkdir -p out
	$(PROGRAM) study studies/validation/*.json -o out/validation --budget 13m
	$(PROGRAM) study studies/settings/*.json -o out/settings --budget 6m
	$(PROGRAM) study studies/seeds/*.json -o out/seeds --budget 4m
	$(PROGRAM) study studies/bench/dambreak.json -o out/bench --budget 1m
	$(PROGRAM) study --stability studies/stability/*.json -o out/stability --budget 5m
	@tools/readme-figures

bench: all
	$(PROGRAM) bench scenes/bench/*.json scenes/seeds/*.json

# On a machine with a GPU; results are in out/gpu.
test-gpu: all
	@mkdir -p out/gpu
	@$(MAKE) --no-print-directory $(BUILD)/tests/t442_device || echo "without cmocka: t442_device is left out"
	@BUILD=$(BUILD) sh tests/gpu-states.sh | tee out/gpu/test.txt
	@awk '/^ok /{p++} /^not ok /{f++} /^1\.\./{whole=1} END{if (!whole || !p) f++; \
	    print p + 0 " passed, " f + 0 " failed"; exit f > 0}' out/gpu/test.txt
bench-gpu: all
	@BUILD=$(BUILD) sh tests/gpu-bench.sh

info:
	@echo "sph-render $(VERSION)"
	@echo "compiler   $(CC): $$($(CC) --version | head -n 1)"
	@echo "also       $$(command -v clang gcc nvcc mpicc | tr '\n' ' ')"
	@echo "flags      $(CFLAGS_)"
	@echo "back ends  cpu (scalar, AVX2, AVX-512: the best that the processor has)$(if $(filter 1,$(CUDA)), cuda)"
	@$(foreach o,$(OPTIONS),echo "$(o)=$($(o))  $($(o)_doc)$(if $(filter 0,$($(o))),: not built in; needs $($(o)_needs))";)
	$(if $(filter 1,$(CUDA)),@echo "GPUs       $(foreach a,$(CUDA_ARCHS),sm_$(a)) and PTX (by $(NVCC))")
	@echo "MPI=$(MPI)  $(if $(MPICC),$(MPICC) found,no mpicc found); the program has no MPI code yet"

install: all
	install -D -m 755 $(PROGRAM) $(DESTDIR)$(PREFIX)/bin/sph-render
	mkdir -p $(DESTDIR)$(PREFIX)/share/sph-render && cp -r scenes $(DESTDIR)$(PREFIX)/share/sph-render/

clean:
	rm -rf $(BUILD) out

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
