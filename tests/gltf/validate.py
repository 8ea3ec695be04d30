#!/usr/bin/env -S python3 -B
"""Asks the Khronos validator about models that `raylab radiosity` writes:   validate.py RAYLAB SCENE ARTEFACTS

Exit code 77: there is no node, or its package cannot be had. A damaged model is asked about, too: a validator that
finds nothing in it would find nothing in the others.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
MESHES = {"uniform": ["--patches", "100"], "hierarchical": ["--patches", "1000", "--tolerance", "0.2"]}


def skip(reason):
    print(f"skipped: models are not validated, since {reason}")
    sys.exit(77)


def fetch_validator(folder):
    if shutil.which("node") is None or shutil.which("npm") is None:
        skip("node and npm are not both installed")
    if (folder / "node_modules/gltf-validator/index.js").exists():
        return
    for name in ("package.json", "package-lock.json"):
        shutil.copy(HERE / name, folder)
    try:
        subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder, check=True, timeout=60,
                       capture_output=True)
    except (OSError, subprocess.SubprocessError) as problem:
        skip(f"`npm ci` failed ({problem})")


def main():
    raylab, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    fetch_validator(folder)
    models = []
    for mesh, options in MESHES.items():
        models.append(folder / f"{mesh}.glb")
        subprocess.run([raylab, "radiosity", scene, "--mesh", mesh, *options, "--gltf", models[-1]], check=True,
                       stdout=subprocess.DEVNULL)
    damaged = folder / "damaged.glb"
    damaged.write_bytes(models[0].read_bytes().replace(b'"VEC3"', b'"VEC2"', 1))
    answer = subprocess.run(["node", HERE / "validate.js", folder / "node_modules", *models, damaged], check=True,
                            capture_output=True, text=True, timeout=60)
    *issues, of_damaged = json.loads(answer.stdout)
    wrong = 0
    for model, found in zip(models, issues):
        print(f"{model.name}: {found['numErrors']} errors, {found['numWarnings']} warnings")
        if found["numErrors"] or found["numWarnings"]:
            wrong += 1
            print(json.dumps(found["messages"], indent=1))
    if not of_damaged["numErrors"]:
        wrong += 1
        print("✗ expected errors in a damaged model, found none")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
