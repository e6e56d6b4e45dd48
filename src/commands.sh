# SPDX-License-Identifier: BSD-3-Clause
# The commands of barreno, read by ./barreno of the source tree and by bin/barreno of an installation (src/installed.sh).
# Whoever reads it sets
#   name                the command as a user writes it: ./barreno or barreno
#   binary, library     the program and libBARRENO.so
#   python              the interpreter
#   python_path         folder of the Python package barreno
#   script_path         folders that a script of `python` imports from
#   more_commands       names of commands of its own
# and defines
#   prepare OFF         makes program and library, where they can be made
#   need_packages ...   sees to Debian packages of Python, plot_packages and the like

plot_packages=(python3 python3-numpy python3-matplotlib)
table_packages=("${plot_packages[@]}" python3-pandas)
report_packages=("${table_packages[@]}" python3-netcdf4 python3-jinja2)
fit_packages=("${plot_packages[@]}" python3-scipy)
uncertainty_packages=("${table_packages[@]}" python3-scipy)
commands=(run resume continue check jet report flow film join converge sweep uncertainty compare drive fit import-ups describe python)

usage() {
  sed "s|^barreno |$name |" <<'TEXT'
barreno run DECK [options]        compute (one rank per core)
    --ranks N   --out FOLDER   --overwrite   --fidelity fast|balanced|reference
    --set "List/Parameter=value"    (as often as needed; "List/Parameter=" removes a value or a list)
barreno resume FOLDER [--until TIME] [--ranks N]   continue from a run's last checkpoint
barreno continue FOLDER --deck DECK [--at-rest] [options of run]
                                  a deck that starts from the particles of a finished run (docs/continue.md)
barreno check DECK [--set ...] [--fidelity ...] [--ranks N]   validate a deck, print its plan and cost
barreno jet DECK [--cut-off VELOCITY] [--resistance STRESS] [--strength STRESS] [--out FOLDER] [--set ...] [--fidelity ...]
                                  the jet of a deck: table, audit, picture, depths by theory (docs/jets.md)
barreno report FOLDER [--left FIELD] [--right FIELD] [--time "30 us"] [--depths "30 mm, 60 mm"]
                [--particles "near tip"|ID,...] [--measured FILE] [--pdf]
                                  pictures and numbers of a run, one page: FOLDER/report/index.html (docs/report.md)
barreno flow FOLDER [--boundary radial|axial|both] [--time "200 us"] [--cell "1 mm"] [--ranks N] [--out FOLDER]
                                  how much flows through the shot rock into the hole, and its skin (docs/flow.md)
barreno film FOLDER --field FIELD [--right FIELD] [--out FILE.gif|.png|.mp4]   particles from the start to the end
barreno join FOLDER --out FILE    particles that every rank wrote into its own file (particles.e.N.0 ...) as one file
barreno converge DECK [--quantity NAME] [--times "10 us, 20 us"] [--levels 3] [--refine 2] [--out FOLDER]
                [--set ...] [--fidelity ...] [--ranks N]   cells of several sizes: order, limit, interval (docs/converge.md)
barreno sweep DECK --vary "LIST/NAME=VALUE,VALUE UNIT"... [--sample grid|list|latin] [--samples N] [--jobs N]
                [--out FOLDER] [--set ...] [--fidelity ...] [--ranks N] [--flow radial|axial|both]
                [--submit slurm] [--collect]
                                  several values of parameters, runs side by side: table, curves, channels (docs/sweep.md)
barreno uncertainty DECK [--vary "LIST/NAME=LOW..HIGH UNIT"]... [--ranges FILE.csv] [--hold LIST/NAME]... [--runs N]
                [--design latin|one-at-a-time] [--jobs N] [--out FOLDER] [--set ...] [--fidelity ...] [--ranks N]
                [--flow radial|axial|both] [--submit slurm] [--collect]
                                  how sure a depth is: intervals from ranges of the inputs, who contributes what (docs/uncertainty.md)
barreno compare RUN RUN... [--out FOLDER]   the same for runs at hand: how their decks and results differ
barreno drive --material CARD --path PATH --out OUT [--steps-per-row N] [--every-step] [--plot PNG]
                [--set PARAMETER=value]   one material point along a path of deformation, strain or stress
barreno fit DATA... --out CARD [--start CARD] [--fix NAME=value]... [--bounds NAME=low,high]...
                                  a card of Arenisca from laboratory tests, with ranges and a picture
barreno import-ups FILE [--out DECK] [--units NAME] [--card "MATERIAL=CARD"]   an input of Uintah as a deck (docs/import.md)
barreno describe [NAME]           the deck reference: a section, a model or a parameter
barreno python [SCRIPT] [words]   Python that finds the package barreno: import barreno (docs/python.md)
barreno --version                 of the code, its compiler and its libraries
TEXT
}

