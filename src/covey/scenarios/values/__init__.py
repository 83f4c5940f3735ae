"""What a value of a file may be: `value_types` is the mechanism, `kinds` are the types by name.

`angles` reads angles from texts, `one_or_many` a value or a list of values.
"""
