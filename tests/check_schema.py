"""Checks JSON files against a JSON Schema: check_schema.py SCHEMA FILE…; says each fault and ends with 1 if there is one."""

import json
import sys

import jsonschema


def said(fault):
    """What is wrong, without all of what it is wrong in. Where none of several is met, what each of them misses."""
    text = ", or ".join(inner.message for inner in fault.context) or fault.message
    return text if len(text) <= 300 else f"{text[:100]} … {text[-200:]}"


def main(schema_path, paths):
    with open(schema_path, encoding="utf-8") as file:
        schema = json.load(file)
    validator = jsonschema.Draft202012Validator(schema)
    validator.check_schema(schema)
    faults = 0
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for fault in validator.iter_errors(json.load(file)):
                faults += 1
                print(f"{path}: {'.'.join(map(str, fault.path))}: {said(fault)}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
