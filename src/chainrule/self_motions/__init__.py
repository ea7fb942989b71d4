"""Self-motion: the curves of joint space along which the tip rests, for arms with one joint more than their task needs.

Lenarcic (1998) follows one such curve by the null eigenvector of J^T J. Here every curve is found: planar 3R arms in
closed form, any other arm by a continuation that cannot jump from one curve to another (:mod:`.continuation`).
"""
