"""What all pictures share: style, layout, markers, saving."""
