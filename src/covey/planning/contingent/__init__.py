"""Plans that answer captures: a tree of turns, and what it guarantees.

Read `plan` (what users see), `moment` (a game as a capture leaves it), `search`, then `delays`.
"""

from covey.planning.contingent.delays import DelayedGuarantee as DelayedGuarantee
from covey.planning.contingent.plan import ContingentPlan as ContingentPlan
from covey.planning.contingent.plan import plan_contingent as plan_contingent
