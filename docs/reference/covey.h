/* The entries of covey's compiled kernels.

   An entry takes a pointer to its words, eight bytes each, and a pointer to its results. It
   returns 0; anything else is a defect. An array is contiguous; behind its address stand its
   dimensions. A record is its fields, one after the other. The caller owns all memory. An entry
   writes to its results and to the arrays that it modifies in place, and keeps no pointer. It may
   run in several threads at a time if they share no array that is modified. Angles are radians;
   lengths and times are in any consistent unit. Truth values are 0 or 1.

   Written by `python -m covey.kernels.builder.header`. */

#include <stdint.h>

/* Add `weight` times the Hessian of the objective to the lower triangle of `hessian`.

   The Hessian is Z' (∇² of Σ μ_k * equation k) Z, with Z the derivatives of times and turns by the
   turns. For each capture, in order:

   1. `now`: the derivatives of T_k, by the chain rule from those of T_{k-1}.
   2. The distance |P_k - P_{k-1}| curves with the square of what moves across n_k.
   3. The evader's own path curves: in time on the arc; in time and turn on the straight part.

   Parameters
   ----------
   paths, pursuit, sequence
       As for `differentiate`, (n, PATH) and (n,).
   captures
       As `differentiate` left them; `slopes` modified in place.
   weight
       Of this sequence.
   hessian
       (n, n) or more, time per radian squared; its lower triangle is modified in place. */
struct covey_add_curvature_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t *sequence; int64_t sequence_0;
    double *captures_times; int64_t captures_times_0; /* (n,) or more */
    double *captures_rows; int64_t captures_rows_0, captures_rows_1; /* (n, CAPTURE_ROW) or more */
    double *captures_slopes; int64_t captures_slopes_0, captures_slopes_1; /* (3, n) or more: derivatives of T_{k-1} and T_k, and of the distance across n_k */
    double weight;
    double *hessian; int64_t hessian_0, hessian_1;
};
int64_t covey_add_curvature(const struct covey_add_curvature_words *words, void *results);

/* Write the paths of the announced turns to `state.paths`. */
struct covey_announce_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
};
int64_t covey_announce(const struct covey_announce_words *words, void *results);

/* Ascend to a local maximum of the minimum over all capture sequences.

   Parameters
   ----------
   problem
       The evaders (n) and the pursuit; the objective is the last capture.
   tree
       Of n evaders; its turns are modified in place.
   options
       First radius of the trust region, tolerance, largest number of steps.
   branches
       The working set, which may be empty; modified in place.
   scratch
       For trees of this size; modified in place.
   workspace
       With room for n evaders; modified in place. Its flag ends the ascent early.

   Returns
   -------
   tuple of float, int, int, int
       The exact value, which is never below that of the given turns; CONVERGED, STALLED or
       STEPS_USED_UP; steps; interceptions. */
struct covey_ascend_tree_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *tree_turns; int64_t tree_turns_0; /* (sizes[0],) signed turns, radians in [-π, π] */
    int64_t tree_depth; /* 0: the turns of an open-loop plan; at most n - 1 */
    int64_t *tree_sizes; int64_t tree_sizes_0; /* (n + 1,) turns in a subtree after k captures */
    double options_radius; /* of the first trust region: the largest first change of a turn, radians */
    double options_tolerance; /* a predicted gain below this, relative to the value, ends the ascent */
    int64_t options_max_steps;
    int64_t *branches_used; int64_t branches_used_0; /* (1,) how many rows are in use */
    int64_t *branches_sequences; int64_t branches_sequences_0, branches_sequences_1; /* (m, n) */
    double *branches_weights; int64_t branches_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *branches_values; int64_t branches_values_0; /* (m,) objective of each sequence where the last ascent ended */
    double *scratch_branch_times; int64_t scratch_branch_times_0; /* (n,) capture times */
    double *scratch_branch_evaders; int64_t scratch_branch_evaders_0, scratch_branch_evaders_1; /* (n, EVADER) where the present segment began */
    double *scratch_branch_turns; int64_t scratch_branch_turns_0; /* (n,) of the present segment */
    double *scratch_branch_paths; int64_t scratch_branch_paths_0, scratch_branch_paths_1; /* (n, PATH) of the present segment */
    double *scratch_branch_segments; int64_t scratch_branch_segments_0, scratch_branch_segments_1; /* (n * n, SEGMENT) row j * n + k: segment k of the j-th captured evader */
    int64_t *scratch_branch_variables; int64_t scratch_branch_variables_0, scratch_branch_variables_1; /* (n, n) entry (j, k): which turn of the tree segment k of evader j has */
    double *scratch_derivatives_captures; int64_t scratch_derivatives_captures_0, scratch_derivatives_captures_1; /* (n, CAPTURE) */
    double *scratch_derivatives_controls; int64_t scratch_derivatives_controls_0, scratch_derivatives_controls_1; /* (n * n, CONTROL) row j * n + k: segment k of the j-th captured evader */
    double *scratch_derivatives_gradient; int64_t scratch_derivatives_gradient_0; /* (p,) time per radian */
    int64_t *scratch_derivatives_variables; int64_t scratch_derivatives_variables_0; /* (p,) numbers of the turns in the tree */
    double *scratch_derivatives_hessian; int64_t scratch_derivatives_hessian_0, scratch_derivatives_hessian_1; /* (p, p) lower triangle, time per radian squared */
    double *scratch_derivatives_durations; int64_t scratch_derivatives_durations_0, scratch_derivatives_durations_1; /* (n, p) derivatives of the durations */
    double *scratch_derivatives_positions; int64_t scratch_derivatives_positions_0, scratch_derivatives_positions_1; /* (4, p) derivatives of P_k and P_{k-1} */
    double *scratch_derivatives_rows; int64_t scratch_derivatives_rows_0, scratch_derivatives_rows_1; /* (4, p) scratch */
    double *scratch_levels_evaders; int64_t scratch_levels_evaders_0, scratch_levels_evaders_1; /* (n * n, EVADER) row level * n + rank */
    double *scratch_levels_paths; int64_t scratch_levels_paths_0, scratch_levels_paths_1; /* (n * n, PATH) */
    int64_t *scratch_levels_numbers; int64_t scratch_levels_numbers_0, scratch_levels_numbers_1; /* (n, n) the evaders' numbers, ascending */
    double *scratch_levels_disks; int64_t scratch_levels_disks_0, scratch_levels_disks_1; /* (n, 4) */
    int64_t *scratch_levels_counters; int64_t scratch_levels_counters_0, scratch_levels_counters_1; /* (n, 2) */
    int64_t *scratch_levels_sequence; int64_t scratch_levels_sequence_0; /* (n,) evaders captured so far */
    int64_t *scratch_sequence; int64_t scratch_sequence_0; /* (n,) the worst sequence */
    double *scratch_here; int64_t scratch_here_0; /* (m,) last capture of each branch at the iterate */
    double *scratch_there; int64_t scratch_there_0; /* (m,) the same at the trial */
    double *scratch_gradients; int64_t scratch_gradients_0, scratch_gradients_1; /* (m, p) of each branch */
    int64_t *scratch_turns_of; int64_t scratch_turns_of_0, scratch_turns_of_1; /* (m, p) which turns a branch depends on */
    int64_t *scratch_lengths; int64_t scratch_lengths_0; /* (m,) how many */
    int64_t *scratch_places; int64_t scratch_places_0; /* (turns of the tree,) places among the variables, -1: none */
    int64_t *scratch_variables; int64_t scratch_variables_0; /* (r,) turns that some branch depends on */
    double *scratch_iterate; int64_t scratch_iterate_0; /* (r,) their values */
    double *scratch_trial; int64_t scratch_trial_0; /* (turns of the tree,) */
    double *scratch_first_trial; int64_t scratch_first_trial_0; /* (turns of the tree,) before its correction */
    double *scratch_model_gradients; int64_t scratch_model_gradients_0, scratch_model_gradients_1; /* (m, n) */
    double *scratch_model_weights; int64_t scratch_model_weights_0; /* (m,) multipliers in the Hessian */
    double *scratch_model_capture_rows; int64_t scratch_model_capture_rows_0, scratch_model_capture_rows_1; /* (n, CAPTURE_ROW) or more columns */
    double *scratch_model_slopes; int64_t scratch_model_slopes_0, scratch_model_slopes_1; /* (3, n) */
    double *scratch_model_hessian; int64_t scratch_model_hessian_0, scratch_model_hessian_1; /* (n, n) of the Lagrangian, sign turned; lower triangle */
    double *scratch_model_convex_hessian; int64_t scratch_model_convex_hessian_0, scratch_model_convex_hessian_1; /* (n, n) made positive definite for the quadratic programme */
    double *scratch_model_factor; int64_t scratch_model_factor_0, scratch_model_factor_1; /* (n, n) */
    double *scratch_model_eigenvectors; int64_t scratch_model_eigenvectors_0, scratch_model_eigenvectors_1; /* (n, n) */
    double *scratch_model_eigenvalues; int64_t scratch_model_eigenvalues_0; /* (n,) */
    double *scratch_model_linear; int64_t scratch_model_linear_0; /* (n,) linear term of the penalty */
    double *scratch_model_lower; int64_t scratch_model_lower_0; /* (n,) bounds of the step */
    double *scratch_model_upper; int64_t scratch_model_upper_0; /* (n,) */
    double *scratch_model_step; int64_t scratch_model_step_0; /* (n,) the maximiser */
    double *scratch_model_values; int64_t scratch_model_values_0; /* (m,) */
    double *scratch_model_quadratic_whitened; int64_t scratch_model_quadratic_whitened_0, scratch_model_quadratic_whitened_1; /* (m + 2n, n) L^-1 a_j for each constraint j */
    int64_t *scratch_model_quadratic_active; int64_t scratch_model_quadratic_active_0; /* (n + 2,) */
    double *scratch_model_quadratic_multipliers; int64_t scratch_model_quadratic_multipliers_0; /* (n + 2,) of the active constraints */
    double *scratch_model_quadratic_gram; int64_t scratch_model_quadratic_gram_0, scratch_model_quadratic_gram_1; /* (n + 2, n + 2) their products, then its Cholesky factor */
    double *scratch_model_quadratic_ones; int64_t scratch_model_quadratic_ones_0; /* (n + 2,) */
    double *scratch_model_quadratic_direction; int64_t scratch_model_quadratic_direction_0; /* (n + 2,) */
    double *scratch_model_quadratic_combined; int64_t scratch_model_quadratic_combined_0; /* (n,) sum of multipliers times whitened */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_ascend_tree_results {
    double value_0;
    int64_t value_1;
    int64_t value_2;
    int64_t value_3;
};
int64_t covey_ascend_tree(const struct covey_ascend_tree_words *words, struct covey_ascend_tree_results *results);

