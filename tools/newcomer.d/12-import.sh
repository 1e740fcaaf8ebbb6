# import marketgen within 0.3 s, from the environment, nothing of it from the clone
python -c 'import marketgen; print(marketgen.__file__)' | grep "^$VENV/"
python - <<'PYTHON'
import subprocess, sys, time

def seconds(code):
    began = time.monotonic()
    subprocess.run([sys.executable, "-c", code], check=True)
    return time.monotonic() - began

took = min(seconds("import marketgen") for _ in range(5)) - min(seconds("pass") for _ in range(5))
print(f"{took:.3f} s")
assert took <= 0.3, took
PYTHON
