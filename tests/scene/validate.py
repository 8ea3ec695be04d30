# Checks scenes against the scene format's schema by an independent validator: python3 validate.py SCHEMA SCENE...
# It prints one line for each violation of the schema in a scene.
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