/* Write the gradient of the last capture; return its length p.

   Parameters
   ----------
   pursuit
       The pursuer.
   depth
       Of the tree.
   n
       Number of captures.
   branch
       As `fly_branch` left it.
   derivatives
       `captures`, `controls`, `gradient` and `variables` are modified in place. */
struct covey_branch_gradient_words {
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t depth;
    int64_t n;
    double *branch_times; int64_t branch_times_0; /* (n,) capture times */
    double *branch_evaders; int64_t branch_evaders_0, branch_evaders_1; /* (n, EVADER) where the present segment began */
    double *branch_turns; int64_t branch_turns_0; /* (n,) of the present segment */
    double *branch_paths; int64_t branch_paths_0, branch_paths_1; /* (n, PATH) of the present segment */
    double *branch_segments; int64_t branch_segments_0, branch_segments_1; /* (n * n, SEGMENT) row j * n + k: segment k of the j-th captured evader */
    int64_t *branch_variables; int64_t branch_variables_0, branch_variables_1; /* (n, n) entry (j, k): which turn of the tree segment k of evader j has */
    double *derivatives_captures; int64_t derivatives_captures_0, derivatives_captures_1; /* (n, CAPTURE) */
    double *derivatives_controls; int64_t derivatives_controls_0, derivatives_controls_1; /* (n * n, CONTROL) row j * n + k: segment k of the j-th captured evader */
    double *derivatives_gradient; int64_t derivatives_gradient_0; /* (p,) time per radian */
    int64_t *derivatives_variables; int64_t derivatives_variables_0; /* (p,) numbers of the turns in the tree */
    double *derivatives_hessian; int64_t derivatives_hessian_0, derivatives_hessian_1; /* (p, p) lower triangle, time per radian squared */
    double *derivatives_durations; int64_t derivatives_durations_0, derivatives_durations_1; /* (n, p) derivatives of the durations */
    double *derivatives_positions; int64_t derivatives_positions_0, derivatives_positions_1; /* (4, p) derivatives of P_k and P_{k-1} */
    double *derivatives_rows; int64_t derivatives_rows_0, derivatives_rows_1; /* (4, p) scratch */
};
struct covey_branch_gradient_results {
    int64_t value_0;
};
int64_t covey_branch_gradient(const struct covey_branch_gradient_words *words, struct covey_branch_gradient_results *results);

/* Write the Hessian of the last capture to the lower triangle of `derivatives.hessian`.

   Parameters are those of `branch_gradient`, which must have been called before.

   For each capture, in order: the derivatives of the duration and of the capture's position; the
   curvature of the distance across n_k; the curvature of the evader's own path. */
struct covey_branch_hessian_words {
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t depth;
    int64_t n;
    double *branch_times; int64_t branch_times_0; /* (n,) capture times */
    double *branch_evaders; int64_t branch_evaders_0, branch_evaders_1; /* (n, EVADER) where the present segment began */
    double *branch_turns; int64_t branch_turns_0; /* (n,) of the present segment */
    double *branch_paths; int64_t branch_paths_0, branch_paths_1; /* (n, PATH) of the present segment */
    double *branch_segments; int64_t branch_segments_0, branch_segments_1; /* (n * n, SEGMENT) row j * n + k: segment k of the j-th captured evader */
    int64_t *branch_variables; int64_t branch_variables_0, branch_variables_1; /* (n, n) entry (j, k): which turn of the tree segment k of evader j has */
    double *derivatives_captures; int64_t derivatives_captures_0, derivatives_captures_1; /* (n, CAPTURE) */
    double *derivatives_controls; int64_t derivatives_controls_0, derivatives_controls_1; /* (n * n, CONTROL) row j * n + k: segment k of the j-th captured evader */
    double *derivatives_gradient; int64_t derivatives_gradient_0; /* (p,) time per radian */
    int64_t *derivatives_variables; int64_t derivatives_variables_0; /* (p,) numbers of the turns in the tree */
    double *derivatives_hessian; int64_t derivatives_hessian_0, derivatives_hessian_1; /* (p, p) lower triangle, time per radian squared */
    double *derivatives_durations; int64_t derivatives_durations_0, derivatives_durations_1; /* (n, p) derivatives of the durations */
    double *derivatives_positions; int64_t derivatives_positions_0, derivatives_positions_1; /* (4, p) derivatives of P_k and P_{k-1} */
    double *derivatives_rows; int64_t derivatives_rows_0, derivatives_rows_1; /* (4, p) scratch */
};
int64_t covey_branch_hessian(const struct covey_branch_hessian_words *words, void *results);

/* Algorithm 1: write the capture times in the order of `sequence`; return the last time.

   Parameters
   ----------
   paths
       (n, PATH).
   pursuit
       The pursuer.
   sequence
       (m,) numbers of evaders, each at most once.
   times
       (m,) modified in place. */
struct covey_capture_times_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t *sequence; int64_t sequence_0;
    double *times; int64_t times_0;
};
struct covey_capture_times_results {
    double value_0;
};
int64_t covey_capture_times(const struct covey_capture_times_words *words, struct covey_capture_times_results *results);

