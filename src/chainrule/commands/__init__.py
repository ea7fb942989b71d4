"""The commands of ``chainrule``, one file for each or for a few that belong together."""
