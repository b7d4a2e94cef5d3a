#!/bin/sh
# Validates every shipped scene, and scenes with faults, against the JSON Schema of scenes.
set -u
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
"$SPH" list keys --json-schema >"$work/schema.json" || exit 1
"$SPH" scenes/dambreak.json --write-scene "$work/full.json" || exit 1
/usr/bin/python3 - "$work/schema.json" "$work/full.json" scenes/*.json scenes/*/*.json <<'X'
import copy, json, sys
from jsonschema import Draft202012Validator
schema = json.load(open(sys.argv[1]))
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
count = 0
def result(good, name):
    global count
    count += 1
    print(f"{'ok' if good else 'not ok'} {count} - {name}")
for path in sys.argv[2:]:
    errors = [e.message for e in validator.iter_errors(json.load(open(path)))]
    result(not errors, f"{path.split('/')[-1]} is valid {errors}")
scene = json.load(open("scenes/dambreak.json"))
def refuses(name, change):
    bad = copy.deepcopy(scene)
    change(bad)
    result(not validator.is_valid(bad), "schema refuses " + name)
refuses("an unknown key", lambda s: s.update(gravty=[0, 0, 0]))
refuses("a missing key", lambda s: s["time"].pop("end"))
refuses("a wrong type", lambda s: s.update(title=3))
refuses("a number out of range", lambda s: s["movie"].update(fps=0))
refuses("an unknown word", lambda s: s["solver"].update(method="wscph"))
refuses("no fluids", lambda s: s.update(fluids=[]))
refuses("a key of another shape", lambda s: s["bodies"][0].update(radius=1))
refuses("a body without its size", lambda s: s["bodies"][0].pop("max"))
scene = json.load(open("scenes/dambreak-obstacle.json"))
refuses("a key of another shape of an obstacle", lambda s: s["obstacles"][0].update(height=1))
refuses("an obstacle without its size", lambda s: s["obstacles"][0].pop("min"))
refuses("too many obstacles", lambda s: s.update(obstacles=65 * s["obstacles"]))
refuses("an unknown wall", lambda s: s["domain"].update(walls={"-q": "closed"}))
def described(node, path=""):
    for name, child in node.get("properties", {}).items():
        if "type" in child and child["type"] == "object":
            yield from described(child, path + name + ".")
        elif child.get("type") == "array" and "properties" in child["items"]:
            yield from described(child["items"], path + name + "[].")
        else:
            yield path + name, "description" in child
bare = [name for name, has in described(schema) if not has]
result(not bare, f"every key is described {bare}")
print(f"1..{count}")
X