say() { printf 'barreno: %s\n' "$*" >&2; }

cores() {  # those of a batch job; else physical ones, which is what Open MPI counts as slots
  local physical available
  if [[ ${SLURM_NTASKS-} =~ ^[1-9][0-9]*$ ]]; then
    echo "$SLURM_NTASKS"
    return
  elif [[ -n ${PBS_NODEFILE-} && -s $PBS_NODEFILE ]]; then
    grep -c . "$PBS_NODEFILE"
    return
  fi
  physical=$(lscpu -b -p=Core,Socket 2>/dev/null | grep -v '^#' | sort -u | wc -l)
  available=$(nproc)
  ((physical > 0 && physical < available)) && echo "$physical" || echo "$available"
}

# Open MPI refuses root unless told twice, binds two ranks of every job to the same two cores, and in
# containers warns about a copy mechanism that it may not use. A waiting rank gives its core away: beside
# another busy process two ranks would otherwise take six times as long. A job with a node of its own sets its own
# (docs/cluster.md).
mpi_environment() {
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  export OMPI_MCA_hwloc_base_binding_policy="${OMPI_MCA_hwloc_base_binding_policy-none}"
  export OMPI_MCA_btl_vader_single_copy_mechanism="${OMPI_MCA_btl_vader_single_copy_mechanism-none}"
  export OMPI_MCA_mpi_yield_when_idle="${OMPI_MCA_mpi_yield_when_idle-1}"
}

# For ranks that are all on this machine: looking for networks takes a quarter of a start. A single rank does so by itself.
stay_on_this_machine() {
  export OMPI_MCA_pml="${OMPI_MCA_pml-ob1}" OMPI_MCA_btl="${OMPI_MCA_btl-self,vader}"
}

