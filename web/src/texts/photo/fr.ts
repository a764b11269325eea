/** French texts of the photo dialog. */
import type {PhotoTexts} from './en.js';

export const photo: PhotoTexts = {
  title: 'Photo de votre tissu',
  intake:
    'Posez le tissu à plat et photographiez-le d’en haut, avec au moins trois rapports dans les deux sens. Choisissez l’image, déposez-la ici ou collez-la.',
  stays: 'Elle reste sur cet appareil.',
  choose: 'Choisir une image',
  camera: 'Prendre une photo',
  another: 'Autre image',
  photo: 'Photo du tissu',
  nodes: ['Coin de la maille', 'Bout de w1', 'Bout de w2'],
  ends: ['Premier point mesuré', 'Second point mesuré'],
  stages: {
    repeat: 'Recherche du rapport',
    light: 'Égalisation de la lumière',
    symmetry: 'Comparaison des symétries',
    tile: 'Composition de la maille',
    object: 'Recherche du contour',
  },
  faults: {
    plain:
      'Aucun motif trouvé, le tissu semble uni : photographiez-le sous une lumière plus vive, venant d’un côté.',
    noRepeat:
      'Aucun rapport trouvé : reculez jusqu’à voir trois rapports dans chaque sens, et photographiez le tissu à plat et d’en haut.',
    fewRepeats:
      'Trop peu de rapports sont visibles : reculez jusqu’à en voir trois dans chaque sens.',
    twoPrints:
      'Une partie de l’image montre un autre motif, ou aucun : recadrez l’image sur le motif voulu.',
    changes:
      'Le motif change le long du tissu : photographiez une partie où tous les rapports sont semblables.',
    blurred:
      'L’image est floue : tenez l’appareil immobile et laissez-le faire la mise au point sur le tissu.',
    moire:
      'Le tissage crée un moiré sur l’image : photographiez le tissu d’un peu plus près ou d’un peu plus loin.',
    uneven: 'Le tissu n’est pas à plat : lissez-le et photographiez-le de nouveau.',
    misplaced:
      'L’imprimé ne se répète pas selon cette cellule : placez ses coins sur le même point de motifs voisins, ou annulez.',
    edges:
      'Les bords de l’image ne se rejoignent pas : donnez le rapport entier, ou une photo qui en montre plusieurs.',
    small: 'L’image est trop petite : donnez-en une d’au moins 32 pixels dans chaque sens.',
    object:
      'On n’y voit aucun contour de ce genre : touchez son milieu, ou mesurez plutôt entre deux points.',
  },
  reading: (stage, percent) => `${stage}, ${percent}`,
  cancelled: 'Arrêté.',
  again: 'Chercher à nouveau',
  byHand: 'Dessiner la maille',
  hand: 'Tirez le coin et les deux flèches sur un rapport de l’imprimé, puis :',
  alignHand: 'Chercher le rapport à partir d’ici',
  found: (group) => `Trouvé : ${group}.`,
  confidences: {
    likely: 'C’est probable, mais comparez l’échantillon à votre tissu.',
    uncertain:
      'Aucun rapport n’est sûr : choisissez ce qui est juste, déplacez les coins, ou prenez une autre photo avec trois rapports dans les deux sens.',
  },
  others: 'Ou est-ce l’un de ceux-ci ?',
  other: (number) => `Rapport ${number}`,
  notes: {
    uneven: 'Le tissu n’est pas tout à fait à plat.',
    differs: 'Les zones rouges diffèrent des autres copies et sont laissées de côté.',
    focalLength: 'Mesurez le long de w1 et de w2 : sinon les proportions sont incertaines.',
    unequal: 'Les côtés mesurés diffèrent : une symétrie moindre a été retenue.',
  },
  lattice: 'Rapport',
  how: 'Tirez les coins, ou déplacez-les avec les flèches : le rapport suit l’imprimé à côté. Avec Alt, il reste où vous le posez.',
  twice: (vector) => `${vector} deux fois plus long`,
  half: (vector) => `${vector} deux fois plus court`,
  halfDrop: 'Raccord sauté',
  group: 'Symétrie',
  verdicts: {
    has: 'oui',
    almost: 'presque',
    'has not': 'non',
    cannot: 'impossible sur ce rapport',
  },
  foundOne: 'trouvé',
  breaks: (group) => `Où ${group} n’est pas respecté`,
  exact: 'Rendre les symétries exactes',
  show: 'Afficher',
  overlays: {
    cells: 'Mailles',
    axes: 'Miroirs et rotations',
    differing: 'Copies qui diffèrent',
    breaks: 'Là où la symétrie est rompue',
  },
  flatten: 'Égaliser la lumière',
  white: 'Balance des blancs',
  tapWhite:
    'Touchez quelque chose de blanc sur la photo. Ou déplacez l’anneau avec les flèches et appuyez sur Entrée.',
  aimWhite: 'Quelque chose de blanc',
  asTaken: 'Couleurs d’origine',
  swatch: 'Échantillon, large de 3 rapports',
  making: 'L’échantillon se prépare…',
  size: 'Taille',
  unknown:
    'Taille inconnue : mesurez-la de l’une de ces façons. Vous pouvez aligner l’imprimé avant, mais pas couper.',
  repeatsAlong: (vector) => `Rapports le long de ${vector}`,
  measure: (unit) => `mesurent (${unit})`,
  measureBy: 'Mesurer avec',
  measuring: {tape: 'Mètre ruban', points: 'Deux points', object: 'Pièce ou carte'},
  between: 'Faites glisser les deux points sur la photo, puis entrez la distance qui les sépare.',
  object: 'Laquelle',
  objects: {
    eur1: '1 euro, 23,25 mm',
    eur2: '2 euros, 25,75 mm',
    quarter: 'Quarter américain, 24,26 mm',
    gbp1: '1 livre, 23,4 mm',
    card: 'Carte, 85,60 × 53,98 mm',
    a4: 'Feuille A4, 297 × 210 mm',
  },
  aim: 'Milieu de la pièce ou de la carte',
  tap: 'Elle est à plat sur le tissu : touchez son milieu sur la photo. Ou déplacez l’anneau avec les flèches et appuyez sur Entrée.',
  look: 'La chercher à l’anneau',
  byObject: (error) => `Mesuré par le contour rouge, à ${error} près environ.`,
  distance: (unit) => `Distance entre eux (${unit})`,
  measures: (width, height) => `Un rapport mesure ${width} × ${height}.`,
  vectors: (w1, w2) => `w1 mesure ${w1}, w2 ${w2}.`,
  sidesApart: (w1, w2, share, group) =>
    `Vos mesures diffèrent de ${share} : un rapport mesure ${w1} le long de w1, mais ${w2} le long de w2, et ${group} demande des côtés égaux. ${w1} compte jusqu’à ce que vous en supprimiez une, ou choisissiez une symétrie qui ne le demande pas.`,
  photoApart: (w1, w2, share, expected) =>
    `Vos mesures diffèrent de ${share} : avec ${w1} le long de w1, la photo montre ${expected} le long de w2, et non ${w2}. Les deux comptent jusqu’à ce que vous en supprimiez une.`,
  removeMeasure: 'Supprimer cette mesure',
  cloth: 'Sur le tissu',
  turn: 'Tourner de 90°',
  warp: (turn) => `L’imprimé est tourné de ${turn} ; la longueur du tissu va vers le haut.`,
  name: 'Nom',
  use: 'Utiliser cet imprimé',
  useDoubtful: 'L’utiliser bien qu’incertain',
  doubt:
    'Il n’est pas sûr que cette maille soit le rapport de l’imprimé : placez ses coins en les faisant glisser, ou choisissez-en une autre.',
};
