"""JSON against the schemas of docs/."""

import json

import jsonschema
from harness import check


def closed(schema):
    """The same schema without room for keys that it does not list."""
    if isinstance(schema, list):
        return [closed(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    made = {key: closed(value) for key, value in schema.items()}
    if isinstance(schema.get("properties"), dict) and schema.get("type") == "object":
        made.setdefault("additionalProperties", False)
    return made


def schema_of(t, name):
    schema = json.loads((t.source / "docs" / f"{name}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema


def follows(data, schema):
    errors = list(jsonschema.Draft202012Validator(schema).iter_errors(data))
    check(not errors, "\n".join(f"{'/'.join(map(str, error.absolute_path))}: {error.message}" for error in errors))
