"""scenes/scene.schema.json against an independent validator: it takes every shipped scene and refuses what the reader
refuses (malformed.json, which scene_reader_test.cpp reads as well). Usage: schema_test.py SCENES"""

import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

scenes = pathlib.Path(sys.argv[1])
schema = json.loads((scenes / "scene.schema.json").read_text(encoding="utf-8"))
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)

failures = []
shipped = [path for path in sorted(scenes.rglob("*.json")) if not path.name.endswith(".schema.json")]
for path in shipped:
    for error in validator.iter_errors(json.loads(path.read_text(encoding="utf-8"))):
        failures.append(f"{path.name}: {error.message}")

malformed = json.loads((pathlib.Path(__file__).parent / "malformed.json").read_text(encoding="utf-8"))
for case in malformed:
    if validator.is_valid(case["scene"]):
        failures.append(f"accepted, although wrong at {case['where']}: {json.dumps(case['scene'])}")

print("\n".join(failures) or f"{len(shipped)} scenes accepted, {len(malformed)} malformed ones refused")
sys.exit(1 if failures or not shipped or not malformed else 0)
