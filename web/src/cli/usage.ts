export const usage = `seamwise fits a repeating print to a sewing pattern.

seamwise align GARMENT.json --print PRINT.json [flags]
  Aligns the print with every piece, deforms the pieces so that it matches at the seams,
  and prints one line of figures.
    --symmetry FILE|auto|none   mirror symmetries to keep; auto, the default, finds them
    --method best|paper|ws19    best, the default; the others are published methods to compare with
    --options FILE              weights, grain, pins and limits, as JSON
    --max-change CM             no outline moves further; 0 keeps every outline and only places
    --effort N                  looks N times as long, from 1, the default; never worse for it
    --seed N                    same seed, same input, same result; default 1
    --out RESULT.json           writes the solved pattern
    --json                      prints the figures as JSON
    --no-times                  writes what equal runs give equal bytes of: times are 0, and
                                design and notes, which name files, are left out
    --no-remedies               does not look for what would make seams meet that stay off
    --design DESIGN.json        writes what was solved as a design that can be ordered

seamwise order DESIGN.json [flags]
  Solves a stored design again, from the garment and the print that it names, and says whether
  the answer is, byte for byte, the one that was sold: reproduced true or false.
    --base URL|FOLDER           what its relative URLs count from, and where its files have to be;
                                default its own folder, with files of the folder where you stand, too
    --out RESULT.json           writes the result, without times
    --svg FILE.svg              writes the pieces to cut, at true scale
    --allowance CM              around them; default 1
    --json                      prints the line as JSON

seamwise batch JOBS.ndjson --out FOLDER [flags]
  Solves every job of a file, one a line, on all cores, and goes on where an earlier run was cut short.
  Results lie in FOLDER/results, and FOLDER/done.ndjson has a line for each job that has ended. A job with
  "drape": true has its drape and its GLB there, too.
    --workers N                 threads; default one per core
    --job-timeout SECONDS       ends a job that takes longer, and records it as failed; default 600, 0 for never
    --retry-timeouts            tries the jobs again that took too long
    --check                     solves again what is not the result on record any more
    --queue redis://HOST:PORT[/DB]   hands the jobs to a queue, from which others take them, too;
                                needs the packages bullmq and ioredis, and a private server
    --json                      prints the sum as JSON
seamwise batch --work --queue redis://HOST:PORT[/DB] --out FOLDER [--workers N] [--job-timeout SECONDS]
  Takes jobs from the queue of that folder, which all machines share, until it is interrupted.

seamwise symmetries GARMENT.json [--out FILE.json]
  Lists the symmetries that the garment shows by itself, in the format of a symmetry file.

seamwise convert GARMENT.json [--out FILE.json]
  Rewrites a garment in the project's own format, seamwise-garment/1.

seamwise draw RESULT.json --print PRINT.json [--colourway NAME] [--out PICTURE.svg] [--title TEXT] [--cloth-only]
  Draws the pieces on their print, before and after, with the mismatch along the seams.
    --cloth-only                without seams, axes and names over the print

seamwise drape RESULT.json --print PRINT.json [flags]
  Hangs a solved garment on a form, as it is worn, and prints one line of figures: how far the cloth is stretched
  and how deep it reaches into the form at the worst.
    --colourway NAME            of the print
    --fabric poplin|jersey|denim|chiffon   what it is made of; default poplin
    --size XS|S|M|L|XL          of the form; default that of the garment's file, or the middle one
    --body BODY.json            a form by measurements in cm, instead
    --effort 1|2|4              settles so much longer; default 1
    --out DRAPE.json            writes the draped garment with its form, to look at and measure
    --glb FILE.glb              writes it in its print as binary glTF; the print's picture has to be PNG or JPEG
    --form                      with the form as a node of its own
    --attributes                with the piece and the place on the cut piece of every vertex
    --json                      prints the figures as JSON
    --no-times                  writes what equal runs give equal bytes of: times are 0

seamwise dump GARMENT.json --print PRINT.json --out FOLDER [flags]
  Draws what a solve goes through, for those who look into it: an SVG file for each stage (as drafted, every
  better placing that the search tells of, placed, shaped) with meshes, seams, their letters and the print's cells.
    --symmetry, --method, --options and --seed are those of align

seamwise --version
seamwise --help

Exit code: 0 done; 2 bad input, with one sentence that says what is wrong; 3 an order whose answer is not
the one that was sold; 1 anything else, such as a job of a batch that failed; 130 a batch that was interrupted.
`;
