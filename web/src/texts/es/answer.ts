/** Spanish texts of the result: figures, notes, failures, remedies, lists and the element. */
import type {AnswerTexts} from '../en/answer.js';

export const answer: AnswerTexts = {
  headline: {
    fits: (mean) => `En las costuras, el estampado se desfasa ${mean} de media`,
    worst: (mean, seam) => `La peor, ${mean}: ${seam}.`,
    before: (mean) => `Antes, ${mean} de media.`,
    more: 'Más cifras',
    area: 'Longitud por desfase',
    noSeams: 'No hay costuras que casar',
    fit: 'Qué tal casa',
    percentOfRandom: (percent) => `${percent} de piezas puestas al azar`,
    proven: 'Ninguna otra colocación casa mejor.',
    nearlyProven: (percent) => `Ninguna otra colocación casa más de un ${percent} mejor.`,
    unproven: 'La mejor de las colocaciones probadas.',
    cost: 'Lo que cuesta la simetría',
    withSymmetry: 'Con simetría',
    withoutSymmetry: 'Sin ella',
    notes: 'Notas',
  },
  notes: {
    noSeams: 'El archivo no tiene costuras, así que no hay nada que casar.',
    noMatchedSeams: 'Ninguna costura ha de casar: cada una está desactivada o toca una pieza lisa.',
    gathered: (seams) =>
      `Un lado es más de una décima parte más largo (fruncidos, pliegues); el estampado no puede casar en todo su largo: ${seams}.`,
    unitsAssumed: 'El archivo no dice su unidad; se suponen centímetros.',
    curvesAssumed:
      'El archivo no dice cómo se escriben las curvas; se suponen puntos de control relativos.',
    lengthRatio: (seam, stated, drafted) =>
      `${seam}: según el archivo sus lados están en ${stated} a 1, según el dibujo en ${drafted} a 1; vale el dibujo.`,
    noMirrors: (pieces, group) =>
      `Un estampado del grupo ${group} no tiene espejos; esto no se mantiene simétrico: ${pieces}.`,
    noGlides: (pieces, group) =>
      `Un estampado del grupo ${group} no tiene espejos ni deslizamientos; estos pares no se mantienen: ${pieces}.`,
    symmetriesStated: 'Las simetrías son las que indica el archivo.',
    ws19: 'Este método no conoce simetrías de la prenda; no se mantiene ninguna.',
    grainAssumed: (pieces) =>
      `El archivo no da el hilo de estas piezas; se supone hacia arriba, como están dibujadas: ${pieces}.`,
    partOfTheWay:
      'Las costuras solo recorren parte del camino hacia sus líneas ideales; si no, se cruzarían contornos o cambiarían demasiado.',
    leftAsDrafted:
      'Ninguna forma encontrada encaja mejor que las piezas tal como están dibujadas, que conservan sus líneas.',
    dropped: (pieces, why) => `Se abandona la simetría de ${pieces}: ${why}.`,
    cannotHold: (pieces, why) => `La simetría de ${pieces} no es posible así: ${why}.`,
    why: {
      symmetryPins: 'fijado así, el estampado no se refleja ahí',
      symmetryGrain: 'con este estampado, algunas piezas dejarían su hilo',
      symmetryChange:
        'para reflejarse con exactitud, los contornos tendrían que cambiar más de lo permitido',
      symmetryKinks: 'para reflejarse con exactitud, los contornos tendrían quiebros o pliegues',
      symmetryLengths:
        'las costuras perderían su longitud, y el mayor cambio es demasiado pequeño para ello',
      symmetryCrossing: 'el contorno se cruzaría a sí mismo',
      symmetrySewn: 'sus bordes se cosen a bordes que no se reflejan',
    },
  },
  failures: {
    garment: (message) => `No se puede leer el patrón. En inglés: ${message}`,
    noGarment: (message) =>
      `No es un patrón que se pueda leer aquí: elige un archivo GarmentCode (JSON), un proyecto o un resultado. En inglés: ${message}`,
    solver: (message) => `El cálculo ha fallado. En inglés: ${message}`,
    noWorker: (message) =>
      `La página calcula por sí misma, más despacio, porque no puede arrancar ningún worker. En inglés: ${message}`,
    noWasm: (message) => `No se puede cargar el programa de cálculo. En inglés: ${message}`,
    picture: (file) => `${file} es una imagen; ábrela como estampado o elige un patrón.`,
    document: (file, kind) =>
      `${file} es ${kind}, que Seamwise no puede leer: elige DXF, SVG, OBJ o un archivo de GarmentCode para un patrón, o una imagen PNG, JPEG, WebP o SVG para un estampado.`,
    tooLarge: (file) => `${file} es demasiado grande para un patrón; elige otro archivo.`,
    noDesign: (file) => `${file} es un resultado sin su diseño; abre la prenda de la que salió.`,
    project: (message) => `No se puede leer el proyecto. En inglés: ${message}`,
  },
  remedies: {
    title: (count) => (count === 1 ? 'Una costura no casa' : `${count} costuras no casan`),
    more: (count) => `y ${count} más`,
    help: 'Qué ayudaría',
    why: {
      grain: 'al hilo, sus dos lados no pueden casar',
      gather: 'un lado va fruncido',
      group: 'el estampado no tiene un espejo para ella',
      size: 'el estampado es demasiado grande para ella',
      others: 'otras costuras de sus piezas van antes',
      locked: 'está bloqueada',
    },
    what: {
      turn: (pieces) => `Girar ${pieces} 90°`,
      ungather: () => 'Omitir los fruncidos',
      mirrors: () => 'Un estampado con espejos',
      smaller: () => 'Un estampado de la mitad de tamaño',
    },
    effect: (before, after) => `${before} → ${after}`,
  },
  lists: {
    pieces: 'Piezas',
    seams: 'Costuras',
    piece: 'Pieza',
    moved: 'Cambia',
    offGrain: 'Fuera de hilo',
    grain: 'Hilo',
    printed: 'Estamp.',
    seam: 'Costura',
    length: 'Longitud',
    before: 'Antes',
    after: 'Después',
    match: 'Casar',
    asAll: 'General',
    pinned: 'Fijada',
    free: 'Soltar',
    matches: {double: 'Doble', full: 'Pleno', half: 'Medio', none: 'No casar'},
    weight: (factor) => `× ${factor}`,
    size: (width, height) => `${width} × ${height}`,
    worst: (length) => `${length} en lo peor`,
    runsOff: (length) => `casa en un extremo, desfasada ${length} en el otro`,
    offAlong: (length) => `seguida a lo largo, desfasada hasta ${length}`,
    lost: 'el estampado no continúa a lo largo de ella',
    between: (a, b) => `${a} con ${b}`,
    within: (piece) => `${piece}, en la propia pieza`,
    numbered: (name, number) => `${name} ${number}`,
    of: (what, whose) => `${what}: ${whose}`,
    unknown: 'aún no se sabe',
    rename: 'Cambiar nombre',
    name: 'Nombre de la pieza',
    nameTaken: (name) => `Otra pieza ya se llama ${name}; dale a esta un nombre propio.`,
    quarterTurn: 'Girar 90 grados',
    turned: (piece) => `${piece}: girada 90 grados.`,
  },
  lens: {
    label: 'Lupa de costura',
    description:
      'Las flechas arriba y abajo van a las costuras con más y menos desfase, Escape suelta.',
    none: 'Aún no hay costura que mostrar.',
    nextWorst: 'Siguiente peor costura',
    previousWorst: 'Anterior peor costura',
    pin: 'Fijar',
    widen: 'Ampliar',
    rank: (rank, count) => `${rank} de ${count}`,
    mismatch: (before, after) => `Desfase ${before} antes, ${after} después`,
    ruler: (length) => `Una marca es ${length}`,
  },
  garment: {
    label: 'Patrón de costura en su estampado',
    required: 'El estampado aún no está casado; espera, o elige otro.',
    prints: 'Estampados',
    scale: (unit) => `Ancho del rapport (${unit})`,
    noGarment: 'No hay nada que mostrar: indica un patrón y un estampado.',
    noSize: (url) => `${url} tiene un lugar para la talla; indícala en el atributo 'size'.`,
    noAddress: (url) => `${url} no es una dirección; corrígela.`,
    notFound: (url) => `${url} no existe; corrige la dirección, o pon ahí el archivo.`,
    network: (url, reason) =>
      `${url} no se puede leer (${reason}); comprueba la conexión y el servidor.`,
    timeout: (url, seconds) => `${url} no se leyó en ${seconds} s; inténtalo de nuevo.`,
    tooLarge: (url, most) => `${url} ocupa más de ${most}; elige un archivo más pequeño.`,
    noPrint: (url) =>
      `${url} no es un archivo de estampado; da una imagen dentro de un estampado, con group, w1 y w2.`,
    notJson: (url) => `${url} no es JSON; elige otro archivo.`,
    noSymmetries: (url) => `${url} no contiene una lista de simetrías; corrígelo.`,
    notAnImage: (url) => `${url} no se puede leer como imagen; elige otra.`,
    fileChanged: (url) =>
      `${url} no es el archivo con el que se hizo el diseño; repón el anterior, o haz de nuevo el diseño.`,
    notStorable: (what) =>
      `${what} se dio como objeto; da su URL para que el diseño se pueda guardar.`,
    garment: 'El patrón',
    print: 'El estampado',
    noAnswer: 'Aún no hay solución que guardar; espérala con solve().',
    noCloth: "No hay tela sobre la que colocar nada; indica su ancho en el atributo 'cloth-width'.",
    noDrawing: 'Aún no hay nada dibujado; espéralo con solve().',
    pictureWidth: (most) =>
      `Una imagen mide de 1 a ${most} píxeles de ancho; pide uno de esos anchos.`,
    allowance: (most) => `Un margen mide de 0 a ${most}; pide uno así.`,
    noPicture: 'Este navegador no puede escribir la imagen; pide una más pequeña.',
    noTools: (reason) =>
      `No se puede cargar lo que hace falta (${reason}); comprueba la conexión y recarga la página.`,
    cancelled: 'El cálculo se ha cancelado.',
  },
};
