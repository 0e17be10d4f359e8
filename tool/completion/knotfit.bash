# bash completion for knotfit

_knotfit() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command="" word options=""
  local tool=${COMP_WORDS[0]}
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in fit | compare | fit-curve | parameterize | eval | distance | info | convert | methods | formats) command=$word; break ;; esac
  done

  case $previous in
    --knots) COMPREPLY=($(compgen -W "$("$tool" methods --names 2>/dev/null)" -- "$current")); return ;;
    --methods | --compare) COMPREPLY=($(compgen -W "all $("$tool" methods --names 2>/dev/null)" -- "$current")); return ;;
    --input-format) COMPREPLY=($(compgen -W "$("$tool" formats --names 2>/dev/null)" -- "$current")); return ;;
    --refine) COMPREPLY=($(compgen -W "search insert" -- "$current")); return ;;
    --effort) COMPREPLY=($(compgen -W "fast balanced best" -- "$current")); return ;;
    --guard) COMPREPLY=($(compgen -W "on off" -- "$current")); return ;;
    --feature) COMPREPLY=($(compgen -W "hessian curvature derivative residual" -- "$current")); return ;;
    --spacing) COMPREPLY=($(compgen -W "chord centripetal uniform" -- "$current")); return ;;
    --map) COMPREPLY=($(compgen -W "newton mean-value" -- "$current")); return ;;
    --correct | --weld) COMPREPLY=($(compgen -W "auto off" -- "$current")); return ;;
    --corners) COMPREPLY=($(compgen -W "auto sharpest search" -- "$current")); return ;;
    --duplicates) COMPREPLY=($(compgen -W "fail mean lowest highest" -- "$current")); return ;;
    --returns) COMPREPLY=($(compgen -W "first last" -- "$current")); return ;;
    --base) COMPREPLY=($(compgen -W "auto plane cylinder graph" -- "$current") $(compgen -f -- "$current")); return ;;
    --unit) COMPREPLY=($(compgen -W "mm m inch" -- "$current")); return ;;
    --step-schema) COMPREPLY=($(compgen -W "ap214 ap242" -- "$current")); return ;;
    --between) COMPREPLY=($(compgen -W "on off" -- "$current")); return ;;
    --points | --options | --knots-from | --feature-file | -o | --output) COMPREPLY=($(compgen -f -- "$current")); return ;;
    --tol | --sizes | --tolerances | --evaluations | --knots-t | --within | --control-points | --degree | --shear | --max-control-points | --max-fits | --time-limit | \
      --knots-u | --knots-v | --smoothing | --columns | --nodata | --skip-lines | --block | --classes | --cell | --threads | --at | --grid | \
      --derivatives | --derivative | --omega | --fairness | --samples | --lines | --name | --cad-tol | --face) return ;;
  esac

  if [[ -z $command ]]; then
    COMPREPLY=($(compgen -W "fit compare fit-curve parameterize eval distance info convert methods formats --help --help-all --version" -- "$current"))
    return
  fi
  local input="--input-format --columns --nodata --skip-lines --classes --returns" output="-o --output --force --overwrite"
  local mesh="--weld --largest-part --orient --drop-degenerate --corners --omega --fill-holes"
  local surface="--unit --face" cad="--name --step-schema --cad-safe --cad-tol"
  case $command in
    fit)
      options="--tol --within --rms --control-points --degree --shear --max-control-points --max-fits --time-limit
        --knots --knots-u --knots-v --knots-from --refine --effort --guard --feature --feature-file --evaluations --smoothing
        $input --height-field
        --spacing --rescale-parameters --duplicates --base $mesh --new-parameters --correct --fairness $output --samples --reflections --unit $cad --cell --json --between
        --threads -q --quiet --options --no-height-field --no-rescale-parameters --no-fill-holes --no-largest-part
        --no-orient --no-drop-degenerate --no-new-parameters --no-cad-safe" ;;
    compare)
      options="--sizes --tolerances --methods --within --rms --degree --evaluations --max-control-points --max-fits
        --feature --feature-file --smoothing $input --height-field --spacing --rescale-parameters --duplicates --base
        $mesh $output --json --between --threads -q --quiet" ;;
    fit-curve)
      options="--tol --within --rms --control-points --degree --max-control-points --max-fits --time-limit --knots
        --knots-t --compare --feature --feature-file --evaluations --smoothing $input --block --closed --function --spacing --corrected $output
        --unit --name --step-schema --json --threads -q --quiet" ;;
    parameterize) options="$mesh --map --lines --input-format $output --json --threads -q --quiet" ;;
    eval)
      options="--at --points --grid --clamp --derivatives --derivative --normals --curvature $surface $input $output
        --json --threads" ;;
    distance) options="--tol --samples --weld $surface $input $output --json --threads -q --quiet" ;;
    info) options="$surface $input --weld --json" ;;
    convert) options="$surface $input --weld $output $cad --samples --reflections --cell --grid" ;;
    methods | formats) options="--names --json" ;;
  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options --help --help-all" -- "$current"))
  elif [[ $command != methods && $command != formats ]]; then
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}
complete -o filenames -F _knotfit knotfit
