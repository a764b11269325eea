export const usage = `seamwise fits a repeating print to a sewing pattern.

seamwise align GARMENT.json [GARMENT.json ...] --print PRINT.json [flags]
  Aligns the print with every piece, deforms the pieces so that it matches at the seams,
  and prints one line of figures. Several garments, for one fabric, get one size of the print.
    --symmetry FILE|auto|none   mirror symmetries to keep; auto, the default, finds them
    --method best|paper|ws19    best, the default; the others are published methods to compare with
    --options FILE              weights, grain, pins and limits, as JSON
    --max-change CM             no outline moves further; 0 keeps every outline and only places
    --effort N                  looks N times as long, from 1, the default; never worse for it
    --effort auto               tries other seeds, until four in a row gain nothing or eight are tried
    --print-size 0.9..1.1       compares sizes of the print and takes the best; or a list, such as
                                0.95,1,1.05, always with 1; one number sets the size
    --print-turn 0,45,90        compares turns of the whole print, in degrees, and takes the best; one number sets it
    --grain-line PIECE=LINE     the grain line of a piece on which the maker draws several, by name or number;
                                may be repeated
    --shrinkage WARP,WEFT       of the fabric in the wash, in per cent; pieces are matched as after it, and cut larger
    --measured WxH              repeat as measured on the fabric, across and up, in cm, if it is not as stated; the
                                result keeps both, so that cut and marker need not be told again
    --seed N                    same seed, same input, same result; default 1
    --out RESULT.json           writes the solved pattern; of several garments with {garment} in its name
    --json                      prints the figures as JSON
    --no-times                  writes what equal runs give equal bytes of: times are 0, and
                                design and notes, which name files, are left out
    --no-remedies               does not look for what would make seams meet that stay off
    --others                    tells of other placings that fit about as well, for marker
    --design DESIGN.json        writes what was solved as a design that can be ordered

seamwise order DESIGN.json [flags]
  Solves a stored design again, from the garment and the print that it names, and says whether
  the answer is, byte for byte, the one that was sold: reproduced true or false.
    --base URL|FOLDER           what its relative URLs count from, and where its files have to be;
                                default its own folder, with files of the folder where you stand, too
    --out RESULT.json           writes the result, without times
    --record FILE.json          writes visible seams that match, length of fabric and a thumbnail
    --width CM                  fabric width of the record, with --selvedge CM at each edge, default 1
    --pdf FILE.pdf              writes the pieces to cut, at true scale; as one sheet with --svg FILE.svg,
                                for CAD programs with --dxf FILE.dxf, for plotters with --plt FILE.plt
    --paper a4|letter|...|WxH   of the PDF, as for cut; default a4
    --allowance CM, --hem CM    around them; default 1, and 3 at hems, or what --allowance says
    --ink full|pale|outline     in their print, the default, in a pale one, or lines alone
    --guide                     adds pages for placing them on fabric that is printed already
    --json                      prints the line as JSON

seamwise batch JOBS.ndjson --out FOLDER [flags]
  Solves every job of a file, one a line, on all cores, and goes on where an earlier run was cut short.
  Results lie in FOLDER/results, and FOLDER/done.ndjson has a line for each job that has ended. A job with
  "drape": true has its drape and its GLB there, too; one with "cut": {"paper": "a4", "allowance": 1} its PDF;
  one with "marker": {"width": 140} the plan of its pieces on fabric.
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

seamwise import FILE [flags]
  Reads a pattern of another program, PDF, DXF (AAMA, ASTM or plain), SVG, OBJ with texture coordinates, or
  a garment's JSON, and tells what is in it.
    --units mm|cm|in            in which unit it is, whatever it says; 300ppi: pixels per inch of an SVG
    --size NAME                 of a nest of sizes; default the one that the others were graded from
    --seams suggest|file|none   default: suggested where the file has none
    --scale 1:5                 of a drawing that is reduced, as in books
    --measure PIECE=CM          the longer side of a piece, which sets the scale of all
    --pages 3-26                pages of a PDF; default those that show the pattern
    --grid 4x6                  columns and rows of the pages of a PDF; default by their lines and names
    --trim CM, --overlap CM     of the pages of a PDF; default by their lines
    --allowance CM              which the lines of a PDF include; default 0
    --out GARMENT.json          writes it in the project's own format, seamwise-garment/1
    --json                      prints what was found as JSON

seamwise convert GARMENT.json [--plain] [--divide-pleats] [--out FILE.json]
seamwise convert GARMENT.json --to dxf [--allowance CM] [--sew-as-1] [--dxf-style ...] [--dxf-unit ...]
                 --out FILE.dxf
  Rewrites a garment in the project's own format, seamwise-garment/1.
    --to dxf                    as AAMA or ASTM DXF (R12): cut lines on layer 1, sewn ones on 14 where they differ
    --allowance CM              in DXF: beyond edges where the garment gives none; default 0
    --plain                     as a GarmentCode specification instead, which other programs read: paths become
                                single cubics, sewn one by one; cut-outs, grain and marks have no place there
    --divide-pleats             divides edges that run across pleats; their seams then count the pleated length

seamwise seams GARMENT.json --suggest [flags]
  Lists what every edge that is not sewn may be sewn to, the likeliest first, and which seams are as good as
  certain. Shapes decide, and the seams that the garment has.
    --strip                     as if it had none
    --confirm N                 with --strip: but for N of them, chosen by chance
    --seed N                    same seed, same choice; default 1
    --json                      prints them as JSON

seamwise draw RESULT.json --print PRINT.json [--colourway NAME] [--out PICTURE.svg] [--title TEXT] [--cloth-only]
  Draws the pieces on their print, before and after, with the mismatch along the seams.
    --cloth-only                without seams, axes and names over the print

seamwise cut RESULT.json [RESULT.json ...] --print PRINT.json [flags]
  Lays the pieces on a sheet at true scale, in their print, to print and to cut along, and prints one line: how many
  pages of which size. Without a file to write it only says that. Several results are sizes of one pattern, which
  --dxf and --pdf write as one nest; the first is the sample size. In a PDF each size is a layer.
    --colourway NAME            of the print
    --garment GARMENT.json      names, notches and grain lines; default the garment that the result holds
    --allowance CM              around pieces, where the garment gives none; default 1
    --hem CM                    of hems, where the garment gives none; default 3, or what --allowance says
    --sew-as-1                  in DXF: the sewn line on layer 1, the cut line on 14, as CLO expects them
    --dxf-style aama|astm       default aama; astm has validation copies of all lines
    --dxf-unit mm|in            default mm
    --paper a4|letter|a3|legal|tabloid   pages to glue; default a4
    --paper a2|a1|a0|36in       large sheets and rolls
    --paper projector           one page without margins, wide cut lines, no sewn lines, a grid of 5 cm
    --paper WxH[mm|cm|in]       any other
    --blank-pages               keeps blank pages, for programs such as PDFStitcher that join all rows
    --ink full|pale|outline     pale saves ink, outline leaves the print out
    --guide                     adds pages to the PDF that help to place the pieces on fabric that is
                                printed already: motifs at two or three points of each
    --language en|de|fr|es|it   of the words on the sheet; default en
    --font FILE.ttf             letters of other scripts in the PDF; it contains Latin, Greek, Cyrillic, Japanese
    --date YYYY-MM-DD           to stand on every page
    --pdf FILE.pdf, --svg FILE.svg, --dxf FILE.dxf, --plt FILE.plt (HP-GL)
    --map FILE.json             where pages, pieces, marks and test squares lie

seamwise repeat --print PRINT.json --out FILE.png|FILE.svg [flags]
  Writes the smallest upright rectangle that tiles the print in its true size, for a print shop. Where there is none,
  SVG has the cell as a pattern.
    --size 0.93                 size of the print as a multiple of its own
    --turn DEGREES              turns the print counter-clockwise
    --dpi N                     dots per inch of PNG; default 300
    --colourway NAME            of the print

seamwise photo PICTURE.jpg|png|webp [flags]
  Reads a print off a photograph or scan of its fabric: repeat, symmetries, and a clean picture.
    --measure w1=N/CM           so many repeats along w1 measure so many cm; again for w2
    --between X,Y,X,Y=CM        two points of the picture, in pixels, lie so far apart on the fabric
    --f35 MM                    focal length of the camera as on film; default what the file says
    --tile                      the picture is seamless: one cell, or several
    --symmetrise                makes the symmetries that it has exact
    --out PRINT.json            writes the print, its picture beside it as PNG
    --json                      prints what was found as JSON

seamwise marker RESULT.json [RESULT.json ...] --print PRINT.json --width CM [flags]
  Lays the pieces of one or several results on a bolt of their print, each where the print is what the result asks
  for, and prints one line: how much fabric that takes, and how little it can take. A project of the page counts as
  all of its garments, in its numbers of copies; they are solved on its print.
    --copies N[,N ...]          garments of each result: one number for all, or one for each, such as 2,1; default 1
    --selvedge CM               of no use along each edge of the fabric; default 1
    --gap CM                    between pieces; default 0.2
    --allowance CM, --hem CM    as for cut; --garment GARMENT.json, too
    --phase CM|any              from the left edge to an origin of the print; any, the default, tries several
    --start CM                  from the cut to an origin of the print; default: the fabric is cut anywhere
    --nap one-way|garment|none  heads up; or all of a garment the same way; default none, or one-way as the print is
    --shift kept|component      component: the print may move under all pieces that seams join, where it fits as well
    --plies N                   layers cut at once: lengths are whole repeats, so that all start alike
    --flaws FILE.json           polygons on the fabric, [[[x, y], ...], ...], where no piece may lie
    --fold                      lengthwise, cut through both plies: for pieces with mirror images, on prints that mirror
                                from side to side
    --free                      whatever the print: what it costs in fabric
    --effort N                  looks N times as long, from 1, the default, or 0: a first layout
    --seed N                    same seed, same layout; default 1
    --out PLAN.json             writes where every piece lies
    --svg FILE.svg              draws it at a tenth of its size; --pdf FILE.pdf too, --plotter FILE.pdf at true scale
    --dxf FILE.dxf              the pieces where they lie, for cutters; --dxf-style and --dxf-unit as for cut;
                                --plt FILE.plt for plotters
    --json                      prints the figures as JSON

seamwise drape RESULT.json --print PRINT.json [flags]
  Hangs a solved garment on a form, as it is worn, and prints one line of figures: how far the fabric is stretched
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

/** The part on a command; undefined for an unknown command. */
export function usageOf(command: string): string | undefined {
  const parts = usage.split(/\n(?=seamwise )/);
  const own = parts.filter((part) => part.startsWith(`seamwise ${command} `));
  return own.length > 0 ? own.map((part) => part.trimEnd()).join('\n') : undefined;
}
