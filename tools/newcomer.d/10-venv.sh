# an empty virtual environment !
"$NEWCOMER_PYTHON" -m venv "$VENV"
