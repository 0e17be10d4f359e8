# fish completion for knotfit

set -l commands fit compare fit-curve parameterize eval distance info convert methods formats
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -f
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -l version -d 'Print the version'
complete -c knotfit -s h -l help -d 'Print help'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a fit -d 'Fit one B-spline surface to points, a mesh or terrain'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a compare -d 'Every placement method on the same data'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a fit-curve -d 'Fit one B-spline curve to ordered points'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a parameterize -d 'Give the vertices of a mesh parameters'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a eval -d 'Values, derivatives and differences of a surface'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a distance -d 'Distances between a surface and points or a mesh'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a info -d 'What a surface or a data file holds'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a convert -d 'Write a surface or data in another format'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a methods -d 'List the knot placement methods'
complete -c knotfit -n "not __fish_seen_subcommand_from $commands" -a formats -d 'List the file formats'

set -l fit "__fish_seen_subcommand_from fit"
set -l compare "__fish_seen_subcommand_from compare"
set -l curve "__fish_seen_subcommand_from fit-curve"
set -l both "__fish_seen_subcommand_from fit compare"
set -l fits "__fish_seen_subcommand_from fit compare fit-curve"
set -l eval "__fish_seen_subcommand_from eval"
set -l read "__fish_seen_subcommand_from fit compare fit-curve eval distance info convert"
set -l mesh "__fish_seen_subcommand_from fit compare parameterize"
complete -c knotfit -n "__fish_seen_subcommand_from parameterize" -l map -x -a 'newton mean-value' -d 'How a mesh is mapped'
complete -c knotfit -n "__fish_seen_subcommand_from parameterize" -l lines -x -d 'Parts between the lines of a picture'
set -l write "__fish_seen_subcommand_from fit compare fit-curve parameterize eval distance convert"
set -l list "__fish_seen_subcommand_from methods formats"

complete -c knotfit -n "__fish_seen_subcommand_from fit compare fit-curve parameterize eval distance info convert" -l input-format -x -a '(knotfit formats --names)' -d 'Format of the input'
complete -c knotfit -n $read -l columns -x -d 'What the columns are'
complete -c knotfit -n $read -l nodata -x -d 'Value that stands for a hole'
complete -c knotfit -n $write -s o -l output -r -d 'Output file, the format by its extension'
complete -c knotfit -n $write -l force -d 'Replace output files that exist'
complete -c knotfit -n "__fish_seen_subcommand_from fit compare fit-curve parameterize eval distance info methods formats" -l json -d 'JSON on standard output'
complete -c knotfit -n "__fish_seen_subcommand_from fit compare fit-curve parameterize eval distance" -l threads -x -d 'Threads'
complete -c knotfit -n "__fish_seen_subcommand_from fit convert" -l cell -x -d 'Cell size of an .asc output'
complete -c knotfit -n "__fish_seen_subcommand_from eval convert" -l grid -x -d 'Places over the domain, NxM'

complete -c knotfit -n $read -l unit -x -a 'mm m inch' -d 'Unit of STEP and IGES files'
complete -c knotfit -n "__fish_seen_subcommand_from eval distance info convert" -l face -x -d 'Which surface of a STEP or IGES file'
complete -c knotfit -n "__fish_seen_subcommand_from fit fit-curve convert" -l name -x -d 'Name of the part'
complete -c knotfit -n "__fish_seen_subcommand_from fit fit-curve convert" -l step-schema -x -a 'ap214 ap242' -d 'Schema of STEP outputs'
complete -c knotfit -n "__fish_seen_subcommand_from fit convert" -l cad-safe -d 'Faces that every CAD system digests'
complete -c knotfit -n "__fish_seen_subcommand_from fit convert" -l cad-tol -x -d 'What --cad-safe may move the surface by'

