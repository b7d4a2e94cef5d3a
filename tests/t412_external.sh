#!/bin/sh
# Tests central force, dissipation and buoyancy: exact motion of particles that meet no others.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
cat >"$work/scene.json" <<'EOF'
{ "gravity": [0, 0, 0],
  "domain": {"min": [-1, -1, -1], "max": [1, 1, 1]}, "particles": {"spacing": 0.02},
  "fluids": [{"name": "heavy", "density": 1000, "viscosity": 0}, {"name": "light", "density": 500, "viscosity": 0}],
  "bodies": [{"fluid": "heavy", "shape": "box", "min": [0.4, 0, 0], "max": [0.42, 0.02, 0.02]},
             {"fluid": "light", "shape": "box", "min": [-0.4, 0, 0], "max": [-0.38, 0.02, 0.02]}],
  "time": {"end": 1, "measure": 0.1, "step": 0.001},
  "measure": [{"quantity": "extent", "name": "E"}] }
EOF

# errors COLUMN EXPRESSION ARGUMENTS...: the largest difference to an awk expression of t.
errors() {
    column=$1 expression=$2
    shift 2
    "$SPH" -q "$work/scene.json" "$@" -o "$work/out.csv" >"$work/out" 2>&1 || return 1
    worst=$(awk -F, "/^#/ { next } !name { name = \$0; for (k = 1; k <= NF; k++) if (\$k ~ /$column/) c = k; next }
        { t = \$1; e = \$c - ($expression); e = e < 0 ? -e : e; if (e > m) m = e; n++ }
        END { if (n < 5 || !c) exit 1; print m + 0 }" "$work/out.csv") || return 1
    cat "$work/out.csv" >>"$work/out"
}

check() { # LIMIT WHAT: of the errors found
    awk "BEGIN { exit !($worst <= $1) }"
    result $? "$2: $worst"
}

for solver in wcsph dfsph; do
    worst=9
    errors 'x.max' '0.41 * cos(1.2 * t)' --solver $solver --set central_force.frequency=1.2
    check 1e-3 "$solver: a central force swings a particle, m"
    worst=9
    errors 'x.max' '0.41 + 0.2 * (1 - exp(-2 * t))' --solver $solver --set dissipation=2 \
        --set 'bodies.0.velocity=[0.4, 0, 0]'
    check 1e-3 "$solver: dissipation stops a particle, m"
    # Mean density 750: the lighter of density 500 rises by b g/2, the other falls by b g/4.
    worst=9
    errors 'y.max' '0.01 + 0.5 * 0.5 * 0.2 * t * t' --solver $solver --set 'gravity=[0, -0.2, 0]' \
        --set buoyancy=3
    check 1e-3 "$solver: buoyancy lifts the lighter fluid, m"
    worst=9
    errors 'y.min' '0.01 - 1.75 * 0.5 * 0.2 * t * t' --solver $solver --set 'gravity=[0, -0.2, 0]' \
        --set buoyancy=3
    check 1e-3 "$solver: and presses the heavier one down, m"
done
# One fluid alone feels no buoyancy: the same state as without.
one() {
    "$SPH" -q "$work/one.json" --end 0.1 "$@" -o null --report "$work/report.json" >"$work/out" 2>&1 &&
        jq -r '.frames[-1].state' "$work/report.json"
}
sed 's/, {"name": "light".*}\],/],/; s/"gravity": \[0, 0, 0\]/"gravity": [0, -9.81, 0]/; s/"fluid": "light"/"fluid": "heavy"/' \
    "$work/scene.json" >"$work/one.json"
[ -n "$(one)" ] && [ "$(one)" = "$(one --set buoyancy=3)" ]
result $? "one fluid alone feels no buoyancy"
echo "1..$n"
