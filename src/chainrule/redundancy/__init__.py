"""Following a path with spare joints: the law of each step, whole runs, many at once, and the price of each way."""
