# The scene format's schema, read by a validator that is not ours: python3 validate.py SCHEMA SCENE...
# One line for each thing that the schema refuses in a scene.
import json
import sys
import tomllib

import jsonschema.validators

with open(sys.argv[1]) as file:
    schema = json.load(file)
validator = jsonschema.validators.validator_for(schema)
validator.check_schema(schema)
for name in sys.argv[2:]:
    with open(name, "rb") as file:
        for error in validator(schema).iter_errors(tomllib.load(file)):
            print(f"{name}: {error.json_path}: {error.message}")
