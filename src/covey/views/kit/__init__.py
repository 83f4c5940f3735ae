"""What all pictures share: colours, markers, layout, labels and files.

Read `style` and `markers` first, then `layout` (figures and axes of exact size) and `sampling`
(points along lines), on which `point_labels` builds. `time_format` and `saving` stand alone.
"""