# mpirun, told to be quiet, would end without a word where ranks find no memory or no open files. The sentence on too many of
# them, and nothing where they can be started; barreno/runs/ranks.py asks this function too.
too_many() {  # option, its number of ranks
  local files memory most
  [[ -z ${SLURM_JOB_ID-}${PBS_NODEFILE-} || ${#2} -gt 9 ]] || return 0  # they may go to other machines
  files=$(ulimit -n)
  [[ $files == unlimited ]] && files=1000000
  memory=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB$/\1/p' /proc/meminfo 2>/dev/null || true)
  most=$((files / 10))  # mpirun holds pipes and sockets to each
  [[ -n $memory && $((memory / 65536)) -lt $most ]] && most=$((memory / 65536))  # 64 MB for each, without a particle
  most=$((most > 0 ? most : 1))
  if ((${#2} > 9 || $2 > most)); then
    printf '%s\n' "$1 is more than this machine can start ($most: each takes 64 MB of free memory and ten open files); it has $(cores) cores, and more ranks than cores are not faster."
  fi
}

check_ranks() {  # text behind --ranks
  local sentence
  if ! [[ $1 =~ ^[1-9][0-9]*$ ]]; then
    say "--ranks \"$1\" is not a number of ranks (1 or more); write for example --ranks 2."
    exit 1
  fi
  sentence=$(too_many "--ranks $1" "$1")
  if [[ -n $sentence ]]; then
    say "$sentence"
    exit 1
  fi
}

# Of converge, sweep and uncertainty, before anything is installed or built. A script for a batch system is for other machines.
check_ranks_in() {  # the words of the command
  local word ranks="" before=""
  for word in "$@"; do
    [[ $word != --submit* ]] || return 0
    [[ $before != --ranks ]] || ranks=$word
    [[ $word != --ranks=* ]] || ranks=${word#--ranks=}
    before=$word
  done
  [[ -z $ranks ]] || check_ranks "$ranks"
}

# mpirun answers Ctrl-C and the like by killing its ranks a second later and ends with 1; SIGUSR1 it passes on, and the
# ranks end behind a checkpoint. So it stands in a session of its own, gets SIGUSR1 for every signal that asks for the end,
# and the exit code is the one that belongs to the signal that came. A second one is meant seriously.
job="" asked=""
pass_on() {  # signal's number
  if [[ -z $asked ]]; then
    asked=$1
    [[ -z $job ]] || kill -USR1 "$job" 2>/dev/null || true
  elif (($1 == 1 || $1 == 2 || $1 == 15)); then
    [[ -z $job ]] || kill -TERM "$job" 2>/dev/null || true
  fi
}

# Lines from mpirun to a reader who may leave (| head): mpirun itself would not notice, or die of it.
relay_lines() {  # the launcher's process
  trap '' PIPE INT TERM HUP
  local line
  while IFS= read -r line || [[ -n $line ]]; do
    printf '%s\n' "$line" 2>/dev/null && continue
    kill -PIPE "$1" 2>/dev/null
    cat >/dev/null
  done
}

start_ranks() {  # mpirun's words
  local signal relay="" code=0
  for signal in HUP:1 INT:2 USR1:10 USR2:12 PIPE:13 TERM:15 XCPU:24; do
    # shellcheck disable=SC2064
    trap "pass_on ${signal#*:}" "${signal%:*}"
  done
  if [[ -p /dev/stdout ]]; then
    exec {screen}> >(relay_lines $$)
    relay=$!
  else
    exec {screen}>&1
  fi
  # Without its launcher nobody could stop it any more.
  setsid setpriv --pdeathsig USR1 mpirun "$@" >&"$screen" &
  job=$!
  exec {screen}>&-
  [[ -z $asked ]] || kill -USR1 "$job" 2>/dev/null || true
  while :; do
    wait "$job" && code=0 || code=$?
    kill -0 "$job" 2>/dev/null || break  # else a signal ended the wait, not the job
  done
  [[ -z $relay ]] || wait "$relay" || true
  # 138: the ranks ended for SIGUSR1; others are killed by mpirun at a second signal.
  [[ -n $asked && $code != 0 && $code != 2 ]] && code=$((128 + asked))
  exit "$code"
}

compute() {  # run, resume or continue, and its arguments
  local command=$1 ranks="" arguments=()
  shift
  while (($#)); do
    if [[ $1 == --ranks ]]; then
      ranks=${2-}
      check_ranks "$ranks"
      shift $(($# > 1 ? 2 : 1))
    else
      arguments+=("$1")
      shift
    fi
  done
  prepare OFF
  mpi_environment
  local available
  available=$(cores)
  ranks=${ranks:-$available}
  if ((ranks == 1)); then
    exec "$binary" "$command" "${arguments[@]}"
  fi
  local oversubscribe=()
  ((ranks > available)) && oversubscribe=(--oversubscribe)
  # The ranks cannot see whether a terminal watches: mpirun stands between.
  export BARRENO_TERMINAL=0
  [[ -t 1 ]] && BARRENO_TERMINAL=1
  start_ranks --quiet -n "$ranks" "${oversubscribe[@]}" "$binary" "$command" "${arguments[@]}"
}

start_python() {  # package, and its words
  export PYTHONPATH=$python_path${PYTHONPATH:+:$PYTHONPATH}
  exec "$python" -m "$@"
}

# Of a command that is a Python package its own page, where it can be shown; else the list of all.
help_of() {  # command
  local package=barreno.$1 words=(--help) page
  case $1 in
    report | film) package=barreno.report words=("$1" --help) ;;
    import-ups) package=barreno.imports ;;
    sweep) package=barreno.sweeps ;;
    join) package=barreno.runs.join_exodus ;;
    uncertainty) package=barreno.uncertainties ;;
    jet | flow | converge | compare | fit) ;;
    *) package="" ;;
  esac
  if [[ -n $package ]] && page=$(start_python "$package" "${words[@]}" 2>/dev/null); then
    printf '%s\n' "$page"
  else
    usage
  fi
}

# converge, sweep and uncertainty say a missing deck before anything is installed or built.
demand_deck() {  # command, example, and the words behind the command
  local command=$1 example=$2
  shift 2
  if (($# == 0)) || [[ $1 == -* ]]; then
    say "$command takes a deck, before its options; write for example $name $command input_xml/perforation_quick.xml $example."
    exit 1
  fi
  if [[ ! -f $1 ]]; then
    say "$1 does not exist (needed as the deck); check the path."
    exit 2
  fi
}

is_python_command() { [[ ${1-} =~ ^(jet|report|flow|film|join|converge|sweep|uncertainty|compare|fit|import-ups)$ ]]; }

carry_out() {  # the words of the command line
  local word example
  # Help needs neither packages nor a build.
  if [[ ${1-} != python ]] && { [[ ! -x $binary ]] || is_python_command "${1-}"; }; then
    for word in "${@:2}"; do
      if [[ $word == -h || $word == --help ]]; then
        help_of "$1"
        exit 0
      fi
    done
  fi
  case ${1-} in
    "" | -h | --help | help) usage ;;
    run | resume | continue) compute "$@" ;;
    report | film)
      if [[ $# == 1 || $2 == -* ]]; then
        example=$([[ $1 == report ]] && echo "report runs/perforation-1" || echo "film runs/perforation-1 --field pressure")
        say "$1 takes the folder of one run, before its options; write for example $name $example."
        exit 1
      fi
      if [[ ! -d $2 ]]; then
        say "'$2' is not a folder ($1 reads what a run wrote into it); check the path."
        exit 2
      fi
      need_packages "${report_packages[@]}"
      start_python barreno.report "$@"
      ;;
    flow)
      shift
      if (($# == 0)) || [[ $1 == -* ]]; then
        say "flow takes the folder of one run, before its options; write for example $name flow runs/perforation-1 --boundary radial."
        exit 1
      fi
      check_ranks_in "$@"
      need_packages "${report_packages[@]}"
      prepare OFF
      mpi_environment
      export BARRENO_PROGRAM=$binary
      start_python barreno.flow "$@"
      ;;
    join)
      shift
      if (($# == 0)) || [[ $1 == -* ]]; then
        say "join takes the folder of one run, before its options; write for example $name join runs/perforation-1 --out joined.e."
        exit 1
      fi
      need_packages python3 python3-numpy python3-netcdf4
      start_python barreno.runs.join_exodus "$@"
      ;;
    jet)
      shift
      demand_deck jet '--cut-off "2 km/s"' "$@"
      need_packages "${plot_packages[@]}"
      prepare OFF
      export BARRENO_PROGRAM=$binary
      start_python barreno.jet "$@"
      ;;
    converge)
      shift
      demand_deck converge "--levels 3" "$@"
      check_ranks_in "$@"
      need_packages "${table_packages[@]}"
      prepare OFF
      mpi_environment
      export BARRENO_PROGRAM=$binary
      [[ " $* " =~ " --ranks"[\ =] ]] || set -- "$@" --ranks "$(cores)"
      start_python barreno.converge "$@"
      ;;
    sweep)
      shift
      demand_deck sweep '--vary "Confinement/Pressure=0,34,69 MPa"' "$@"
      check_ranks_in "$@"
      # SciPy draws Latin hypercubes alone.
      if [[ " $* " == *latin* ]]; then need_packages "${report_packages[@]}" python3-scipy; else need_packages "${report_packages[@]}"; fi
      prepare OFF
      mpi_environment
      BARRENO_COMMAND="$(printf '%q' "$0") sweep"
      BARRENO_CORES=$(cores)
      export BARRENO_PROGRAM=$binary BARRENO_COMMAND BARRENO_CORES
      start_python barreno.sweeps "$@"
      ;;
    uncertainty)
      shift
      demand_deck uncertainty "--fidelity fast" "$@"
      check_ranks_in "$@"
      # The flow into holes is computed from their fields.
      if [[ " $* " == *" --flow"* ]]; then need_packages "${report_packages[@]}" python3-scipy; else need_packages "${uncertainty_packages[@]}"; fi
      prepare OFF
      mpi_environment
      BARRENO_COMMAND="$(printf '%q' "$0") uncertainty"
      BARRENO_CORES=$(cores)
      export BARRENO_PROGRAM=$binary BARRENO_COMMAND BARRENO_CORES
      start_python barreno.uncertainties "$@"
      ;;
    compare)
      shift
      if (($# < 2)); then
        say "compare takes the folders of two runs or more; write for example $name compare runs/perforation-1 runs/perforation-2."
        exit 1
      fi
      need_packages "${report_packages[@]}"
      start_python barreno.compare "$@"
      ;;
    fit)
      shift
      # Its words are looked at before anything is installed or built.
      if (($# == 0)); then
        say "fit takes the files of tests; write for example $name fit hydrostatic.csv triaxial_40MPa.csv --out card.xml."
        exit 1
      fi
      for word in "$@"; do
        if [[ $word == *.csv && $word != -* && ! -e $word ]]; then
          say "$word does not exist (needed as the data of a test); check the path."
          exit 2
        fi
      done
      need_packages "${fit_packages[@]}"
      prepare OFF
      export BARRENO_LIBRARY=$library
      start_python barreno.fit "$@"
      ;;
    import-ups)
      shift
      if (($# == 0)) || [[ $1 == -* ]]; then
        say "import-ups takes an input file of Uintah, before its options; write for example $name import-ups penetration.ups --out penetration.xml."
        exit 1
      fi
      if [[ ! -f $1 ]]; then
        say "$1 does not exist (needed as the input of Uintah); check the path."
        exit 2
      fi
      need_packages python3
      prepare OFF
      export BARRENO_PROGRAM=$binary
      start_python barreno.imports "$@"
      ;;
    python)
      if [[ $# == 2 && $2 =~ ^(-h|--help)$ ]]; then
        usage
        exit 0
      fi
      need_packages python3
      export PYTHONPATH=$script_path${PYTHONPATH:+:$PYTHONPATH}
      exec "$python" "${@:2}"
      ;;
    check | drive | describe | --version)
      prepare OFF
      if [[ $1 == drive && " $* " =~ " --plot"[\ =] && $* != *" --help"* ]]; then need_packages "${plot_packages[@]}"; fi
      mpi_environment
      exec "$binary" "$@"
      ;;
    *)
      local all=("${commands[@]}" "${more_commands[@]}")
      local listed
      printf -v listed '%s, ' "${all[@]:0:${#all[@]}-1}"
      say "\"$1\" is not a command; it is one of ${listed%, } and ${all[-1]}."
      exit 1
      ;;
  esac
}
