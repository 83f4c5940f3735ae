"""The public names of this room, each with the file that it comes from."""

from .files import instance_names as instance_names
from .files import instance_path as instance_path
from .instance import Instance as Instance
from .instance import KnownBracket as KnownBracket
from .instance import KnownPlan as KnownPlan
from .load import load_instance as load_instance
from .scores import Score as Score
from .scores import score as score
