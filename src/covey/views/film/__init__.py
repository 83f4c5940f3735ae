"""Films of games, as GIF or MP4 files.

Read `animation` first: it has the public function. `frames` draws each frame; `gif` and `mp4` write
the frames to a file.
"""
