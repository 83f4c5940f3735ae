"""What all pictures share: colours, markers, layout, labels and files.

Read `style` and `markers` first, then `page` (figures and axes of exact size), `layout` (maps and
panels) and `sampling` (points along lines), on which `point_labels` and `close_up` build.
`time_format` and `saving` stand alone.
"""
