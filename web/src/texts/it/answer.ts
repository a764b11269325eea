/** Italian texts of the result: figures, notes, failures, remedies, lists and the element. */
import type {AnswerTexts} from '../en/answer.js';

export const answer: AnswerTexts = {
  headline: {
    fits: (mean) => `Alle cuciture la stampa scarta in media di ${mean}`,
    worst: (mean, seam) => `La peggiore, ${mean}: ${seam}.`,
    before: (mean) => `Prima, ${mean} in media.`,
    more: 'Altre cifre',
    area: 'Lunghezza per scarto',
    noSeams: 'Nessuna cucitura da far combaciare',
    fit: 'Quanto combacia',
    percentOfRandom: (percent) => `${percent} di pezzi posati a caso`,
    proven: 'Nessun’altra disposizione combacia meglio.',
    nearlyProven: (percent) => `Nessun’altra disposizione combacia meglio di oltre il ${percent}.`,
    unproven: 'La migliore delle disposizioni provate.',
    cost: 'Quanto costa la simmetria',
    withSymmetry: 'Con simmetria',
    withoutSymmetry: 'Senza',
    notes: 'Note',
  },
  notes: {
    noSeams: 'Il file non ha cuciture: non c’è nulla da far combaciare.',
    noMatchedSeams:
      'Nessuna cucitura deve combaciare: ognuna è disattivata o tocca un pezzo in tinta unita.',
    gathered: (seams) =>
      `Un lato è più lungo di oltre un decimo (arricciature, pieghe); la stampa non può combaciare ovunque: ${seams}.`,
    unitsAssumed: 'Il file non dice la sua unità; si suppongono centimetri.',
    curvesAssumed:
      'Il file non dice come sono scritte le curve; si suppongono punti di controllo relativi.',
    lengthRatio: (seam, stated, drafted) =>
      `${seam}: per il file i suoi lati stanno ${stated} a 1, nel disegno ${drafted} a 1; vale il disegno.`,
    noMirrors: (pieces, group) =>
      `Una stampa del gruppo ${group} non ha specchi, quindi questo non resta simmetrico: ${pieces}.`,
    noGlides: (pieces, group) =>
      `Una stampa del gruppo ${group} non ha specchi né scorrimenti, quindi queste coppie non restano simmetriche: ${pieces}.`,
    symmetriesStated: 'Le simmetrie sono quelle indicate nel file.',
    ws19: 'Questo metodo non conosce simmetrie del capo; nessuna viene mantenuta.',
    grainAssumed: (pieces) =>
      `Il file non dà il drittofilo di questi pezzi; si suppone verso l’alto, come disegnato: ${pieces}.`,
    partOfTheWay:
      'Le cuciture fanno solo parte della strada verso le loro linee ideali, altrimenti i contorni si incrocerebbero o cambierebbero troppo.',
    leftAsDrafted:
      'Nessuna forma trovata si accorda meglio dei pezzi come sono disegnati, che mantengono le loro linee.',
    dropped: (pieces, why) => `La simmetria di ${pieces} viene abbandonata: ${why}.`,
    cannotHold: (pieces, why) => `La simmetria di ${pieces} così non è possibile: ${why}.`,
    why: {
      symmetryPins: 'fissata così, la stampa lì non si specchia',
      symmetryGrain: 'su questa stampa alcuni pezzi lascerebbero il drittofilo',
      symmetryChange:
        'per specchiarsi esattamente, i contorni dovrebbero cambiare più del permesso',
      symmetryKinks: 'per specchiarsi esattamente, i contorni avrebbero spigoli o pieghe',
      symmetryLengths:
        'le cuciture perderebbero la loro lunghezza, e la modifica massima è troppo piccola',
      symmetryCrossing: 'il contorno incrocerebbe sé stesso',
      symmetrySewn: 'i suoi bordi sono cuciti a bordi che non si specchiano',
    },
  },
  failures: {
    garment: (message) => `Il cartamodello non è leggibile. In inglese: ${message}`,
    noGarment: (message) =>
      `Non è un cartamodello leggibile qui: scegli un file GarmentCode (JSON), un progetto o un risultato. In inglese: ${message}`,
    solver: (message) => `Il calcolo non è riuscito. In inglese: ${message}`,
    noWorker: (message) =>
      `La pagina calcola da sé, più lentamente, perché nessun worker può partire. In inglese: ${message}`,
    noWasm: (message) => `Il programma di calcolo non si carica. In inglese: ${message}`,
    picture: (file) => `${file} è un’immagine; aprila come stampa, o scegli un cartamodello.`,
    document: (file, kind) =>
      `${file} è ${kind}, che Seamwise non può leggere: scegli DXF, SVG, OBJ o un file di GarmentCode per un cartamodello, o un’immagine PNG, JPEG, WebP o SVG per una stampa.`,
    tooLarge: (file) => `${file} è troppo grande per un cartamodello; scegli un altro file.`,
    noDesign: (file) => `${file} è un risultato senza il suo progetto; apri il capo da cui è nato.`,
    project: (message) => `Il progetto non è leggibile. In inglese: ${message}`,
  },
  remedies: {
    title: (count) =>
      count === 1 ? 'Una cucitura non combacia' : `${count} cuciture non combaciano`,
    more: (count) => `e altre ${count}`,
    help: 'Che cosa aiuterebbe',
    why: {
      grain: 'in drittofilo i suoi due lati non combaciano',
      gather: 'un lato è arricciato',
      group: 'la stampa non ha uno specchio per questa',
      size: 'la stampa è troppo grande per questa',
      others: 'altre cuciture dei suoi pezzi vengono prima',
      locked: 'è bloccata',
    },
    what: {
      turn: (pieces) => `Gira ${pieces} di 90°`,
      ungather: () => 'Tralascia le arricciature',
      mirrors: () => 'Una stampa con specchi',
      smaller: () => 'Una stampa grande la metà',
    },
    effect: (before, after) => `${before} → ${after}`,
  },
  lists: {
    pieces: 'Pezzi',
    seams: 'Cuciture',
    piece: 'Pezzo',
    moved: 'Cambia',
    offGrain: 'Fuori filo',
    grain: 'Drittofilo',
    printed: 'Stampato',
    seam: 'Cucitura',
    length: 'Lunghezza',
    before: 'Prima',
    after: 'Dopo',
    match: 'Combacia',
    asAll: 'Generale',
    pinned: 'Fissato',
    free: 'Libera',
    matches: {double: 'Doppio', full: 'Pieno', half: 'Mezzo', none: 'Per niente'},
    weight: (factor) => `× ${factor}`,
    size: (width, height) => `${width} × ${height}`,
    worst: (length) => `al peggio ${length}`,
    runsOff: (length) => `combacia a un capo, scarta di ${length} all’altro`,
    offAlong: (length) => `seguita per tutta la lunghezza, scarta fino a ${length}`,
    lost: 'la stampa non prosegue lungo di essa',
    between: (a, b) => `${a} con ${b}`,
    within: (piece) => `${piece}, nel pezzo stesso`,
    numbered: (name, number) => `${name} ${number}`,
    of: (what, whose) => `${what}: ${whose}`,
    unknown: 'non ancora noto',
    rename: 'Rinomina',
    name: 'Nome del pezzo',
    nameTaken: (name) => `Un altro pezzo si chiama già ${name}; dai a questo un nome suo.`,
    quarterTurn: 'Gira di 90 gradi',
    turned: (piece) => `${piece}: girato di 90 gradi.`,
  },
  lens: {
    label: 'Lente di cucitura',
    description:
      'Le frecce su e giù vanno alle cuciture che scartano di più e di meno, Esc libera.',
    none: 'Ancora nessuna cucitura da mostrare.',
    nextWorst: 'Cucitura peggiore successiva',
    previousWorst: 'Cucitura peggiore precedente',
    pin: 'Fissa',
    widen: 'Ingrandisci',
    rank: (rank, count) => `${rank} di ${count}`,
    mismatch: (before, after) => `Scarto ${before} prima, ${after} dopo`,
    ruler: (length) => `Una tacca vale ${length}`,
  },
  garment: {
    label: 'Cartamodello nella sua stampa',
    required: 'La stampa non combacia ancora; aspetta, o scegline un’altra.',
    prints: 'Stampe',
    scale: (unit) => `Larghezza del rapporto (${unit})`,
    noGarment: 'Non c’è nulla da mostrare: indica un cartamodello e una stampa.',
    noSize: (url) => `${url} ha un posto per la taglia; indicala nell’attributo 'size'.`,
    noAddress: (url) => `${url} non è un indirizzo; correggilo.`,
    notFound: (url) => `${url} non esiste; correggi l’indirizzo, o metti lì il file.`,
    network: (url, reason) =>
      `${url} non si può leggere (${reason}); controlla la connessione e il server.`,
    timeout: (url, seconds) => `${url} non è stato letto in ${seconds} s; riprova.`,
    tooLarge: (url, most) => `${url} supera ${most}; scegli un file più piccolo.`,
    noPrint: (url) =>
      `${url} non è un file di stampa; dai un’immagine dentro una stampa, con group, w1 e w2.`,
    notJson: (url) => `${url} non è JSON; scegli un altro file.`,
    noSymmetries: (url) => `${url} non contiene un elenco di simmetrie; correggilo.`,
    notAnImage: (url) => `${url} non si può leggere come immagine; scegline un’altra.`,
    fileChanged: (url) =>
      `${url} non è il file con cui è stato fatto il modello; rimetti il precedente, o rifai il modello.`,
    notStorable: (what) =>
      `${what}: è stato dato un oggetto; dai l’URL, così il modello si può salvare.`,
    garment: 'Il cartamodello',
    print: 'La stampa',
    noAnswer: 'Non c’è ancora una soluzione da salvare; aspettala con solve().',
    noCloth:
      "Non c’è stoffa su cui disporre i pezzi; indicane la larghezza nell’attributo 'cloth-width'.",
    noDrawing: 'Non è ancora disegnato nulla; aspetta con solve().',
    pictureWidth: (most) =>
      `Un’immagine è larga da 1 a ${most} pixel; chiedi una di queste larghezze.`,
    allowance: (most) => `Un margine va da 0 a ${most}; chiedine uno così.`,
    noPicture: 'Questo browser non può scrivere l’immagine; chiedine una più piccola.',
    noTools: (reason) =>
      `Non si può caricare ciò che serve (${reason}); controlla la connessione e ricarica la pagina.`,
    cancelled: 'Il calcolo è stato interrotto.',
  },
};