/* Raise the mean over the orders by better headings until the first capture; return it.

   The mean is quasi-convex in all velocities together, so all evaders turn to where the gradient
   points.

   Parameters
   ----------
   mixture
       The orders and their weights.
   headings
       (n,) radians, by evader, until the first capture; modified in place.
   values
       (m,) last captures at these headings, by order; modified in place.
   scratch
       Modified in place; has the gradients at these headings. */
struct covey_climb_mixture_words {
    double *mixture_evaders; int64_t mixture_evaders_0, mixture_evaders_1; /* (n, EVADER); the first one is captured first */
    double mixture_pursuit_center_x;
    double mixture_pursuit_center_y;
    double mixture_pursuit_first_radius;
    double mixture_pursuit_later_radius;
    double mixture_pursuit_speed;
    int64_t *mixture_orders; int64_t mixture_orders_0, mixture_orders_1; /* (m, n - 1) of the evaders 1 to n - 1 */
    double *mixture_weights; int64_t mixture_weights_0; /* (m,) >= 0, summing to one */
    double *headings; int64_t headings_0;
    double *values; int64_t values_0;
    double *scratch_directions; int64_t scratch_directions_0; /* (n,) until the first capture */
    double *scratch_stretches; int64_t scratch_stretches_0; /* (n,) speed until then, over the evader's own */
    double *scratch_departed; int64_t scratch_departed_0, scratch_departed_1; /* (n, EVADER) where what is known of the flights ends */
    double *scratch_departures; int64_t scratch_departures_0; /* (n,) and when */
    double *scratch_here; int64_t scratch_here_0, scratch_here_1; /* (n, EVADER) at the first capture */
    double *scratch_headings; int64_t scratch_headings_0, scratch_headings_1; /* (m, n) after it, by order */
    double *scratch_flights; int64_t scratch_flights_0, scratch_flights_1; /* (n, FLIGHT) */
    double *scratch_gradients; int64_t scratch_gradients_0, scratch_gradients_1, scratch_gradients_2; /* (m, n, 2) of the last capture by the positions at the first one */
    double *scratch_programme_corners; int64_t scratch_programme_corners_0, scratch_programme_corners_1; /* (c, CORNER) */
    double *scratch_programme_states; int64_t scratch_programme_states_0, scratch_programme_states_1, scratch_programme_states_2; /* (n, c, STATE) of the captures before each slot */
    int64_t *scratch_programme_predecessor; int64_t scratch_programme_predecessor_0, scratch_programme_predecessor_1; /* (n, c) the corner of the evader before, with which a state is attained */
    double *scratch_programme_attained; int64_t scratch_programme_attained_0; /* (n,) headings that attain the bound, by evader */
};
struct covey_climb_mixture_results {
    double value_0;
};
int64_t covey_climb_mixture(const struct covey_climb_mixture_words *words, struct covey_climb_mixture_results *results);

/* Replace the pursuer's sequence where another sequence is better by more than the margin.

   Better is an earlier last capture or, with `total`, a smaller sum of capture times. The margin
   is relative to what the present sequence still comes to. A pursuer without a sequence takes the
   best. Moves change the sequence against a team that is too large for an exact minimum at every
   update. `paths` (n, PATH) are those of the living. */
struct covey_commit_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t total;
    double commitment_margin; /* relative gain for which it changes the sequence; inf: never */
    int64_t *commitment_sequence; int64_t commitment_sequence_0; /* (N,) rows of the living; modified in place */
    int64_t commitment_is_chosen; /* False: it begins with the best sequence, and `sequence` holds nothing */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
int64_t covey_commit(const struct covey_commit_words *words, void *results);

/* Write the gradient of the last capture, or of the sum, by every evader's turn.

   1. Forward: the geometry of each capture. An evader that is in the disk when it is due is
      captured at that instant: T_k = T_{k-1}, which is the equation above with n_k = 0. While an
      evader turns, its position doesn't depend on the turn's final angle.
   2. Backward: the multipliers, the costates ∂L/∂P_k, and from them the gradient.

   Parameters
   ----------
   paths
       (n, PATH).
   pursuit
       The pursuer.
   sequence
       (n,) the order of capture.
   total
       Whether the objective is the sum of all capture times.
   captures
       `times` as Algorithm 1 writes them; `rows` modified in place.
   gradient
       (n,) by evader, time per radian; modified in place. */
struct covey_differentiate_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t *sequence; int64_t sequence_0;
    int64_t total;
    double *captures_times; int64_t captures_times_0; /* (n,) or more */
    double *captures_rows; int64_t captures_rows_0, captures_rows_1; /* (n, CAPTURE_ROW) or more */
    double *captures_slopes; int64_t captures_slopes_0, captures_slopes_1; /* (3, n) or more: derivatives of T_{k-1} and T_k, and of the distance across n_k */
    double *gradient; int64_t gradient_0;
};
int64_t covey_differentiate(const struct covey_differentiate_words *words, void *results);

/* Write the earliest capture of each path (n, PATH) to `times` (n,), all by the same disk. */
struct covey_earliest_captures_words {
    double *paths; int64_t paths_0, paths_1;
    double disk_x;
    double disk_y;
    double disk_radius;
    double disk_time;
    double disk_speed;
    double *times; int64_t times_0;
};
int64_t covey_earliest_captures(const struct covey_earliest_captures_words *words, void *results);

/* Write when evader i, on each of its paths, is captured first of all.

   `paths` (N * nodes, PATH) are those of a `Grid`, `latest` (nodes,) is modified in place. */
struct covey_first_captures_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t i;
    double *latest; int64_t latest_0;
};
int64_t covey_first_captures(const struct covey_first_captures_words *words, void *results);

/* Fly what is announced until the next update or capture; return the captured row.

   1. The pursuer makes for its target, or flies the velocity. A hidden pursuer is its disk, unless
      it has a position. It captures its target when the disk reaches the target, and nobody else.
   2. A pursuer with a position and a reach captures whomever it comes within ρ of first.
   3. Pursuer, disk and evaders move to the time of the capture, or of the update.

   Parameters
   ----------
   state
       Modified in place. A captured evader stays in the state until `remove` is called.
   rules
       Of the game.
   target
       Row of the living evader that the pursuer makes for, or `NOBODY`.
   velocity_x, velocity_y
       Of a pursuer without a target.

   Returns
   -------
   int
       The row of the captured evader, or `NOBODY`. */
struct covey_fly_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    int64_t target;
    double velocity_x;
    double velocity_y;
};
struct covey_fly_results {
    int64_t value_0;
};
int64_t covey_fly(const struct covey_fly_words *words, struct covey_fly_results *results);

/* Write the capture times of a sequence and the segments' ends; return the last time.

   Parameters
   ----------
   problem
       The evaders (n) and the pursuit; the objective is the last capture.
   tree
       Of n evaders.
   sequence
       (n,) the order of capture.
   branch
       Modified in place. */
struct covey_fly_branch_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *tree_turns; int64_t tree_turns_0; /* (sizes[0],) signed turns, radians in [-π, π] */
    int64_t tree_depth; /* 0: the turns of an open-loop plan; at most n - 1 */
    int64_t *tree_sizes; int64_t tree_sizes_0; /* (n + 1,) turns in a subtree after k captures */
    int64_t *sequence; int64_t sequence_0;
    double *branch_times; int64_t branch_times_0; /* (n,) capture times */
    double *branch_evaders; int64_t branch_evaders_0, branch_evaders_1; /* (n, EVADER) where the present segment began */
    double *branch_turns; int64_t branch_turns_0; /* (n,) of the present segment */
    double *branch_paths; int64_t branch_paths_0, branch_paths_1; /* (n, PATH) of the present segment */
    double *branch_segments; int64_t branch_segments_0, branch_segments_1; /* (n * n, SEGMENT) row j * n + k: segment k of the j-th captured evader */
    int64_t *branch_variables; int64_t branch_variables_0, branch_variables_1; /* (n, n) entry (j, k): which turn of the tree segment k of evader j has */
};
struct covey_fly_branch_results {
    double value_0;
};
int64_t covey_fly_branch(const struct covey_fly_branch_words *words, struct covey_fly_branch_results *results);

