#!/bin/sh
# Tests coarse validation cases against exact solutions (tests/validate_fast.py prints the errors).
export OMP_WAIT_POLICY=passive PYTHONDONTWRITEBYTECODE=1
exec python3 tests/validate_fast.py
