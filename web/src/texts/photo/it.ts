/** Italian texts of the photo dialog. */
import type {PhotoTexts} from './en.js';

export const photo: PhotoTexts = {
  title: 'Foto della tua stoffa',
  intake:
    'Stendi la stoffa e fotografala dall’alto, in modo che si vedano almeno tre rapporti nei due sensi. Scegli l’immagine, trascinala qui o incollala.',
  stays: 'Resta su questo dispositivo.',
  choose: 'Scegli un’immagine',
  camera: 'Scatta una foto',
  another: 'Un’altra immagine',
  photo: 'Foto della stoffa',
  nodes: ['Angolo della cella', 'Estremo di w1', 'Estremo di w2'],
  ends: ['Primo punto misurato', 'Secondo punto misurato'],
  stages: {
    repeat: 'Ricerca del rapporto',
    light: 'Luce resa uniforme',
    symmetry: 'Confronto delle simmetrie',
    tile: 'Composizione della cella',
    object: 'Ricerca del contorno',
  },
  faults: {
    plain:
      'Nessuna stampa trovata, la stoffa sembra in tinta unita: fotografala con una luce più chiara da un lato.',
    noRepeat:
      'Nessun rapporto trovato: allontanati finché se ne vedono tre in ogni direzione, e fotografa la stoffa in piano e dall’alto.',
    fewRepeats:
      'Si vedono troppo pochi rapporti: allontanati finché ce ne sono tre in ogni direzione.',
    twoPrints:
      'Una parte dell’immagine mostra un’altra stampa, o nessuna: ritaglia l’immagine sulla stampa voluta.',
    changes:
      'La stampa cambia lungo la stoffa: fotografa una parte in cui tutti i rapporti sono uguali.',
    blurred:
      'L’immagine è sfocata: tieni ferma la fotocamera e lasciala mettere a fuoco sulla stoffa.',
    moire:
      'L’armatura crea un effetto moiré nell’immagine: fotografa la stoffa da un po’ più vicino o più lontano.',
    uneven: 'La stoffa non è distesa: lisciala e fotografala di nuovo.',
    misplaced:
      'La stampa non si ripete con questa cella: metti gli angoli sullo stesso punto di motivi vicini, o annulla.',
    edges:
      'I bordi dell’immagine non combaciano: dai il rapporto intero, o una foto che ne mostri diversi.',
    small: 'L’immagine è troppo piccola: danne una di almeno 32 pixel in ogni direzione.',
    object:
      'Lì non si vede alcun contorno simile: tocca il suo centro, oppure misura tra due punti.',
  },
  reading: (stage, percent) => `${stage}, ${percent}`,
  cancelled: 'Fermato.',
  again: 'Cerca di nuovo',
  byHand: 'Disegna la cella a mano',
  hand: 'Trascina l’angolo e le due frecce su un rapporto della stampa, poi:',
  alignHand: 'Cerca il rapporto da qui',
  found: (group) => `Trovato: ${group}.`,
  confidences: {
    likely: 'È probabile, ma confronta il campione con la tua stoffa.',
    uncertain:
      'Nessun rapporto è certo: scegli quello giusto, sposta gli angoli, o scatta un’altra foto con tre rapporti nei due sensi.',
  },
  others: 'O è uno di questi?',
  other: (number) => `Rapporto ${number}`,
  notes: {
    uneven: 'La stoffa non è del tutto distesa.',
    differs: 'Le zone rosse differiscono da tutte le altre copie e restano escluse.',
    focalLength: 'Misura lungo w1 e w2: altrimenti le proporzioni sono incerte.',
    unequal: 'I lati misurati sono diversi: vale una simmetria minore.',
  },
  lattice: 'Rapporto',
  how: 'Trascina gli angoli, o spostali con le frecce: il rapporto segue la stampa vicina. Con Alt resta dove lo metti.',
  twice: (vector) => `${vector} lungo il doppio`,
  half: (vector) => `${vector} lungo la metà`,
  halfDrop: 'A mezzo salto',
  group: 'Simmetria',
  verdicts: {
    has: 'ce l’ha',
    almost: 'quasi',
    'has not': 'non ce l’ha',
    cannot: 'impossibile con questo rapporto',
  },
  foundOne: 'trovata',
  breaks: (group) => `Dove ${group} non vale`,
  exact: 'Rendi esatte le simmetrie',
  show: 'Mostra',
  overlays: {
    cells: 'Celle',
    axes: 'Specchi e rotazioni',
    differing: 'Copie che differiscono',
    breaks: 'Dove rompe la simmetria',
  },
  flatten: 'Rendi uniforme la luce',
  white: 'Bilanciamento del bianco',
  tapWhite:
    'Tocca qualcosa di bianco nella foto. Oppure sposta l’anello con le frecce e premi Invio.',
  aimWhite: 'Qualcosa di bianco',
  asTaken: 'Colori originali',
  swatch: 'Campione, largo 3 rapporti',
  making: 'Il campione è in preparazione…',
  size: 'Misura',
  unknown:
    'Misura ignota: misurala in uno di questi modi. Prima puoi allineare la stampa, ma non tagliare.',
  repeatsAlong: (vector) => `Rapporti lungo ${vector}`,
  measure: (unit) => `misurano (${unit})`,
  measureBy: 'Misura con',
  measuring: {tape: 'Metro a nastro', points: 'Due punti', object: 'Moneta o tessera'},
  between: 'Trascina i due punti nella foto, poi scrivi quanto distano.',
  object: 'Quale',
  objects: {
    eur1: '1 euro, 23,25 mm',
    eur2: '2 euro, 25,75 mm',
    quarter: 'Quarto di dollaro, 24,26 mm',
    gbp1: '1 sterlina, 23,4 mm',
    card: 'Tessera, 85,60 × 53,98 mm',
    a4: 'Foglio A4, 297 × 210 mm',
  },
  aim: 'Centro della moneta o tessera',
  tap: 'Sta piatta sul tessuto: tocca il suo centro nella foto. Oppure sposta l’anello con le frecce e premi Invio.',
  look: 'Cercala presso l’anello',
  byObject: (error) => `Misurato con il contorno rosso, con un errore di circa ${error}.`,
  distance: (unit) => `Distanza tra loro (${unit})`,
  measures: (width, height) => `Un rapporto misura ${width} × ${height}.`,
  vectors: (w1, w2) => `w1 è lungo ${w1}, w2 ${w2}.`,
  sidesApart: (w1, w2, share, group) =>
    `Le tue misure differiscono del ${share}: un rapporto misura ${w1} lungo w1, ma ${w2} lungo w2, e ${group} vuole lati uguali. Vale ${w1} finché non ne rimuovi una, o scegli una simmetria che non li voglia.`,
  photoApart: (w1, w2, share, expected) =>
    `Le tue misure differiscono del ${share}: con ${w1} lungo w1, la foto mostra ${expected} lungo w2, non ${w2}. Valgono entrambe finché non ne rimuovi una.`,
  removeMeasure: 'Rimuovi questa misura',
  cloth: 'Sulla stoffa',
  turn: 'Gira di 90°',
  warp: (turn) => `La stampa è girata di ${turn}; la lunghezza della stoffa va verso l’alto.`,
  name: 'Nome',
  use: 'Usa questa stampa',
  useDoubtful: 'Usa benché incerta',
  doubt:
    'Non è certo che questa cella sia il rapporto della stampa: trascina i suoi angoli al loro posto, o scegline un’altra.',
};