/* Fly each pursuer of a batch at its velocity; each team flies its plan, and replans.

   Parameters
   ----------
   states
       Of B games; modified in place.
   rules
       Of all games.
   velocities
       (B, 2) of the pursuers.
   team
       How the teams replan.
   memories
       Of the teams; modified in place.
   workspace
       With room for all evaders of a game; modified in place. */
struct covey_fly_pursuers_words {
    int64_t *states_alive; int64_t states_alive_0; /* (1,) */
    int64_t *states_ids; int64_t states_ids_0; /* (N,) numbers of the living */
    double *states_evaders; int64_t states_evaders_0, states_evaders_1; /* (N, EVADER) */
    double *states_turns; int64_t states_turns_0; /* (N,) announced, still to be flown */
    double *states_paths; int64_t states_paths_0, states_paths_1; /* (N, PATH) of what is announced, from now on */
    double *states_disk; int64_t states_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *states_time; int64_t states_time_0; /* (1,) */
    double *states_capture_pose; int64_t states_capture_pose_0, states_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *states_pursuer; int64_t states_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    double *velocities; int64_t velocities_0, velocities_1;
    int64_t team_replans; /* iterative open loop, or open loop */
    double team_interval; /* least time between two plans, unless there is a capture */
    int64_t team_restarts; /* initial guesses other than the last plan, after a capture */
    double team_tolerance;
    int64_t team_max_steps;
    int64_t *memories_working_set_used; int64_t memories_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *memories_working_set_sequences; int64_t memories_working_set_sequences_0, memories_working_set_sequences_1; /* (m, n) */
    double *memories_working_set_weights; int64_t memories_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *memories_working_set_values; int64_t memories_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    double *memories_uniforms; int64_t memories_uniforms_0, memories_uniforms_1; /* of the initial guesses */
    double *memories_last; int64_t memories_last_0; /* (2,) time and value of the last plan; value -inf: unknown */
    int64_t memories_objective_total; /* the sum of all capture times; else the last capture */
    int64_t memories_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *memories_objective_draws_used; int64_t memories_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *memories_objective_draws_sequences; int64_t memories_objective_draws_sequences_0, memories_objective_draws_sequences_1; /* (K, n) */
    double *memories_objective_draws_probabilities; int64_t memories_objective_draws_probabilities_0; /* (K,) */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
int64_t covey_fly_pursuers(const struct covey_fly_pursuers_words *words, void *results);

/* Turn each evader by its turn (B, N), by number; each pursuer keeps to its sequence.

   States and commitments of the B games are modified in place. */
struct covey_fly_teams_words {
    int64_t *states_alive; int64_t states_alive_0; /* (1,) */
    int64_t *states_ids; int64_t states_ids_0; /* (N,) numbers of the living */
    double *states_evaders; int64_t states_evaders_0, states_evaders_1; /* (N, EVADER) */
    double *states_turns; int64_t states_turns_0; /* (N,) announced, still to be flown */
    double *states_paths; int64_t states_paths_0, states_paths_1; /* (N, PATH) of what is announced, from now on */
    double *states_disk; int64_t states_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *states_time; int64_t states_time_0; /* (1,) */
    double *states_capture_pose; int64_t states_capture_pose_0, states_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *states_pursuer; int64_t states_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    double *turns; int64_t turns_0, turns_1;
    double pursuers_margin;
    int64_t *pursuers_sequences; int64_t pursuers_sequences_0; /* (B N,) */
    int64_t *pursuers_chosen; int64_t pursuers_chosen_0; /* (B,) 0 where a pursuer has no sequence yet */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
int64_t covey_fly_teams(const struct covey_fly_teams_words *words, void *results);

/* Return the guaranteed last capture, or sum, if the living fly their plan to the end.

   The paths of the state and the workspace are modified in place. */
struct covey_guaranteed_value_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    int64_t total;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_guaranteed_value_results {
    double value_0;
};
int64_t covey_guaranteed_value(const struct covey_guaranteed_value_words *words, struct covey_guaranteed_value_results *results);

/* Write the turns with the latest last capture; return whether they are settled.

   1. The best turns of the coarse grid.
   2. Fine grids around the best turns. The grid narrows only where the best turns are not on its
      border.

   Parameters
   ----------
   pursuit
       The pursuer.
   sequence
       (n,) the order of capture.
   tolerance
       Radians; settled turns are known to it.
   grids
       Of the evaders; modified in place.
   turns
       (n,) zeros; modified in place. */
struct covey_latest_in_sequence_words {
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t *sequence; int64_t sequence_0;
    double tolerance;
    double *grids_coarse_evaders; int64_t grids_coarse_evaders_0, grids_coarse_evaders_1; /* (n * nodes, EVADER) */
    double *grids_coarse_turns; int64_t grids_coarse_turns_0; /* (n * nodes,) */
    double *grids_coarse_paths; int64_t grids_coarse_paths_0, grids_coarse_paths_1; /* (n * nodes, PATH) */
    double *grids_coarse_latest; int64_t grids_coarse_latest_0, grids_coarse_latest_1; /* (n, nodes) latest capture by slot in the sequence */
    int64_t *grids_coarse_predecessor; int64_t grids_coarse_predecessor_0, grids_coarse_predecessor_1; /* (n, nodes) the node of the evader before, with which it is attained */
    double *grids_fine_evaders; int64_t grids_fine_evaders_0, grids_fine_evaders_1; /* (n * nodes, EVADER) */
    double *grids_fine_turns; int64_t grids_fine_turns_0; /* (n * nodes,) */
    double *grids_fine_paths; int64_t grids_fine_paths_0, grids_fine_paths_1; /* (n * nodes, PATH) */
    double *grids_fine_latest; int64_t grids_fine_latest_0, grids_fine_latest_1; /* (n, nodes) latest capture by slot in the sequence */
    int64_t *grids_fine_predecessor; int64_t grids_fine_predecessor_0, grids_fine_predecessor_1; /* (n, nodes) the node of the evader before, with which it is attained */
    double *turns; int64_t turns_0;
};
struct covey_latest_in_sequence_results {
    int64_t value_0;
};
int64_t covey_latest_in_sequence(const struct covey_latest_in_sequence_words *words, struct covey_latest_in_sequence_results *results);

/* Spread every evader's turns over `width` to both sides of its centre.

   `centers` (n,) and `width` are radians; the grid's turns and paths are modified in place. The
   nearest come first, so that among equals the smallest change of the turn wins. Turns at a
   limited rate stay within [-π, π]; others go round. */
struct covey_lay_grid_words {
    double *grid_evaders; int64_t grid_evaders_0, grid_evaders_1; /* (n * nodes, EVADER) */
    double *grid_turns; int64_t grid_turns_0; /* (n * nodes,) */
    double *grid_paths; int64_t grid_paths_0, grid_paths_1; /* (n * nodes, PATH) */
    double *grid_latest; int64_t grid_latest_0, grid_latest_1; /* (n, nodes) latest capture by slot in the sequence */
    int64_t *grid_predecessor; int64_t grid_predecessor_0, grid_predecessor_1; /* (n, nodes) the node of the evader before, with which it is attained */
    double *centers; int64_t centers_0;
    double width;
    double pursuer_speed;
};
int64_t covey_lay_grid(const struct covey_lay_grid_words *words, void *results);

/* Return the mean over the drawn sequences at given turns (n,). */
struct covey_mean_over_draws_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *turns; int64_t turns_0;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_mean_over_draws_results {
    double value_0;
};
int64_t covey_mean_over_draws(const struct covey_mean_over_draws_words *words, struct covey_mean_over_draws_results *results);

/* Return the inner minimum at given turns if it is below `bound`, else `bound`.

   Parameters
   ----------
   evaders
       (n, EVADER).
   turns
       (n,) signed turns, radians.
   pursuit
       The pursuer.
   total
       Whether the sum of all capture times is minimised; else the last capture.
   bound
       inf, or an upper bound.
   sequence
       (n,) the order that attains the minimum; modified in place where one beats the bound.
   workspace
       With room for n evaders, and for sums where `total`; modified in place. */
struct covey_minimum_over_sequences_words {
    double *evaders; int64_t evaders_0, evaders_1;
    double *turns; int64_t turns_0;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t total;
    double bound;
    int64_t *sequence; int64_t sequence_0;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_minimum_over_sequences_results {
    double value_0;
};
int64_t covey_minimum_over_sequences(const struct covey_minimum_over_sequences_words *words, struct covey_minimum_over_sequences_results *results);

/* Return an upper bound of the mean over the orders, and how many branches were bounded.

   1. Bound the mean where the pursuer starts from the first evader: below it the mean need not be
      quasi-convex in the velocities.
   2. Take a branch from the stack, and bound it. Below the target it needs no further look.
   3. Otherwise divide its last corner in two, and when that is fine, put the corners of the next
      evader on the stack. A branch in which all corners are fixed ends the search.

   Parameters
   ----------
   mixture
       The orders and their weights. The search fixes the evaders' corners in the order of rows.
   target
       Time; the search ends with a bound that is at most this, or at the first headings that may
       be above it.
   branches
       Modified in place.
   attained
       (n,) headings until the first capture that may be above the target; modified in place.
   scratch
       Modified in place.

   Returns
   -------
   float
       Whatever the evaders do, the mean is at most this if this is at most the target. Else the
       target may be exceeded, at `attained`; inf if the branches were used up.
   int */
struct covey_mixture_bound_words {
    double *mixture_evaders; int64_t mixture_evaders_0, mixture_evaders_1; /* (n, EVADER); the first one is captured first */
    double mixture_pursuit_center_x;
    double mixture_pursuit_center_y;
    double mixture_pursuit_first_radius;
    double mixture_pursuit_later_radius;
    double mixture_pursuit_speed;
    int64_t *mixture_orders; int64_t mixture_orders_0, mixture_orders_1; /* (m, n - 1) of the evaders 1 to n - 1 */
    double *mixture_weights; int64_t mixture_weights_0; /* (m,) >= 0, summing to one */
    double target;
    int64_t branches_corners; /* of the first polygon */
    double branches_finest; /* radians; a corner that stands for less to each side is not divided */
    int64_t branches_most; /* branches that are bounded, at most */
    int64_t *branches_fixed; int64_t branches_fixed_0; /* (stack,) evaders whose corner is fixed */
    double *branches_directions; int64_t branches_directions_0, branches_directions_1; /* (stack, n) */
    double *branches_halves; int64_t branches_halves_0, branches_halves_1; /* (stack, n) */
    double *branches_headings; int64_t branches_headings_0, branches_headings_1, branches_headings_2; /* (stack, m, n) */
    double *attained; int64_t attained_0;
    double *scratch_directions; int64_t scratch_directions_0; /* (n,) until the first capture */
    double *scratch_stretches; int64_t scratch_stretches_0; /* (n,) speed until then, over the evader's own */
    double *scratch_departed; int64_t scratch_departed_0, scratch_departed_1; /* (n, EVADER) where what is known of the flights ends */
    double *scratch_departures; int64_t scratch_departures_0; /* (n,) and when */
    double *scratch_here; int64_t scratch_here_0, scratch_here_1; /* (n, EVADER) at the first capture */
    double *scratch_headings; int64_t scratch_headings_0, scratch_headings_1; /* (m, n) after it, by order */
    double *scratch_flights; int64_t scratch_flights_0, scratch_flights_1; /* (n, FLIGHT) */
    double *scratch_gradients; int64_t scratch_gradients_0, scratch_gradients_1, scratch_gradients_2; /* (m, n, 2) of the last capture by the positions at the first one */
    double *scratch_programme_corners; int64_t scratch_programme_corners_0, scratch_programme_corners_1; /* (c, CORNER) */
    double *scratch_programme_states; int64_t scratch_programme_states_0, scratch_programme_states_1, scratch_programme_states_2; /* (n, c, STATE) of the captures before each slot */
    int64_t *scratch_programme_predecessor; int64_t scratch_programme_predecessor_0, scratch_programme_predecessor_1; /* (n, c) the corner of the evader before, with which a state is attained */
    double *scratch_programme_attained; int64_t scratch_programme_attained_0; /* (n,) headings that attain the bound, by evader */
};
struct covey_mixture_bound_results {
    double value_0;
    int64_t value_1;
};
int64_t covey_mixture_bound(const struct covey_mixture_bound_words *words, struct covey_mixture_bound_results *results);

/* Ascend from a range of initial guesses.

   Among equals the first plan wins, so that a team doesn't change its plan for nothing. When
   `workspace.stop` is set, the present ascent ends early and no other begins; the first guess is
   always evaluated.

   Parameters
   ----------
   problem
       The living evaders (n), the pursuit, the objective.
   guesses
       The range, its random numbers, and the elite, which the results of each whole batch enter.
   options
       Of each ascent.
   best
       Value of the best plan so far; -inf: none.
   iterate
       (n,) turns and working set of the best plan. Overwritten by a plan that is clearly better.
   workspace
       With room for n evaders; modified in place.

   Returns
   -------
   tuple of float, int, int, int
       Value of the best plan; how its ascent ended, CONVERGED where no guess led above `best`;
       steps; interceptions. */
struct covey_multistart_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *guesses_uniforms; int64_t guesses_uniforms_0, guesses_uniforms_1; /* (CANDIDATES * (guesses - 1), n) random numbers in [-1, 1] */
    double *guesses_elite_values; int64_t guesses_elite_values_0; /* (ELITE,) -inf where there is none */
    double *guesses_elite_turns; int64_t guesses_elite_turns_0, guesses_elite_turns_1; /* (ELITE, n) */
    int64_t guesses_first; /* number of the first guess */
    int64_t guesses_size; /* how many guesses */
    double options_radius; /* of the first trust region: the largest first change of a turn, radians */
    double options_tolerance; /* a predicted gain below this, relative to the value, ends the ascent */
    int64_t options_max_steps;
    double best;
    double *iterate_turns; int64_t iterate_turns_0; /* (n,) signed turns, radians in [-π, π] */
    int64_t *iterate_working_set_used; int64_t iterate_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *iterate_working_set_sequences; int64_t iterate_working_set_sequences_0, iterate_working_set_sequences_1; /* (m, n) */
    double *iterate_working_set_weights; int64_t iterate_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *iterate_working_set_values; int64_t iterate_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_multistart_results {
    double value_0;
    int64_t value_1;
    int64_t value_2;
    int64_t value_3;
};
int64_t covey_multistart(const struct covey_multistart_words *words, struct covey_multistart_results *results);

/* Write when evader i, on each of its paths, is captured `latest`, and by which predecessor.

   The pursuer comes from evader `previous`, captured at `earlier` on each of that evader's paths.

   Parameters
   ----------
   paths
       (N * nodes, PATH), see `Grid`.
   pursuit
       The pursuer.
   previous, i
       Numbers of two evaders that are captured one after the other.
   earlier
       (nodes,) capture times of `previous`, by its path.
   latest
       (nodes,) capture times of i, by its path; modified in place.
   predecessor
       (nodes,) the path of `previous` that delays i most; modified in place. */
struct covey_next_captures_words {
    double *paths; int64_t paths_0, paths_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    int64_t previous;
    int64_t i;
    double *earlier; int64_t earlier_0;
    double *latest; int64_t latest_0;
    int64_t *predecessor; int64_t predecessor_0;
};
int64_t covey_next_captures(const struct covey_next_captures_words *words, void *results);

/* Write what is seen from (x, y): a row for each evader, then the disk that the team knows of.

   `seen` (ROW * N + DISK,) is modified in place.

   Evader number `first` comes first, the others by number; a captured one is a row of zeros. */
struct covey_observe_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double x;
    double y;
    int64_t first;
    float *seen; int64_t seen_0;
};
int64_t covey_observe(const struct covey_observe_words *words, void *results);

/* Write what each pursuer sees or, `together`, what each team sees from its disk's centre.

   `seen` (B, ROW * N + DISK) is modified in place; a row is as `observe` writes it. */
struct covey_observe_games_words {
    int64_t *states_alive; int64_t states_alive_0; /* (1,) */
    int64_t *states_ids; int64_t states_ids_0; /* (N,) numbers of the living */
    double *states_evaders; int64_t states_evaders_0, states_evaders_1; /* (N, EVADER) */
    double *states_turns; int64_t states_turns_0; /* (N,) announced, still to be flown */
    double *states_paths; int64_t states_paths_0, states_paths_1; /* (N, PATH) of what is announced, from now on */
    double *states_disk; int64_t states_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *states_time; int64_t states_time_0; /* (1,) */
    double *states_capture_pose; int64_t states_capture_pose_0, states_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *states_pursuer; int64_t states_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    int64_t together;
    float *seen; int64_t seen_0, seen_1;
};
int64_t covey_observe_games(const struct covey_observe_games_words *words, void *results);

/* Play a game until it is over, or until its log is full.

   1. Announce the team's plan; the pursuer chooses its sequence, or keeps it.
   2. Write a row, if the course is logged.
   3. Fly until the next update or capture, and log a capture.
   4. Let the team replan, where that is due.

   Parameters
   ----------
   state
       Of the game; `state.turns` holds the plan that is flown. Modified in place.
   rules
       Of the game.
   team, memory
       How the team replans, and what it remembers; the memory is modified in place.
   commitment
       The pursuer's sequence, modified in place. `is_chosen` must be true where a game goes on.
   log
       Modified in place. A log without rows keeps the captures only.
   workspace
       With room for all evaders; modified in place.

   Returns
   -------
   bool
       Whether the game is over. If not, call again with a log that was grown, unless
       `workspace.stop` has been set. */
struct covey_play_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    int64_t team_replans; /* iterative open loop, or open loop */
    double team_interval; /* least time between two plans, unless there is a capture */
    int64_t team_restarts; /* initial guesses other than the last plan, after a capture */
    double team_tolerance;
    int64_t team_max_steps;
    int64_t *memory_working_set_used; int64_t memory_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *memory_working_set_sequences; int64_t memory_working_set_sequences_0, memory_working_set_sequences_1; /* (m, n) */
    double *memory_working_set_weights; int64_t memory_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *memory_working_set_values; int64_t memory_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    double *memory_uniforms; int64_t memory_uniforms_0, memory_uniforms_1; /* of the initial guesses */
    double *memory_last; int64_t memory_last_0; /* (2,) time and value of the last plan; value -inf: unknown */
    int64_t memory_objective_total; /* the sum of all capture times; else the last capture */
    int64_t memory_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *memory_objective_draws_used; int64_t memory_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *memory_objective_draws_sequences; int64_t memory_objective_draws_sequences_0, memory_objective_draws_sequences_1; /* (K, n) */
    double *memory_objective_draws_probabilities; int64_t memory_objective_draws_probabilities_0; /* (K,) */
    double commitment_margin; /* relative gain for which it changes the sequence; inf: never */
    int64_t *commitment_sequence; int64_t commitment_sequence_0; /* (N,) rows of the living; modified in place */
    int64_t commitment_is_chosen; /* False: it begins with the best sequence, and `sequence` holds nothing */
    int64_t *log_counters; int64_t log_counters_0; /* (3,) captures, rows, updates */
    int64_t *log_order; int64_t log_order_0; /* (N,) captured evaders */
    double *log_capture_times; int64_t log_capture_times_0; /* (N,) */
    double *log_times; int64_t log_times_0; /* (T,) */
    double *log_guarantees; int64_t log_guarantees_0; /* (T,) */
    double *log_evaders; int64_t log_evaders_0, log_evaders_1, log_evaders_2; /* (T, N, 4) x, y, heading, turn still planned */
    double *log_pursuers; int64_t log_pursuers_0, log_pursuers_1; /* (T, 5) position, then the disk's centre and radius */
    int64_t *log_critical; int64_t log_critical_0, log_critical_1; /* (T, N) */
    int64_t *log_intended; int64_t log_intended_0, log_intended_1; /* (T, N) */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_play_results {
    int64_t value_0;
};
int64_t covey_play(const struct covey_play_words *words, struct covey_play_results *results);

/* Play on until the evader in row `target` is captured, and let the team replan.

   Parameters
   ----------
   state
       Of the game; modified in place.
   rules
       Of the game.
   team, memory
       How the team replans, and its memory, which is modified in place.
   target
       Row of a living evader.
   delay
       The capture waits for the first update that comes at least this time after the first update
       at which the disk contains the evader; 0: the capture comes as soon as it can.
   workspace
       With room for all evaders; modified in place.

   Returns
   -------
   bool
       False if that takes too many updates, or if `workspace.stop` is set. */
struct covey_play_to_capture_words {
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    int64_t team_replans; /* iterative open loop, or open loop */
    double team_interval; /* least time between two plans, unless there is a capture */
    int64_t team_restarts; /* initial guesses other than the last plan, after a capture */
    double team_tolerance;
    int64_t team_max_steps;
    int64_t *memory_working_set_used; int64_t memory_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *memory_working_set_sequences; int64_t memory_working_set_sequences_0, memory_working_set_sequences_1; /* (m, n) */
    double *memory_working_set_weights; int64_t memory_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *memory_working_set_values; int64_t memory_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    double *memory_uniforms; int64_t memory_uniforms_0, memory_uniforms_1; /* of the initial guesses */
    double *memory_last; int64_t memory_last_0; /* (2,) time and value of the last plan; value -inf: unknown */
    int64_t memory_objective_total; /* the sum of all capture times; else the last capture */
    int64_t memory_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *memory_objective_draws_used; int64_t memory_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *memory_objective_draws_sequences; int64_t memory_objective_draws_sequences_0, memory_objective_draws_sequences_1; /* (K, n) */
    double *memory_objective_draws_probabilities; int64_t memory_objective_draws_probabilities_0; /* (K,) */
    int64_t target;
    double delay;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_play_to_capture_results {
    int64_t value_0;
};
int64_t covey_play_to_capture(const struct covey_play_to_capture_words *words, struct covey_play_to_capture_results *results);

/* Raise the lower bound of each sequence by better headings, until it reaches the cutoff.

   Parameters
   ----------
   evaders
       (n, EVADER) rows of `Team.as_rows`; headings and turn rates are not used.
   pursuit
       A pursuer at a point. It flies to each evader's exact position; `first_radius`, its reach,
       counts for the last capture only.
   cutoff
       Time at which a bound is high enough.
   sequences
       (m, n) orders of capture.
   headings
       (m, n) radians, by evader; modified in place.
   bounds
       (m,) last captures at the best headings that were met; modified in place.
   flights
       (n, FLIGHT) scratch. */
struct covey_raise_lower_bounds_words {
    double *evaders; int64_t evaders_0, evaders_1;
    double pursuit_center_x;
    double pursuit_center_y;
    double pursuit_first_radius;
    double pursuit_later_radius;
    double pursuit_speed;
    double cutoff;
    int64_t *sequences; int64_t sequences_0, sequences_1;
    double *headings; int64_t headings_0, headings_1;
    double *bounds; int64_t bounds_0;
    double *flights; int64_t flights_0, flights_1;
};
int64_t covey_raise_lower_bounds(const struct covey_raise_lower_bounds_words *words, void *results);

/* Improve an iterate, from its own turns and from other initial guesses.

   Parameters
   ----------
   problem
       The living evaders (n), the pursuit, the objective.
   uniforms, restarts
       Random numbers of the other initial guesses, see `Guesses`, and how many guesses there are.
   options
       Of the ascent from the iterate. The other ascents differ in their first radius.
   lower_bound
       Of the value of the given turns, see `solve_sqp`; -inf: unknown.
   iterate
       (n,) turns and working set; modified in place.
   workspace
       With room for n evaders; modified in place.

   Returns
   -------
   tuple of float, int, int, int
       The exact value, which is never below that of the given turns; how the last ascents ended;
       steps; interceptions. */
struct covey_refine_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *uniforms; int64_t uniforms_0, uniforms_1;
    int64_t restarts;
    double options_radius; /* of the first trust region: the largest first change of a turn, radians */
    double options_tolerance; /* a predicted gain below this, relative to the value, ends the ascent */
    int64_t options_max_steps;
    double lower_bound;
    double *iterate_turns; int64_t iterate_turns_0; /* (n,) signed turns, radians in [-π, π] */
    int64_t *iterate_working_set_used; int64_t iterate_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *iterate_working_set_sequences; int64_t iterate_working_set_sequences_0, iterate_working_set_sequences_1; /* (m, n) */
    double *iterate_working_set_weights; int64_t iterate_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *iterate_working_set_values; int64_t iterate_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_refine_results {
    double value_0;
    int64_t value_1;
    int64_t value_2;
    int64_t value_3;
};
int64_t covey_refine(const struct covey_refine_words *words, struct covey_refine_results *results);

/* Improve the turns (n,) that are flown, from them and from other initial guesses.

   The value of the given turns is at least the last plan's value less what was `spent` since,
   whatever a pursuer did that keeps to the rules.

   Parameters
   ----------
   problem
       The living evaders (n), the pursuit, the objective.
   options
       How the team plans.
   memory
       Working set and `last[1]`, the value, are modified in place.
   spent
       By how much the value of the last plan has fallen since.
   restarts
       How many initial guesses are improved too; none of a team that is too large for an exact
       minimum at each step.
   turns
       (n,) still to be flown, radians; modified in place.
   workspace
       With room for n evaders; modified in place. */
struct covey_replan_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    int64_t options_replans; /* iterative open loop, or open loop */
    double options_interval; /* least time between two plans, unless there is a capture */
    int64_t options_restarts; /* initial guesses other than the last plan, after a capture */
    double options_tolerance;
    int64_t options_max_steps;
    int64_t *memory_working_set_used; int64_t memory_working_set_used_0; /* (1,) how many rows are in use */
    int64_t *memory_working_set_sequences; int64_t memory_working_set_sequences_0, memory_working_set_sequences_1; /* (m, n) */
    double *memory_working_set_weights; int64_t memory_working_set_weights_0; /* (m,) multipliers of the last step, >= 0: the shares in the Hessian */
    double *memory_working_set_values; int64_t memory_working_set_values_0; /* (m,) objective of each sequence where the last ascent ended */
    double *memory_uniforms; int64_t memory_uniforms_0, memory_uniforms_1; /* of the initial guesses */
    double *memory_last; int64_t memory_last_0; /* (2,) time and value of the last plan; value -inf: unknown */
    int64_t memory_objective_total; /* the sum of all capture times; else the last capture */
    int64_t memory_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *memory_objective_draws_used; int64_t memory_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *memory_objective_draws_sequences; int64_t memory_objective_draws_sequences_0, memory_objective_draws_sequences_1; /* (K, n) */
    double *memory_objective_draws_probabilities; int64_t memory_objective_draws_probabilities_0; /* (K,) */
    double spent;
    int64_t restarts;
    double *turns; int64_t turns_0;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
int64_t covey_replan(const struct covey_replan_words *words, void *results);

/* Write the position of every evader at each of the `times`, to (times, evaders, 2). */
struct covey_sample_words {
    double *paths; int64_t paths_0, paths_1;
    double *times; int64_t times_0;
    double *positions; int64_t positions_0, positions_1, positions_2;
};
int64_t covey_sample(const struct covey_sample_words *words, void *results);

/* Write, for each evader, the path that turns by a signed angle and then flies straight.

   An evader that can't turn (rate 0) flies straight, whatever its turn is. An infinite rate turns
   at once.

   Parameters
   ----------
   evaders
       (n, EVADER) rows of position, heading, speed and turn rate.
   turns
       (n,) signed turns, radians.
   pursuer_speed
       v_p.
   paths
       (n, PATH) modified in place. */
struct covey_set_paths_words {
    double *evaders; int64_t evaders_0, evaders_1;
    double *turns; int64_t turns_0;
    double pursuer_speed;
    double *paths; int64_t paths_0, paths_1;
};
int64_t covey_set_paths(const struct covey_set_paths_words *words, void *results);

/* Write the value of announcing the better order, (balances, openings). */
struct covey_set_upper_bound_words {
    double *grid_balances; int64_t grid_balances_0;
    double *grid_balance_steps; int64_t grid_balance_steps_0;
    double *grid_openings; int64_t grid_openings_0;
    double *grid_opening_steps; int64_t grid_opening_steps_0;
    double v1;
    double v2;
    double *upper_bound; int64_t upper_bound_0, upper_bound_1;
};
int64_t covey_set_upper_bound(const struct covey_set_upper_bound_words *words, void *results);

/* Write the value of announcing the better order for rows (a, b, opening). */
struct covey_set_upper_bounds_words {
    double *situations; int64_t situations_0, situations_1;
    double v1;
    double v2;
    double *upper_bounds; int64_t upper_bounds_0;
};
int64_t covey_set_upper_bounds(const struct covey_set_upper_bounds_words *words, void *results);

/* Return whether every play, with captures as late as the pursuer likes, ends after the target.

   The answer is no, too, where that can't be shown with intervals above the finest, or with the
   most nodes, or where `workspace.stop` was set. Then a play that may end before is left behind:
   its sequence in `search.worst`, and the times of the captures that are put off in
   `search.levels.disks`, from the second row on.

   Parameters
   ----------
   problem
       The evaders (n) and the pursuit; the objective is the last capture.
   tree
       Of n evaders.
   search
       Arrays for n evaders; modified in place.
   workspace
       With room for n evaders; modified in place. */
struct covey_survives_delays_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *tree_turns; int64_t tree_turns_0; /* (sizes[0],) signed turns, radians in [-π, π] */
    int64_t tree_depth; /* 0: the turns of an open-loop plan; at most n - 1 */
    int64_t *tree_sizes; int64_t tree_sizes_0; /* (n + 1,) turns in a subtree after k captures */
    double search_target; /* the time after which every play is to end */
    double search_finest; /* drift of the shortest intervals of the first capture, a length */
    double *search_levels_evaders; int64_t search_levels_evaders_0, search_levels_evaders_1; /* (n * n, EVADER) row level * n + rank */
    double *search_levels_paths; int64_t search_levels_paths_0, search_levels_paths_1; /* (n * n, PATH) */
    int64_t *search_levels_numbers; int64_t search_levels_numbers_0, search_levels_numbers_1; /* (n, n) the evaders' numbers, ascending */
    double *search_levels_disks; int64_t search_levels_disks_0, search_levels_disks_1; /* (n, 4) */
    int64_t *search_levels_counters; int64_t search_levels_counters_0, search_levels_counters_1; /* (n, 2) */
    int64_t *search_levels_sequence; int64_t search_levels_sequence_0; /* (n,) evaders captured so far */
    double *search_intervals; int64_t search_intervals_0, search_intervals_1; /* (n, INTERVAL) of each level, see above */
    int64_t *search_worst; int64_t search_worst_0; /* (n,) of the play that may end before the target; modified in place */
    int64_t *search_counters; int64_t search_counters_0; /* (3,) nodes visited; the most that may be; captures put off in that play */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_survives_delays_results {
    int64_t value_0;
};
int64_t covey_survives_delays(const struct covey_survives_delays_words *words, struct covey_survives_delays_results *results);

/* Sweep the values (balances, openings) in four directions; return the largest change. */
struct covey_sweep_words {
    double *values; int64_t values_0, values_1;
    double *upper_bound; int64_t upper_bound_0, upper_bound_1;
    double *grid_balances; int64_t grid_balances_0;
    double *grid_balance_steps; int64_t grid_balance_steps_0;
    double *grid_openings; int64_t grid_openings_0;
    double *grid_opening_steps; int64_t grid_opening_steps_0;
    double v1;
    double v2;
};
struct covey_sweep_results {
    double value_0;
};
int64_t covey_sweep(const struct covey_sweep_words *words, struct covey_sweep_results *results);

/* Return the value of a contingent plan if it is below `bound`, else `bound`.

   Parameters are those of `tree_minimum`; the workspace has room for n evaders. */
struct covey_tree_value_words {
    double *problem_evaders; int64_t problem_evaders_0, problem_evaders_1; /* (n, EVADER) of the living */
    double problem_pursuit_center_x;
    double problem_pursuit_center_y;
    double problem_pursuit_first_radius;
    double problem_pursuit_later_radius;
    double problem_pursuit_speed;
    int64_t problem_objective_total; /* the sum of all capture times; else the last capture */
    int64_t problem_objective_expected; /* the mean over the drawn sequences; else the minimum over all sequences */
    int64_t *problem_objective_draws_used; int64_t problem_objective_draws_used_0; /* (1,) how many rows are in use */
    int64_t *problem_objective_draws_sequences; int64_t problem_objective_draws_sequences_0, problem_objective_draws_sequences_1; /* (K, n) */
    double *problem_objective_draws_probabilities; int64_t problem_objective_draws_probabilities_0; /* (K,) */
    double *tree_turns; int64_t tree_turns_0; /* (sizes[0],) signed turns, radians in [-π, π] */
    int64_t tree_depth; /* 0: the turns of an open-loop plan; at most n - 1 */
    int64_t *tree_sizes; int64_t tree_sizes_0; /* (n + 1,) turns in a subtree after k captures */
    double bound;
    int64_t *sequence; int64_t sequence_0;
    double *levels_evaders; int64_t levels_evaders_0, levels_evaders_1; /* (n * n, EVADER) row level * n + rank */
    double *levels_paths; int64_t levels_paths_0, levels_paths_1; /* (n * n, PATH) */
    int64_t *levels_numbers; int64_t levels_numbers_0, levels_numbers_1; /* (n, n) the evaders' numbers, ascending */
    double *levels_disks; int64_t levels_disks_0, levels_disks_1; /* (n, 4) */
    int64_t *levels_counters; int64_t levels_counters_0, levels_counters_1; /* (n, 2) */
    int64_t *levels_sequence; int64_t levels_sequence_0; /* (n,) evaders captured so far */
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
struct covey_tree_value_results {
    double value_0;
};
int64_t covey_tree_value(const struct covey_tree_value_words *words, struct covey_tree_value_results *results);

/* Write the state, the plan that is announced and its guarantee to the log's next row.

   Captured evaders stay where they were captured.

   Parameters
   ----------
   log
       Modified in place.
   state, rules
       Of the game; the paths of the state are those of the plan.
   intended
       Rows of the living: the order that the pursuer has in mind, as far as it is known.
   promised
       A time that the plan is known to guarantee; -inf: unknown. Only a team that is too large for
       an exact minimum at every row needs it.
   workspace
       With room for all evaders; modified in place. */
struct covey_write_row_words {
    int64_t *log_counters; int64_t log_counters_0; /* (3,) captures, rows, updates */
    int64_t *log_order; int64_t log_order_0; /* (N,) captured evaders */
    double *log_capture_times; int64_t log_capture_times_0; /* (N,) */
    double *log_times; int64_t log_times_0; /* (T,) */
    double *log_guarantees; int64_t log_guarantees_0; /* (T,) */
    double *log_evaders; int64_t log_evaders_0, log_evaders_1, log_evaders_2; /* (T, N, 4) x, y, heading, turn still planned */
    double *log_pursuers; int64_t log_pursuers_0, log_pursuers_1; /* (T, 5) position, then the disk's centre and radius */
    int64_t *log_critical; int64_t log_critical_0, log_critical_1; /* (T, N) */
    int64_t *log_intended; int64_t log_intended_0, log_intended_1; /* (T, N) */
    int64_t *state_alive; int64_t state_alive_0; /* (1,) */
    int64_t *state_ids; int64_t state_ids_0; /* (N,) numbers of the living */
    double *state_evaders; int64_t state_evaders_0, state_evaders_1; /* (N, EVADER) */
    double *state_turns; int64_t state_turns_0; /* (N,) announced, still to be flown */
    double *state_paths; int64_t state_paths_0, state_paths_1; /* (N, PATH) of what is announced, from now on */
    double *state_disk; int64_t state_disk_0; /* (3,) centre and radius of the disk that the team knows the pursuer in */
    double *state_time; int64_t state_time_0; /* (1,) */
    double *state_capture_pose; int64_t state_capture_pose_0, state_capture_pose_1; /* (N, 3) position and heading at the capture, by number */
    double *state_pursuer; int64_t state_pursuer_0; /* (3,) its position and 0; the whole disk where it has no position */
    double rules_pursuer_speed;
    double rules_reach; /* ρ */
    int64_t rules_hidden;
    double rules_update_time;
    double rules_time_limit;
    int64_t rules_has_position; /* the pursuer is placed at the start, even where it is hidden */
    int64_t *intended; int64_t intended_0;
    double promised;
    int64_t workspace_size; /* n: evaders that the scratch has room for */
    int64_t workspace_total; /* whether there is room for minima of sums, too */
    int64_t workspace_fewest_walking; /* evaders from which on the minimum begins with walks */
    int64_t workspace_largest_table; /* evaders up to which the minimum may keep a table of all sets */
    int64_t *workspace_carved; int64_t workspace_carved_0; /* (7,) how much of each of the following is in use */
    double *workspace_floats; int64_t workspace_floats_0; /* (.,) */
    double *workspace_rows; int64_t workspace_rows_0, workspace_rows_1; /* (., n) */
    double *workspace_wide_rows; int64_t workspace_wide_rows_0, workspace_wide_rows_1; /* (., n + 2) */
    double *workspace_path_rows; int64_t workspace_path_rows_0, workspace_path_rows_1; /* (., PATH) */
    double *workspace_padded_rows; int64_t workspace_padded_rows_0, workspace_padded_rows_1; /* (., n rounded up to a multiple of the processor's lanes) */
    int64_t *workspace_ints; int64_t workspace_ints_0; /* (.,) */
    int64_t *workspace_int_rows; int64_t workspace_int_rows_0, workspace_int_rows_1; /* (., n) */
    int32_t *workspace_slots; int64_t workspace_slots_0; /* (2**n,) zeros at first; carved as a whole */
    double *workspace_walks_floats; int64_t workspace_walks_floats_0;
    int64_t *workspace_walks_ints; int64_t workspace_walks_ints_0; /* begins with SOLVED, ..., STAGES_GIVEN */
    int32_t *workspace_walks_int32s; int64_t workspace_walks_int32s_0;
    int64_t *workspace_walks_neighbours; int64_t workspace_walks_neighbours_0, workspace_walks_neighbours_1; /* (n, MOST_NEIGHBOURS + 1) how many there are, and who */
    int64_t *workspace_stop; int64_t workspace_stop_0; /* (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON` */
};
int64_t covey_write_row(const struct covey_write_row_words *words, void *results);

