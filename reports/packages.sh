# The Debian packages that pmreport needs, and what installs those that are missing. Sourced by reports/run.sh, tests/run.sh and .ci/run.
# shellcheck shell=sh disable=SC2034  # the lists are for those who source this

program_packages="g++ cmake ninja-build pkg-config libeigen3-dev libboost-dev libosmesa6-dev libgl-dev libcairo2-dev libpango1.0-dev
  libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libfmt-dev libtbb-dev libnlopt-dev libpng-dev libqpdf-dev libpolyclipping-dev fonts-dejavu-core"
test_packages="catch2 libxml2-utils locales nodejs poppler-utils qpdf openmpi-bin libopenmpi-dev"
judge_packages="libsimbody-dev libmujoco-dev calculix-ccx libmpfi-dev libflint-dev libflint-arb-dev" # other programs for the dynamics of bodies, for elasticity and for intervals, which the tests hold ours against
style_packages="clang-format git"

# install_packages NAME...: installs what is missing and touches nothing when all is there.
install_packages() {
  missing=
  for package in "$@"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || status=
    [ "$status" = installed ] || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0

  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and neither root nor sudo is at hand to install them:$missing" >&2
      return 1
    fi
    as_root=sudo
  fi
  echo "Installing:$missing"
  $as_root apt-get update -qq || return
  # shellcheck disable=SC2086  # a list of words
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends $missing </dev/null >/dev/null
}
