"""The public names of this room, each with the file that it comes from."""

from .charts.capture import draw_capture as draw_capture
from .charts.closeness import Closeness as Closeness
from .charts.closeness import draw_closeness as draw_closeness
from .charts.comparison import Ratio as Ratio
from .charts.comparison import draw_comparison as draw_comparison
from .charts.control import draw_control as draw_control
from .charts.gains import Curve as Curve
from .charts.gains import draw_gains as draw_gains
from .charts.ratios import draw_ratios as draw_ratios
from .charts.study import draw_study as draw_study
from .draw import draw as draw
from .film.animation import Film as Film
from .film.animation import animate as animate
from .film.mp4 import require_video as require_video
from .games.game import draw_game as draw_game
from .games.plan import draw_bracket as draw_bracket
from .games.plan import draw_plan as draw_plan
from .games.scenario import draw_scenario as draw_scenario
from .games.snapshots import draw_snapshots as draw_snapshots
from .games.snapshots import times_around_first_capture as times_around_first_capture
from .games.tree import draw_contingent as draw_contingent
from .kit.saving import save as save
