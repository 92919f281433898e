# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentence and remedy of every kind of finding (findings.py), those of the native module among them. A new
kind is a line here; `tools/translations` lists its words for translation. findings.py explains the formats of
figures."""

from __future__ import annotations

from string import Formatter
from typing import Mapping, Union

CONTEXT = "CurveUps_Findings"  # of translations

MORE = " and {count} more"  # after a number of names

# Figures that are translated; others (names of bodies and files, errors of libraries) are not.
WORDS = ("front", "back", "gap", "pin area", "pin keep-out", "inset at its limit", "open", "invalid",
         "faces turned over", "not flat",
         "a face crosses itself", "no volume", "volume", "front pin", "back pin", "height of the pins",
         "body", "bump", "joint hole", "wall beside the joint hole", "notch of the bridge",
         "out of date")

# Names of work in progress; {0} stands for a name or a number.
PROGRESS = (
    "working", "reading the target", "mending the target", "remeshing",
    "following the surface",
    "checking the target", "registering the scan", "smoothing the target", "dividing into pieces",
    "dividing into {0} pieces",
    "dividing into 1 piece", "looking for cuts", "making room for pins", "checking tiles", "trying {0}",
    "layout", "restoring the layout", "measuring deviation", "membrane", "front membrane", "back membrane",
    "meshing membranes", "friction and unilateral contacts", "repair: fresh membranes",
    "repair: {0} weak points", "repair: friction needed", "settle", "relaxing", "releasing", "shaking",
    "pressing", "process window", "building bodies", "building tiles",
    "placing anchors",
    "building the support", "dividing the support's underside", "dividing the support's lid",
    "measuring bodies", "measuring clearances", "building solids", "checking solids",
    "meshing bodies", "uniting bodies", "drawing pictures", "dividing the print among beds",
    "writing {0}")
# Figures that a check compares, in its order.
MARGINS = (
    "dihedral margin, deg", "back face / front face", "pin area margin front, mm2",
    "pin area margin back, mm2", "clearance of the front membrane, mm", "clearance of the back membrane, mm",
    "stretch / least that leaves gaps", "stretch / most before slack",
    "tiles of other parts that a tile runs into")
ESTIMATE = "* an estimate: the layout may do a little better or worse"  # of a margin

_EXPECTED = "released and shaken, the piece is expected to lie {mean:.2g mm} from the target on average " \
            "({low:.2g mm} to {high:.2g mm}), {largest:.2g mm} at most; "
_PRESSED = ". Pressed over the former it comes within {pressed:.2g mm}"

# The sentence, or both.
_TEXTS: dict[str, Union[str, tuple[str, str]]] = {
    # Contact forces and membranes.
    "no_pressure": "the membranes do not press the tiles together",
    "weak_points": "{points} contact points push too weakly: less than f_min = {f_min:.3g N} at "
                   "{contacts:8}; the weakest has {least:.3g N} at {weakest}",
    "weak_points.pulling": "{points} contact points push too weakly or pull ({pulling} pull): less than "
                           "f_min = {f_min:.3g N} at {contacts:8}; the weakest has {least:.3g N} at "
                           "{weakest}",
    "unbalanced": "contacts can't hold {held:8}: a hinge or nothing at all carries them",
    "in_the_air": "nothing carries the piece of {tile}: it does not reach the ground, where the lowest "
                  "piece rests",
    "in_the_air.held": "nothing carries the piece of {tile}: held_tiles names none of its tiles",
    "tips_over": "the piece of {tile} tips over on the table: its weight acts beside the corners on which it "
                 "stands",
    "coarse_mesh": "f_min is the estimated error of the membrane mesh, which is more than f_min_ratio asks "
                   "for",
    "undecided": "the least force exceeds f_min = {f_min:.3g N} by less than its error at {contacts:8}",
    "no_balance": "with a friction coefficient of {mu:.3g} no pushing forces balance the tiles: {pull:.3g N} "
                  "of pull would be needed, first at {contacts:8}{more}",
    "balance_unknown": "whether pushing forces within friction {mu:.3g} balance the tiles could not be "
                       "shown{more}",
    "least_force": "pushing forces within friction {mu:.3g} leave a least normal force of {least:.3g N}, "
                   "less than f_min = {f_min:.3g N}, first at {contacts:8}{more}",
    "least_force.tips": "with a friction coefficient of {mu:.3g} pushing forces are not known to reach f_min "
                        "= {f_min:.3g N} where only bumps' tips touch",
    "dimples_stop": "; dimples stop what slides after {play:.3g mm} at most",
    "no_equilibrium": "the membranes' equilibrium was not reached (residual {residual:.3g})",
    "membrane.covers": ("two sides of a cut need the same place in the flat layout, where the sheet would "
                        "lie on itself between {contacts:8}", "leave out the cut there, or cut elsewhere"),
    "membrane.cuts": "the {side} membrane would cut {depth:.3g mm} into the body of {tile}: raise H_pin or "
                     "lower insets there",
    "membrane.touches": "the {side} membrane nearly touches the body of {tile} (clearance "
                        "{clearance:.3g mm})",
    "membrane.slack": "the {side} membrane is slack beside {beside:8}",
    "sheet_tears": "more than 1 % of the membranes is stretched by {elongation:.3g} % or more, beyond "
                   "elongation_at_break ({limit:.3g} %): they tear; lower tau",
    "glue_shear": ("the glue on pins of {overloaded:8} may let go: on the {side} pin of {tile} it carries "
                   "{shear:.3g MPa} of shear, more than glue_strength ({limit:.3g MPa})",
                   "take a stronger glue, raise A_pin_min or lower tau"),
    "not_laid_out": "{said}",
    "piece_weak": "piece {piece} by itself: a contact point of {contact} has {least:.3g N}, less than f_min "
                  "= {f_min:.3g N} of this piece",
    # Settled forces.
    "settled_open": "the shape does not hold: the contacts {contacts:8} open as the tiles settle",
    "settled_drift": ("the shape does not hold: friction lets it drift by {drift:.3g mm}, more than "
                      "hold_tolerance ({most:.3g mm})",
                      "raise friction_coefficient, or choose bumps=dimples"),
    "settled_restless": "whether the shape holds is not known: the tiles do not come to rest",
    "settle_failed": "whether the shape holds is not known: {error}",
    # From flat to shape.
    "actuation_expected.closed": _EXPECTED + "all contacts close" + _PRESSED,
    "actuation_expected.open": _EXPECTED + "{open} of {count} contacts stay open" + _PRESSED,
    "actuation_relaxed": "without friction, its energy is least {mean:.3g mm} from the target in the mean, "
                         "{largest:.3g mm} at most; {open} of {count} contacts are open there",
    "actuation_by_itself": "released, it comes to rest {mean:.3g mm} from the target in the mean, "
                           "{largest:.3g mm} at most; {open} of {count} contacts stay open",
    "actuation_shaken": "shaken ({taps} taps), it comes to rest {mean:.3g mm} from the target in the mean, "
                        "{largest:.3g mm} at most; {open} of {count} contacts stay open",
    "actuation_pressed": "pressed over its former ({force_n:.3g N} a tile) and let go, it comes to rest "
                         "{mean:.3g mm} from the target in the mean, {largest:.3g mm} at most; {open} of "
                         "{count} contacts stay open",
    "actuation_restless.relaxed": "without friction, the tiles do not come to rest",
    "actuation_restless.by_itself": "released, the tiles do not come to rest",
    "actuation_restless.shaken": "shaken, the tiles do not come to rest",
    "actuation_restless.pressed": "pressed and let go, the tiles do not come to rest",
    "actuation_stopped": "the path from flat was stopped before its end",
    "unsettled_design": "the margin is required, and the tiles did not settle: set run_settling and "
                        "run_verification on",
    "margin": "the margin is not met: where the {side} membrane pulls {percent:.3g} % harder and friction is "
              "{mu:.3g}, pushing forces leave a least normal force of {least:.3g N}, less than f_min = "
              "{f_min:.3g N}, first at {contacts:8}",
    "margin.no_balance": "the margin is not met: where the {side} membrane pulls {percent:.3g} % harder and "
                         "friction is {mu:.3g}, no pushing forces balance the tiles: {pull:.3g N} of pull "
                         "would be needed, first at {contacts:8}",
    "margin.unknown": "whether the margin is met is not known: the forces at its corners could not be found",
    "verification_failed": "the design could not be verified: {error}",
    # Why there is no verdict.
    "unverified": "the design was not verified",
    "unverified.off": "verification was off",
    "unverified.export": "an export does not verify",
    "unverified.changed": "geometry changed since verification",
    "stopped": "stopped during {stage}",
    "stopped.unchecked": "stopped before all solids were checked",
    "refused": "{what} ({where}): {remedy}",
    "doubt": "the design is {state}: {reasons:; }",
    # Results in a document that are out of date.
    "changed.divided": "{names} changed since the target was divided: Solve brings it up to date",
    "changed.solved": "{names} changed since the layout was solved: Solve brings it up to date",
    "changed.built": "{names} changed since this was built: BuildSolids brings it up to date",
    "changed.judged": "{names} changed since the design was judged: Verify brings it up to date",
    "changed.risen": "{names} changed since the path was computed: Actuate brings it up to date",
    "changed.layout": "the layout changed since this was built: BuildSolids brings it up to date",
    "changed.source": "the target's source {name} changed since the layout was solved: Solve brings it up to "
                      "date",
    "changed.cuts": "the cuts changed since the layout was solved: Solve brings it up to date",
    "no_layout": "there is no layout yet: Solve makes it",
    "no_target": "the target was deleted: choose another with Target",
    "no_target.source": "the object that gave the target was deleted: choose another with Target",
    "unjudged": "it was not verified: Verify judges it",
    # A surface that is given.
    "empty": ("the surface has no faces", "check the file and its format"),
    "index-out-of-range": ("{count} faces name vertices that do not exist", "repair the file"),
    "not-finite": ("{count} vertices are not finite (vertices {vertices:#5})", "repair the file"),
    "degenerate-faces": ("{count} faces have no area", "remove them, or remesh"),
    "duplicate-faces": ("{count} faces are there twice", "remove the doubles"),
    "non-manifold-edges": ("{count} faces meet at edges of more than two faces",
                           "remove inner walls and doubled faces"),
    "inconsistent-orientation": ("{count} faces are turned against their neighbours",
                                 "make the normals consistent"),
    "one-sided": ("{count} faces lie where front meets back: the surface has one side",
                  "cut the band through, or model it with two sides"),
    "non-manifold-vertices": ("parts of the surface touch in single vertices (vertices {vertices:#5})",
                              "separate the parts"),
    "boundary-touches-itself": ("the boundary touches itself in single vertices (vertices {vertices:#5})",
                                "fill the gap or widen it"),
    "closed": ("the surface is closed: it can't lie flat in one piece",
               "let it be cut open (--auto-cuts 1) or divided (pieces=auto), give --cuts, or remove a part "
               "of it"),
    "self-intersections": ("{count} faces run through others of the same surface",
                           "repair the surface: tiles can't pass through one another"),
    "huge-coordinates": ("coordinates reach {largest:.4g mm}, where files lose digits",
                         "move the surface to the origin, or check its unit (scale)"),
    "too-small": ("the surface is {size:.4g mm} large, smaller than one tile of L = {L:.4g mm}",
                  "is it in metres or inches? set scale (1000 or 25.4), or choose a smaller L"),
    "too-large": ("the surface needs about {tiles_needed:.4g} tiles of L = {L:.4g mm}",
                  "check the unit of the file (scale), or choose a larger L"),
    "components": "the surface has {count} components, which are laid out side by side",
    # Its tiles.
    "sharp_fold": ("{count} tiles lie at folds sharper than a tile of thickness {H_body:.3g mm} can have: "
                   "their back faces vanish",
                   "lower H_body, raise L or smooth the target there (mend=on)"),
    "folded_over": ("{count} pairs of tiles overlap in the target and no plane separates them without "
                    "losing a contact",
                    "lower H_body, or keep parts of the target farther from one another"),
    "hinge": ("{count} contacts are only a hinge: truncation leaves no interface",
              "lower H_body or smooth the target there (mend=on)"),
    "small_pin": ("{count} pin sides can't reach A_pin_min ({A_pin_min:.3g mm2}); the smallest has "
                  "{least:.3g mm2}",
                  "lower H_body, p_min or A_pin_min, raise L or smooth the target there (mend=on)"),
    "edge_length": ("{count} tiles are far smaller or larger than L ({L:.3g mm})",
                    "let the target be remeshed"),
    "wall": ("the part is drawn {wall:.3g mm} thick, tiles are {H_body:g mm} thick", "set H_body={wall:.3g}"),
    "fold": "no back face: its folds are too sharp for tiles of this thickness",
    "pin": "its {side} pin has room for {area:.3g mm2}, less than A_pin_floor ({least:g mm2})",
    "overlap.bodies": "it runs through {other}, another part of the target, and no plane parts them",
    "overlap.pins": "{other}, another part of the target, faces it so near that pins between them would meet",
    "closed.tile": "its piece has no flat map: closed surfaces and handles have to be cut open first",
    "membrane.room": "its {side} membrane would cut into it at a sharp corner or fold: pins rise "
                     "{room:.2f mm} over it, {least:.2g mm} are wanted",
    "stretch": "the flat map scales it by {stretch:.2f}; it can do with {low:.2f} to {high:.2f}: cuts would "
               "even that out",
    "mending.remaining": ("mending left {at:6} with too little room for pins or under membranes",
                          "set mend_max above {most:g mm}, or another L or H_body"),
    "mending.far": ("tiles are up to {distance:.2f mm} from the target, more than mend_max ({most:g mm}): "
                    "they can't follow its corners and edges",
                    "lower L, or give edges that tiles must meet a crease_angle"),
    "followed": "the tiles follow the target: {kept} kept, {new} new",
    "followed.cuts": ("{count} edges of cuts are gone with their tiles", "check the cuts"),
    "tiled_anew": "the target is tiled anew: {why}",
    "follow.parts": "it has another number of parts or handles",
    "follow.borders": "it has another number of borders or holes",
    "follow.corners": "corners of its border have moved too far",
    "follow.creases": "it has other creases",
    "follow.edges": "tiles would be too large or too small for L",
    "follow.far": "its shape has changed too much",
    "follow.folded": "tiles would turn over",
    "follow.many": "too many tiles would be new",
    "pieces": ("the target is in {count} pieces, {asked} are asked for",
               "parts that it has already and cuts that are given count as well"),
    "pieces.stretched": ("no division into up to {most} pieces has as little stretch as membranes bear; the "
                         "best has {count}",
                         "set pieces to a number, or raise L"),
    # The layout and the design.
    "unsettled": "the layout did not converge in {iterations} iterations",
    "layout": "the layout did not converge in {iterations} iterations; all constraints hold",
    "gap": "flat tiles are {violation:.3g mm} nearer than d_gap_min ({pairs:6})",
    "gap.somewhere": "flat tiles are {violation:.3g mm} nearer than d_gap_min",
    "pin_bounds": "pin insets leave their bounds by {violation:.3g mm}",
    "pins_below_floor": "{count} pin sides are smaller than A_pin_floor ({at:6})",
    "overlap": "{count} pairs of tiles overlap when actuated and no plane parts them ({pairs:6})",
    "small_pin.side": "the {side} pin of {tile} has {area_mm2:.3g mm2}: valid, but less than A_pin_min asks "
                      "for",
    "relaxed.p_min": "p_min gives way on {count} edges of pins, where folds leave their pins no room: from "
                     "{before:.3g mm} to {after:.3g mm} at the {side} of {tile}",
    "relaxed.p_max": "p_max gives way on {count} edges of pins, where folds ask for less than pins that "
                     "face one another leave: from {before:.3g mm} to {after:.3g mm} at the {side} of {tile}",
    "flat_gap": "bumps stand into the gap between flat tiles, as walls are not recessed for their height: "
                "{left:.3g mm} of {asked:.3g mm} (d_gap_min) are left",
    "shortened": "{count} pairs of tiles without a common corner would overlap when actuated; interfaces "
                 "were shortened to part them: {pairs:6}",
    "hinge.design": "{count} contacts are only a hinge: nothing but the front edge touches",
    "stretched": ("the layout is badly stretched: its flat map scales tiles {spread:.3g} times differently, "
                  "and the membrane is slack at {slack} places",
                  "cut it as suggested"),
    "stretched.uncut": ("the layout is badly stretched: its flat map scales tiles {spread:.3g} times "
                        "differently, and the membrane is slack at {slack} places",
                        "no cut was found that is worth it"),
    # Bodies, solids and printers.
    "bodies_meet": "solids meet in the flat layout ({at})",
    "bodies_overlap": "actuated tiles overlap by {value:.3g mm3} ({at})",
    "unprintable": "the print can't be made: {error}",
    "unbuilt": "solids can't be built: {error}",
    "unsound": "solids are not sound: {solids:; }",
    "unsound.many": "solids are not sound: {solids:; } and {more} more",
    "unsound.solid": "{body}: {why}",
    "bare_interface": "{count} interfaces carry no bumps: {why}",
    "bare.edge_only": "the tiles touch along their front edge only",
    "bare.too_small": "too small for three bumps",
    "bare.would_touch": "bumps would touch the neighbour in the flat layout",
    "bare.would_break_through": "its hollows would break into another face",
    "loose": "{count} tiles are not held by the support",
    "loose.anchors": "{count} anchors are not held by the support",
    "joint.room": ("pins of at least A_pin_floor ({A_pin_floor:.3g mm2}) leave no room for stitching holes "
                   "of {joint_hole:.3g mm}",
                   "lower A_pin_floor or H_body, raise L, or set joint to none"),
    "overhang": ("tiles reach out level by up to {reach:.2g mm} beyond the pin they stand on, {H_pin:g mm} "
                 "above the bed; a {printer} prints {most:g mm} without supports",
                 "let the slicer put supports there, on the bed alone"),
    "overhang.front_down": ("tiles reach out level by up to {reach:.2g mm} beyond the pin they stand on, "
                            "{H_pin:g mm} above the bed; a {printer} prints {most:g mm} without supports",
                            "let the slicer put supports there, on the bed alone; with "
                            "orientation=front-up they come off once a membrane holds the tiles"),
    "joint.none": ("joint=holes, but no two pieces have a border in common: there is nothing to join",
                   "set pieces to auto or to 2 or more, or joint to none"),
    "joint": ("{closed} of {edges} edges between pieces have no room for stitching holes: {pairs}",
              "compute the layout again, lower A_pin_floor or H_body, raise L, or set joint to none"),
    "anchor": "the surplus membrane pulls with {pull:.3g N} at an anchor, whose glue then carries "
              "{shear:.3g MPa} of shear, more than glue_strength ({limit:g MPa}): raise anchor_radius",
    "bed": "the print ({x:.0f mm} x {y:.0f mm} x {z:.0f mm}) is larger than the bed of a {printer}",
    "material": ("the soluble slab is a second material; a {printer} prints one", "set support to breakaway"),
    "gap.printer": "tiles come as near as {clearance:.3g mm}; a {printer} needs {least:g mm}",
    "feature.slab": ("the slab's walls between tiles are as thin as {clearance:.3g mm}; a {printer} makes "
                     "{least:g mm}",
                     "raise d_gap_min, or set support to breakaway"),
    "feature": "{count} bodies have features smaller than a {printer} makes; {body}: {place}, {size:.3g mm}",
    "resolution.bumps": ("bumps are {height:g mm} high, less than the {least:g mm} that a {printer} resolves",
                         "set bumps to none, or raise bump_height"),
    "resolution.dimples": ("dimples are {clearance:g mm} wider than bumps, less than the {least:g mm} that "
                           "a {printer} resolves",
                           "set bumps to none"),
    "growth": "walls stand back by {set:g mm} for what prints grow; a {printer} grows walls by "
              "{grows:g mm}: raise xy_compensation",
    "thin_p_min": "p_min gave way to {least:.3g mm} at {at:6}, below what a {printer} makes ({makes:g mm}): "
                  "raise p_floor",
    # Repair and advice.
    "repair": "repair can't begin: {error}",
    "weak_contact": "contact {contact} has {share:.2f} of f_min: {why}",
    "weak_contact.friction": "contact {contact} keeps pushing forces within friction at {share:.2f} of "
                             "f_min: {why}",
    "held_by_nothing": "no small change of layout, pins or vertices lifts it",
    "broken_down": "repair ended early: {said}",
    "advice.cut_gaps": "a cut near the tiles named gives gaps room",
    "advice.pin_room": "a larger L, thinner tiles (H_body) or a smaller A_pin_min give pins room",
    "advice.pull": "another tau, or a smoother target near the tiles named, changes the membranes' pull "
                   "there",
    "suggested": "suggested: {what_to_do}",
    "cut": "a cut of {length:.0f mm} {why:; }",
    "cut.predicted": "a cut of {length:.0f mm} {why:; } (predicted: flat area {area_before:.2f} to "
                     "{area_after:.2f} times the actuated, slack membrane at {slack_before} to "
                     "{slack_after} places, energy per contact {energy_before:.2f} to {energy_after:.2f})",
    "cut.opens": "opens what is closed or has handles",
    "cut.tip": "to the tip at {tile}, which the flat map scales by {scale:.2g} of the mean",
    "cut.saddle": "into the saddle at {tile}, which the flat map scales by {scale:.2g} of the mean",
    "cut.weak_contact": "through the weak contact {contact}",
    "cut.hole": "joins the hole at {tile} to another boundary",
    "cuts": "cuts could not be looked for: {error}",
    "advice.mend_surface": "set mend=on ({actions})",
    "size": "{name}={value:g}",
    "check.clear": "all tiles can be made",
    "check.blocked": "{count} of {of} tiles can't be made ({at:6})",
    "check.likely": "{count} tiles are likely to fail ({at:6})",
    "sharp": ("fold of {radius:.2g mm} radius at {tile}: {least:.2g mm} would do at L {L:.4g mm}, "
              "H_body {H_body:g mm}"),
    "sharp.flat": ("pins of A_pin_floor have no room at L {L:.4g mm}, H_body {H_body:g mm}, even where it is "
                   "flat"),
    "limits.L": "L can be {low:g mm} to {high:g mm} (at H_body {H_body:g mm})",
    "limits.no_L": "no L was found at which all tiles can be made (at H_body {H_body:g mm})",
    "limits.H_body": "H_body can be up to {H_body:g mm} (at L {L:.4g mm})",
    "limits.no_H_body": "no H_body was found at which all tiles can be made (at L {L:.4g mm})",
    "limits.estimated": "these limits are estimates: Solve tells whether a design is valid",
    "size.L": "L = {value:g mm}",
    "size.H_body": "H_body = {value:g mm}",
    "tried.valid": "tried {sizes:, }: valid",
    "tried.not_valid": "tried {sizes:, }: not valid, {why:; }",
    "tried.blocked": "{count} of {of} tiles can't be made or are likely to fail",
    "tried.far": "the tiles are up to {distance:.2g mm} from the surface",
    "tried.error": "{error}",
    "tried.none": "no design with the sizes that were tried is valid",
}

SENTENCES: Mapping[str, tuple[str, str]] = {
    kind: (texts, "") if isinstance(texts, str) else texts for kind, texts in _TEXTS.items()}


def texts() -> set[str]:
    """All texts with words to translate."""
    sentences = (text for both in SENTENCES.values() for text in both)
    return {text for text in (*WORDS, *PROGRESS, *MARGINS, ESTIMATE, MORE, *sentences)
            if any(map(str.isalpha, "".join(literal for literal, *_ in Formatter().parse(text))))}
