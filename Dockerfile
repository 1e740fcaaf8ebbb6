# MarketGen in a container. The first stage builds a wheel with every library inside (tools/wheels); the image has Python and that wheel.
#
#   docker build -t marketgen .
#   docker run --rm -v "$PWD:/work" --user "$(id -u):$(id -g)" marketgen generate "a kiosk with cold drinks" -o shop
FROM debian:12-slim AS build
WORKDIR /src
# Git says which commit the build is of.
# hadolint ignore=DL3008
RUN apt-get update && apt-get install -y --no-install-recommends git && rm -rf /var/lib/apt/lists/*
COPY . .
RUN tools/setup build && tools/wheels -o /wheels --python /usr/bin/python3

FROM debian:12-slim
# hadolint ignore=DL3008
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates python3 python3-venv && rm -rf /var/lib/apt/lists/*
COPY --from=build /wheels /wheels
RUN python3 -m venv /opt/marketgen && /opt/marketgen/bin/pip install --no-cache-dir /wheels/*.whl && rm -r /wheels
RUN useradd --uid 1000 --create-home marketgen && mkdir /work && chown marketgen /work
# The cache lies where any user may write: --user gives files to whoever started it.
ENV PATH=/opt/marketgen/bin:$PATH MARKETGEN_CACHE=/tmp/marketgen-cache
USER 1000
WORKDIR /work
ENTRYPOINT ["marketgen"]
CMD ["--help"]
