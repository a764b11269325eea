/** German texts of the result: figures, notes, failures, remedies, lists and the element. */
import type {AnswerTexts} from '../en/answer.js';

export const answer: AnswerTexts = {
  headline: {
    fits: (mean) => `An den Nähten ist das Muster im Mittel um ${mean} versetzt`,
    worst: (mean, seam) => `Schlechteste ${mean}: ${seam}.`,
    before: (mean) => `Vorher im Mittel ${mean}.`,
    more: 'Weitere Zahlen',
    area: 'Länge mal Versatz',
    noSeams: 'Keine Nähte, die sich treffen könnten',
    fit: 'Wie gut es sich trifft',
    percentOfRandom: (percent) => `${percent} von zufällig gelegten Teilen`,
    proven: 'Keine andere Lage passt besser.',
    nearlyProven: (percent) => `Keine andere Lage passt mehr als ${percent} besser.`,
    unproven: 'Die beste aller versuchten Lagen.',
    cost: 'Was die Symmetrie kostet',
    withSymmetry: 'Mit Symmetrie',
    withoutSymmetry: 'Ohne',
    notes: 'Hinweise',
  },
  notes: {
    noSeams: 'Die Datei hat keine Nähte, also gibt es nichts zu treffen.',
    noMatchedSeams:
      'Keine Naht soll sich treffen: Jede ist ausgeschaltet oder grenzt an ein unbedrucktes Teil.',
    gathered: (seams) =>
      `Eine Seite ist um mehr als ein Zehntel länger (Kräuselung, Falten), das Muster kann sich also nicht überall treffen: ${seams}.`,
    unitsAssumed: 'Die Datei nennt keine Einheit; angenommen sind Zentimeter.',
    curvesAssumed:
      'Die Datei sagt nicht, wie Kurven geschrieben sind; angenommen sind relative Kontrollpunkte.',
    lengthRatio: (seam, stated, drafted) =>
      `${seam}: Laut Datei stehen die Seiten ${stated} zu 1, gezeichnet ${drafted} zu 1; es gilt die Zeichnung.`,
    noMirrors: (pieces, group) =>
      `Ein Muster der Gruppe ${group} hat keine Spiegelungen, deshalb bleibt dies nicht symmetrisch: ${pieces}.`,
    noGlides: (pieces, group) =>
      `Ein Muster der Gruppe ${group} hat weder Spiegelungen noch Gleitspiegelungen, deshalb bleiben diese Paare nicht gespiegelt: ${pieces}.`,
    symmetriesStated: 'Die Symmetrien sind die, die in der Datei stehen.',
    ws19: 'Dieses Verfahren kennt keine Symmetrie des Schnitts, also wird keine gehalten.',
    grainAssumed: (pieces) =>
      `Die Datei hat für diese Teile keinen Fadenlauf, angenommen ist er nach oben wie gezeichnet: ${pieces}.`,
    partOfTheWay:
      'Die Nähte gehen nur einen Teil des Wegs zu ihren besten Linien, sonst kreuzten sich Umrisse oder änderten sich zu stark.',
    leftAsDrafted:
      'Keine gefundene Form passt besser als der Schnitt, wie er gezeichnet ist; die Teile behalten ihre Linien.',
    dropped: (pieces, why) => `Die Symmetrie von ${pieces} entfällt: ${why}.`,
    cannotHold: (pieces, why) => `Die Symmetrie von ${pieces} ist so nicht möglich: ${why}.`,
    why: {
      symmetryPins: 'so festgesteckt spiegelt sich das Muster dort nicht',
      symmetryGrain: 'auf diesem Muster lägen Teile nicht mehr im Fadenlauf',
      symmetryChange: 'für genaue Spiegelung müssten sich Umrisse stärker ändern als erlaubt',
      symmetryKinks: 'für genaue Spiegelung bekämen Umrisse Knicke oder Falten',
      symmetryLengths: 'Nähte verlören ihre Länge, und die größte Änderung ist zu klein dafür',
      symmetryCrossing: 'der Umriss kreuzte sich selbst',
      symmetrySewn: 'seine Kanten sind an Kanten genäht, die sich nicht spiegeln',
    },
  },
  failures: {
    garment: (message) => `Der Schnitt lässt sich nicht lesen. Auf Englisch: ${message}`,
    noGarment: (message) =>
      `Das ist kein Schnitt, der sich lesen lässt; bitte eine GarmentCode-Datei (JSON), ein Projekt oder ein Ergebnis wählen. Auf Englisch: ${message}`,
    solver: (message) => `Das Berechnen ist gescheitert. Auf Englisch: ${message}`,
    noWorker: (message) =>
      `Die Seite rechnet selbst, was langsamer geht, weil kein Worker starten kann. Auf Englisch: ${message}`,
    noWasm: (message) => `Das Rechenprogramm lässt sich nicht laden. Auf Englisch: ${message}`,
    picture: (file) => `${file} ist ein Bild; als Muster öffnen, oder einen Schnitt wählen.`,
    document: (file, kind) =>
      `${file} ist ${kind}; das kann Seamwise nicht lesen: für einen Schnitt DXF, SVG, OBJ oder eine Datei von GarmentCode wählen, für ein Muster ein Bild als PNG, JPEG, WebP oder SVG.`,
    tooLarge: (file) => `${file} ist zu groß für einen Schnitt; eine andere Datei wählen.`,
    noDesign: (file) =>
      `${file} ist ein Ergebnis ohne seinen Entwurf; den Schnitt öffnen, aus dem es entstand.`,
    project: (message) => `Das Projekt lässt sich nicht lesen. Auf Englisch: ${message}`,
  },
  remedies: {
    title: (count) =>
      count === 1 ? 'Eine Naht trifft sich nicht' : `${count} Nähte treffen sich nicht`,
    more: (count) => `und ${count} weitere`,
    help: 'Was helfen würde',
    why: {
      grain: 'im Fadenlauf passen ihre beiden Seiten nicht aneinander',
      gather: 'eine Seite ist gekräuselt',
      group: 'dem Muster fehlt die Spiegelung dafür',
      size: 'das Muster ist zu groß dafür',
      others: 'andere Nähte dieser Teile gehen vor',
      locked: 'sie ist gesperrt',
    },
    what: {
      turn: (pieces) => `${pieces} um 90° drehen`,
      ungather: () => 'Kräuselungen weglassen',
      mirrors: () => 'Ein Muster mit Spiegelungen',
      smaller: () => 'Ein halb so großes Muster',
    },
    effect: (before, after) => `${before} → ${after}`,
  },
  lists: {
    pieces: 'Teile',
    seams: 'Nähte',
    piece: 'Teil',
    moved: 'Geändert',
    offGrain: 'Zum Faden',
    grain: 'Fadenlauf',
    printed: 'Muster',
    seam: 'Naht',
    length: 'Länge',
    before: 'Vorher',
    after: 'Nachher',
    match: 'Anpassen',
    asAll: 'Wie alle',
    pinned: 'Festgesteckt',
    free: 'Lösen',
    matches: {double: 'Doppelt', full: 'Voll', half: 'Halb', none: 'Gar nicht'},
    weight: (factor) => `× ${factor}`,
    size: (width, height) => `${width} × ${height}`,
    worst: (length) => `höchstens ${length}`,
    runsOff: (length) => `trifft sich an einem Ende, am anderen ${length} daneben`,
    offAlong: (length) => `im Verlauf bis ${length} daneben`,
    lost: 'das Muster läuft an ihr entlang nicht weiter',
    between: (a, b) => `${a} an ${b}`,
    within: (piece) => `${piece}, im Teil selbst`,
    numbered: (name, number) => `${name} ${number}`,
    of: (what, whose) => `${what}: ${whose}`,
    unknown: 'noch nicht bekannt',
    rename: 'Umbenennen',
    name: 'Name des Teils',
    nameTaken: (name) => `Ein anderes Teil heißt schon ${name}; bitte einen eigenen Namen wählen.`,
    quarterTurn: 'Um 90 Grad drehen',
    turned: (piece) => `${piece} um 90 Grad gedreht.`,
  },
  lens: {
    label: 'Nahtlupe',
    description:
      'Pfeiltasten nach oben und unten gehen zu schlechteren und besseren Nähten, Escape löst.',
    none: 'Noch keine Naht zu zeigen.',
    nextWorst: 'Nächstschlechtere Naht',
    previousWorst: 'Vorige Naht',
    pin: 'Anheften',
    widen: 'Vergrößern',
    rank: (rank, count) => `${rank} von ${count}`,
    mismatch: (before, after) => `Versatz vorher ${before}, nachher ${after}`,
    ruler: (length) => `Ein Teilstrich ist ${length}`,
  },
  garment: {
    label: 'Schnittmuster im Stoffmuster',
    required: 'Das Muster ist noch nicht angepasst; bitte warten oder ein anderes wählen.',
    prints: 'Stoffmuster',
    scale: (unit) => `Rapportbreite (${unit})`,
    noGarment: 'Es gibt nichts zu zeigen: Schnitt und Stoffmuster angeben.',
    noSize: (url) => `${url} enthält einen Platz für die Größe; sie im Attribut 'size' angeben.`,
    noAddress: (url) => `${url} ist keine Adresse; bitte berichtigen.`,
    notFound: (url) => `${url} gibt es nicht; Adresse berichtigen oder die Datei dort ablegen.`,
    network: (url, reason) => `${url} ist nicht lesbar (${reason}); Verbindung und Server prüfen.`,
    timeout: (url, seconds) =>
      `${url} wurde nicht in ${seconds} s gelesen; bitte erneut versuchen.`,
    tooLarge: (url, most) => `${url} ist größer als ${most}; bitte eine kleinere Datei wählen.`,
    noPrint: (url) =>
      `${url} ist keine Musterdatei; ein Bild bitte in einem Muster mit group, w1 und w2 angeben.`,
    notJson: (url) => `${url} ist kein JSON; bitte eine andere Datei wählen.`,
    noSymmetries: (url) => `${url} enthält keine Liste von Symmetrien; bitte berichtigen.`,
    notAnImage: (url) => `${url} ist nicht als Bild lesbar; bitte ein anderes wählen.`,
    fileChanged: (url) =>
      `${url} ist nicht die Datei, mit der der Entwurf gemacht wurde; die frühere zurücklegen oder den Entwurf neu machen.`,
    notStorable: (what) =>
      `${what} wurde als Objekt gegeben; damit der Entwurf gespeichert werden kann, bitte die URL angeben.`,
    garment: 'Der Schnitt',
    print: 'Das Stoffmuster',
    noAnswer: 'Es gibt noch keine Lösung zu speichern; mit solve() darauf warten.',
    noCloth:
      "Ohne Stoffbreite lässt sich nichts auslegen; im Attribut 'cloth-width' angeben, wie breit der Stoff ist.",
    noDrawing: 'Es ist noch nichts gezeichnet; mit solve() darauf warten.',
    pictureWidth: (most) => `Ein Bild ist 1 bis ${most} Pixel breit; bitte eines davon verlangen.`,
    allowance: (most) => `Eine Zugabe hat 0 bis ${most}; bitte so eine verlangen.`,
    noPicture: 'Dieser Browser kann das Bild nicht schreiben; bitte ein kleineres verlangen.',
    noTools: (reason) =>
      `Was dafür nötig ist, ist nicht ladbar (${reason}); Verbindung prüfen und die Seite neu laden.`,
    cancelled: 'Die Anpassung wurde abgebrochen.',
  },
};
