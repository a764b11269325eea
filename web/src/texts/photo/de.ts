/** German texts of the photo dialog. */
import type {PhotoTexts} from './en.js';

export const photo: PhotoTexts = {
  title: 'Foto vom Stoff',
  intake:
    'Den Stoff flach hinlegen und von oben fotografieren, sodass in beide Richtungen mindestens drei Rapporte zu sehen sind. Dann das Bild wählen, hier ablegen oder einfügen.',
  stays: 'Es bleibt auf diesem Gerät.',
  choose: 'Bild wählen',
  camera: 'Foto aufnehmen',
  another: 'Anderes Bild',
  photo: 'Foto des Stoffs',
  nodes: ['Ecke der Zelle', 'Ende von w1', 'Ende von w2'],
  ends: ['Erster Messpunkt', 'Zweiter Messpunkt'],
  stages: {
    repeat: 'Der Rapport wird gesucht',
    light: 'Das Licht wird ausgeglichen',
    symmetry: 'Symmetrien werden verglichen',
    tile: 'Die Zelle entsteht',
    object: 'Der Umriss wird gesucht',
  },
  faults: {
    plain:
      'Kein Muster gefunden, der Stoff wirkt einfarbig: bitte in hellerem Licht von einer Seite fotografieren.',
    noRepeat:
      'Kein Rapport gefunden: bitte zurücktreten, bis in beiden Richtungen drei Rapporte zu sehen sind, und den Stoff flach und von oben fotografieren.',
    fewRepeats:
      'Zu wenige Rapporte sind zu sehen: bitte zurücktreten, bis es in beiden Richtungen drei sind.',
    twoPrints:
      'Ein Teil des Bildes zeigt ein anderes Muster oder keines: bitte das Bild auf das gewünschte Muster zuschneiden.',
    changes:
      'Das Muster ändert sich über den Stoff: bitte eine Stelle fotografieren, an der alle Rapporte gleich sind.',
    blurred:
      'Das Bild ist unscharf: bitte die Kamera ruhig halten und auf den Stoff scharf stellen lassen.',
    moire:
      'Das Gewebe erzeugt ein Moiré im Bild: bitte den Stoff aus etwas kleinerem oder größerem Abstand fotografieren.',
    uneven: 'Der Stoff liegt nicht flach: bitte glatt streichen und noch einmal fotografieren.',
    misplaced:
      'Der Druck wiederholt sich nicht mit dieser Zelle: ihre Ecken auf dieselbe Stelle benachbarter Motive legen oder rückgängig machen.',
    edges:
      'Die Ränder des Bildes schließen nicht aneinander an: bitte den ganzen Rapport angeben oder ein Foto, das mehrere zeigt.',
    small:
      'Das Bild ist zu klein: bitte eines mit mindestens 32 Pixeln in beiden Richtungen wählen.',
    object:
      'Dort ist kein solcher Umriss zu sehen: bitte seine Mitte antippen oder stattdessen zwischen zwei Punkten messen.',
  },
  reading: (stage, percent) => `${stage}, ${percent}`,
  cancelled: 'Angehalten.',
  again: 'Noch einmal suchen',
  byHand: 'Zelle selbst zeichnen',
  hand: 'Die Ecke und beide Pfeile auf einen Rapport des Drucks ziehen, danach:',
  alignHand: 'Den Rapport von hier aus suchen',
  found: (group) => `Gefunden: ${group}.`,
  confidences: {
    likely: 'Wahrscheinlich stimmt es; bitte die Probe mit dem Stoff vergleichen.',
    uncertain:
      'Kein Rapport ist sicher: bitte das Richtige wählen, die Ecken verschieben oder ein anderes Foto mit drei Rapporten in beide Richtungen nehmen.',
  },
  others: 'Oder ist es einer von diesen?',
  other: (number) => `Rapport ${number}`,
  notes: {
    uneven: 'Der Stoff liegt nicht ganz flach.',
    differs: 'Rote Stellen weichen von allen anderen Kopien ab und bleiben außer Acht.',
    focalLength: 'Bitte entlang w1 und w2 messen: Sonst sind die Proportionen unsicher.',
    unequal: 'Die gemessenen Seiten sind verschieden: Es gilt eine kleinere Symmetrie.',
  },
  lattice: 'Rapport',
  how: 'Ecken ziehen oder mit den Pfeiltasten verschieben: Der Rapport folgt dem Druck in ihrer Nähe. Mit Alt bleibt er genau so liegen.',
  twice: (vector) => `${vector} doppelt so lang`,
  half: (vector) => `${vector} halb so lang`,
  halfDrop: 'Halb versetzt',
  group: 'Symmetrie',
  verdicts: {
    has: 'ja',
    almost: 'beinahe',
    'has not': 'nein',
    cannot: 'mit diesem Rapport nicht',
  },
  foundOne: 'gefunden',
  breaks: (group) => `Wo ${group} nicht stimmt`,
  exact: 'Symmetrien genau machen',
  show: 'Anzeigen',
  overlays: {
    cells: 'Zellen',
    axes: 'Spiegel und Drehungen',
    differing: 'Abweichende Kopien',
    breaks: 'Wo es die Symmetrie bricht',
  },
  flatten: 'Licht ausgleichen',
  white: 'Weißabgleich',
  tapWhite:
    'Bitte auf dem Foto etwas Weißes antippen. Oder den Ring mit den Pfeiltasten bewegen und Enter drücken.',
  aimWhite: 'Etwas Weißes',
  asTaken: 'Farben wie aufgenommen',
  swatch: 'Stoffprobe, 3 Rapporte breit',
  making: 'Die Probe entsteht …',
  size: 'Größe',
  unknown:
    'Größe unbekannt: bitte auf eine dieser Arten messen. Ausrichten geht schon vorher, zuschneiden nicht.',
  repeatsAlong: (vector) => `Rapporte entlang ${vector}`,
  measure: (unit) => `messen (${unit})`,
  measureBy: 'Messen mit',
  measuring: {tape: 'Maßband', points: 'Zwei Punkten', object: 'Münze oder Karte'},
  between: 'Bitte die beiden Punkte auf dem Foto ziehen und dann ihren Abstand eingeben.',
  object: 'Welche',
  objects: {
    eur1: '1 Euro, 23,25 mm',
    eur2: '2 Euro, 25,75 mm',
    quarter: 'US-Vierteldollar, 24,26 mm',
    gbp1: '1 Pfund, 23,4 mm',
    card: 'Karte, 85,60 × 53,98 mm',
    a4: 'Blatt A4, 297 × 210 mm',
  },
  aim: 'Mitte der Münze oder Karte',
  tap: 'Sie liegt flach auf dem Stoff: bitte auf dem Foto ihre Mitte antippen. Oder den Ring mit den Pfeiltasten bewegen und Enter drücken.',
  look: 'Beim Ring danach suchen',
  byObject: (error) => `Gemessen am roten Umriss, auf etwa ${error} genau.`,
  distance: (unit) => `Ihr Abstand (${unit})`,
  measures: (width, height) => `Ein Rapport ist ${width} × ${height}.`,
  vectors: (w1, w2) => `w1 ist ${w1} lang, w2 ${w2}.`,
  sidesApart: (w1, w2, share, group) =>
    `Die Maße widersprechen sich um ${share}: ein Rapport misst ${w1} entlang w1, aber ${w2} entlang w2, und ${group} verlangt gleiche Seiten. Es gilt ${w1}, bis eines entfernt oder eine Symmetrie ohne das gewählt ist.`,
  photoApart: (w1, w2, share, expected) =>
    `Die Maße widersprechen sich um ${share}: bei ${w1} entlang w1 zeigt das Foto ${expected} entlang w2, nicht ${w2}. Beide gelten, bis eines entfernt ist.`,
  removeMeasure: 'Dieses Maß entfernen',
  cloth: 'Auf dem Stoff',
  turn: 'Um 90° drehen',
  warp: (turn) => `Der Druck ist um ${turn} gedreht; die Länge des Stoffs läuft nach oben.`,
  name: 'Name',
  use: 'Diesen Druck verwenden',
  useDoubtful: 'Trotz Unsicherheit verwenden',
  doubt:
    'Ob diese Zelle der Rapport des Drucks ist, ist unsicher: bitte ihre Ecken zurechtziehen oder eine andere wählen.',
};