complete -c knotfit -n "__fish_seen_subcommand_from fit fit-curve distance" -l tol -x -d 'Largest error allowed, X or X%'
complete -c knotfit -n $fits -l within -x -d 'Share of the points that must hold it'
complete -c knotfit -n $fits -l rms -d 'The root mean square counts'
complete -c knotfit -n "__fish_seen_subcommand_from fit fit-curve" -l control-points -x -d 'Fixed size, NxM'
complete -c knotfit -n $fits -l degree -x -d 'Degree along u and v'
complete -c knotfit -n $fits -l max-control-points -x -d 'Most control points'
complete -c knotfit -n $fits -l max-fits -x -d 'Most linear fits'
complete -c knotfit -n $fit -l time-limit -x -d 'Seconds'
complete -c knotfit -n "__fish_seen_subcommand_from fit fit-curve" -l knots -x -a '(knotfit methods --names)' -d 'Placement method'
complete -c knotfit -n $fit -l knots-u -x -d 'Interior knots along u'
complete -c knotfit -n $fit -l knots-v -x -d 'Interior knots along v'
complete -c knotfit -n $fit -l knots-from -r -d 'Knots of a surface'
complete -c knotfit -n $fit -l refine -x -a 'search insert' -d 'Route to a tolerance'
complete -c knotfit -n $fits -l feature -x -a 'hessian curvature derivative residual' -d 'Feature measure'
complete -c knotfit -n $fits -l smoothing -x -d 'Relative smoothing floor'
complete -c knotfit -n $both -l height-field -d 'Fit z over x, y'
complete -c knotfit -n $fits -l spacing -x -a 'chord centripetal uniform' -d 'Parameters of rows'
complete -c knotfit -n $both -l rescale-parameters -d 'Map parameters to [0,1]'
complete -c knotfit -n $both -l duplicates -x -a 'fail mean lowest highest' -d 'Points with equal parameters'
complete -c knotfit -n $mesh -l fill-holes -d 'Fill holes of a raster or a mesh'
complete -c knotfit -n $mesh -l largest-part -d 'Keep the part of a mesh with the most area'
complete -c knotfit -n $mesh -l orient -d 'Turn triangles against their neighbours'
complete -c knotfit -n $mesh -l drop-degenerate -d 'Drop triangles of no area'
complete -c knotfit -n $fit -l correct -x -a 'auto off' -d 'Parameters corrected with the control points'
complete -c knotfit -n $mesh -l corners -x -a 'auto sharpest search' -d 'Corners of the square'
complete -c knotfit -n $mesh -l omega -x -d 'Weight of the normals in the map'
complete -c knotfit -n $fit -l new-parameters -d 'Map a mesh anew that has parameters'
complete -c knotfit -n "__fish_seen_subcommand_from fit convert" -l samples -x -d 'Samples a span of a mesh output'
complete -c knotfit -n $both -l between -x -a 'on off' -d 'Measure between the points'
complete -c knotfit -n "__fish_seen_subcommand_from distance" -l samples -x -d 'Samples of the surface, along u and v'
complete -c knotfit -n "__fish_seen_subcommand_from distance" -l quiet -d 'No progress and no summary'
complete -c knotfit -n $mesh -l quiet -d 'No progress and no summary'
complete -c knotfit -n $fit -l options -r -d 'Repeat stored options'
complete -c knotfit -n $fit -l no-height-field -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-rescale-parameters -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-fill-holes -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-largest-part -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-orient -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-drop-degenerate -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-new-parameters -d 'Undo a stored option'
complete -c knotfit -n $fit -l no-cad-safe -d 'Undo a stored option'

complete -c knotfit -n $fits -l evaluations -x -d 'Of an evolutionary search'
complete -c knotfit -n $curve -l knots-t -x -d 'Knots given'
complete -c knotfit -n $curve -l compare -x -a 'all (knotfit methods --names)' -d 'A table of methods'
complete -c knotfit -n $curve -l closed -d 'A closed curve'
complete -c knotfit -n $curve -l function -d 'y over x'
complete -c knotfit -n $curve -l corrected -d 'Move parameters to feet'
complete -c knotfit -n $curve -l quiet -d 'No progress and no summary'
complete -c knotfit -n $compare -l sizes -x -d 'Fixed sizes, NxM,...'
complete -c knotfit -n $compare -l tolerances -x -d 'Tolerances searched to'
complete -c knotfit -n $compare -l methods -x -a 'all (knotfit methods --names)' -d 'Placement methods'

complete -c knotfit -n $eval -l at -x -d 'One place, A,B'
complete -c knotfit -n $eval -l points -r -d 'Places of a file'
complete -c knotfit -n $eval -l clamp -d 'Move places outside to the border'
complete -c knotfit -n $eval -l derivatives -x -d 'All up to an order'
complete -c knotfit -n $eval -l derivative -x -d 'One derivative, A,B'
complete -c knotfit -n $eval -l normals -d 'Unit normals'
complete -c knotfit -n $eval -l curvature -d 'Curvatures'

complete -c knotfit -n $list -l names -d 'Names alone'
