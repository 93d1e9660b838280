# An image for continuous integration: the program and the Python module on Debian 12, without a GPU.
#
#   docker build -t steradian .
#   docker run --rm -v "$PWD:/work" steradian steradian golden run suite.json
#   docker run --rm -v "$PWD:/work" steradian pytest

FROM debian:12 AS build
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates git
WORKDIR /source
COPY . .
RUN git config --global --add safe.directory /source && tools/package deb wheel

FROM debian:12-slim
COPY --from=build /source/out/packages/*.deb /source/out/packages/*.whl /packages/
RUN apt-get update \
 && apt-get install -y --no-install-recommends /packages/*.deb git python3-venv \
 && python3 -m venv /opt/steradian \
 && /opt/steradian/bin/pip install --no-cache-dir /packages/*.whl pytest \
 && rm -rf /packages /var/lib/apt/lists/*
ENV PATH=/opt/steradian/bin:$PATH
WORKDIR /work
CMD ["steradian", "doctor"]
