"""What is true of an arm: SymPy derives, CasADi differentiates and lowers, Jinja writes. Loads them only when used."""
