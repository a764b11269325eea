/* eslint-disable no-irregular-whitespace -- French parts : ; ? and quotes from words by spaces that do not break */
/** French texts of the result: figures, notes, failures, remedies, lists and the element. */
import type {AnswerTexts} from '../en/answer.js';

export const answer: AnswerTexts = {
  headline: {
    fits: (mean) => `Aux coutures, l’imprimé est décalé de ${mean} en moyenne`,
    worst: (mean, seam) => `La moins bonne, ${mean} : ${seam}.`,
    before: (mean) => `Avant, ${mean} en moyenne.`,
    more: 'Plus de chiffres',
    area: 'Longueur fois écart',
    noSeams: 'Pas de couture à raccorder',
    fit: 'Qualité du raccord',
    percentOfRandom: (percent) => `${percent} de pièces posées au hasard`,
    proven: 'Aucun autre placement ne raccorde mieux.',
    nearlyProven: (percent) => `Aucun autre placement ne raccorde mieux de plus de ${percent}.`,
    unproven: 'Le meilleur des placements essayés.',
    cost: 'Ce que coûte la symétrie',
    withSymmetry: 'Avec symétrie',
    withoutSymmetry: 'Sans',
    notes: 'Remarques',
  },
  notes: {
    noSeams: 'Le fichier n’a pas de coutures : il n’y a rien à raccorder.',
    noMatchedSeams:
      'Aucune couture n’est à raccorder : chacune est désactivée ou touche une pièce unie.',
    gathered: (seams) =>
      `Un côté est plus long de plus d’un dixième (fronces, plis) ; l’imprimé ne peut pas se raccorder partout : ${seams}.`,
    unitsAssumed: 'Le fichier ne dit pas son unité ; on suppose des centimètres.',
    curvesAssumed:
      'Le fichier ne dit pas comment les courbes sont écrites ; on suppose des points de contrôle relatifs.',
    lengthRatio: (seam, stated, drafted) =>
      `${seam} : selon le fichier ses côtés sont de ${stated} à 1, selon le tracé de ${drafted} à 1 ; le tracé compte.`,
    noMirrors: (pieces, group) =>
      `Un imprimé du groupe ${group} n’a pas de miroirs, donc ceci ne reste pas symétrique : ${pieces}.`,
    noGlides: (pieces, group) =>
      `Un imprimé du groupe ${group} n’a ni miroirs ni glissements, donc ces paires ne restent pas symétriques : ${pieces}.`,
    symmetriesStated: 'Les symétries sont celles que le fichier indique.',
    ws19: 'Cette méthode ne connaît pas de symétrie du vêtement ; aucune n’est gardée.',
    grainAssumed: (pieces) =>
      `Le fichier n’a pas de droit-fil pour ces pièces ; on le suppose vers le haut, comme dessiné : ${pieces}.`,
    partOfTheWay:
      'Les coutures ne font qu’une partie du chemin vers leurs lignes idéales, sinon des contours se croiseraient ou bougeraient trop.',
    leftAsDrafted:
      'Aucune forme trouvée ne s’accorde mieux que les pièces telles que dessinées ; elles gardent leurs lignes.',
    dropped: (pieces, why) => `La symétrie de ${pieces} est abandonnée : ${why}.`,
    cannotHold: (pieces, why) => `La symétrie de ${pieces} est impossible ainsi : ${why}.`,
    why: {
      symmetryPins: 'ainsi fixé, l’imprimé ne s’y reflète pas',
      symmetryGrain: 'sur cet imprimé, des pièces quitteraient leur droit-fil',
      symmetryChange:
        'pour un reflet exact, des contours devraient changer plus qu’il n’est permis',
      symmetryKinks: 'pour un reflet exact, des contours auraient des cassures ou des plis',
      symmetryLengths:
        'des coutures perdraient leur longueur, et le plus grand changement est trop petit pour cela',
      symmetryCrossing: 'le contour se croiserait lui-même',
      symmetrySewn: 'ses bords sont cousus à des bords qui ne se reflètent pas',
    },
  },
  failures: {
    garment: (message) => `Le patron est illisible. En anglais : ${message}`,
    noGarment: (message) =>
      `Ce n’est pas un patron lisible ici : choisissez un fichier GarmentCode (JSON), un projet ou un résultat. En anglais : ${message}`,
    solver: (message) => `Le calcul a échoué. En anglais : ${message}`,
    noWorker: (message) =>
      `La page calcule elle-même, plus lentement, car aucun worker ne démarre. En anglais : ${message}`,
    noWasm: (message) => `Le programme de calcul ne se charge pas. En anglais : ${message}`,
    picture: (file) => `${file} est une image ; ouvrez-la comme imprimé, ou choisissez un patron.`,
    document: (file, kind) =>
      `${file} est ${kind}, que Seamwise ne peut lire : choisissez DXF, SVG, OBJ ou un fichier GarmentCode pour un patron, une image PNG, JPEG, WebP ou SVG pour un imprimé.`,
    tooLarge: (file) => `${file} est trop grand pour un patron ; choisissez un autre fichier.`,
    noDesign: (file) =>
      `${file} est un résultat sans son projet ; ouvrez le vêtement dont il vient.`,
    project: (message) => `Le projet est illisible. En anglais : ${message}`,
  },
  remedies: {
    title: (count) =>
      count === 1 ? 'Une couture ne se raccorde pas' : `${count} coutures ne se raccordent pas`,
    more: (count) => `et ${count} de plus`,
    help: 'Ce qui aiderait',
    why: {
      grain: 'sur le droit-fil, ses deux côtés ne s’accordent pas',
      gather: 'un côté est froncé',
      group: 'l’imprimé n’a pas de miroir pour elle',
      size: 'l’imprimé est trop grand pour elle',
      others: 'd’autres coutures de ses pièces passent avant',
      locked: 'elle est verrouillée',
    },
    what: {
      turn: (pieces) => `Tourner ${pieces} de 90°`,
      ungather: () => 'Laisser de côté les fronces',
      mirrors: () => 'Un imprimé à miroirs',
      smaller: () => 'Un imprimé deux fois plus petit',
    },
    effect: (before, after) => `${before} → ${after}`,
  },
  lists: {
    pieces: 'Pièces',
    seams: 'Coutures',
    piece: 'Pièce',
    moved: 'Modifiée',
    offGrain: 'Hors fil',
    grain: 'Droit-fil',
    printed: 'Imprimé',
    seam: 'Couture',
    length: 'Longueur',
    before: 'Avant',
    after: 'Après',
    match: 'Raccord',
    asAll: 'Général',
    pinned: 'Épinglée',
    free: 'Libérer',
    matches: {double: 'Double', full: 'Plein', half: 'Demi', none: 'Aucun'},
    weight: (factor) => `× ${factor}`,
    size: (width, height) => `${width} × ${height}`,
    worst: (length) => `au pire ${length}`,
    runsOff: (length) => `se raccorde à un bout, décalée de ${length} à l’autre`,
    offAlong: (length) => `suivie sur sa longueur, décalée jusqu’à ${length}`,
    lost: 'l’imprimé ne se poursuit pas le long d’elle',
    between: (a, b) => `${a} à ${b}`,
    within: (piece) => `${piece}, sur la pièce même`,
    numbered: (name, number) => `${name} ${number}`,
    of: (what, whose) => `${what} : ${whose}`,
    unknown: 'pas encore connu',
    rename: 'Renommer',
    name: 'Nom de la pièce',
    nameTaken: (name) =>
      `Une autre pièce s’appelle déjà ${name} ; donnez à celle-ci un nom à elle.`,
    quarterTurn: 'Tourner de 90 degrés',
    turned: (piece) => `${piece} : tournée de 90 degrés.`,
  },
  lens: {
    label: 'Loupe de couture',
    description:
      'Les flèches haut et bas vont aux coutures plus et moins décalées, Échap désépingle.',
    none: 'Pas encore de couture à montrer.',
    nextWorst: 'Couture suivante par écart',
    previousWorst: 'Couture précédente par écart',
    pin: 'Épingler',
    widen: 'Agrandir',
    rank: (rank, count) => `${rank} sur ${count}`,
    mismatch: (before, after) => `Écart ${before} avant, ${after} après`,
    ruler: (length) => `Une graduation vaut ${length}`,
  },
  garment: {
    label: 'Patron de couture dans son imprimé',
    required: 'L’imprimé n’est pas encore raccordé ; attendez, ou choisissez-en un autre.',
    prints: 'Imprimés',
    scale: (unit) => `Largeur du rapport (${unit})`,
    noGarment: 'Il n’y a rien à montrer : indiquez un patron et un imprimé.',
    noSize: (url) => `${url} a une place pour la taille ; indiquez-la dans l’attribut 'size'.`,
    noAddress: (url) => `${url} n’est pas une adresse ; corrigez-la.`,
    notFound: (url) => `${url} n’existe pas ; corrigez l’adresse, ou placez-y le fichier.`,
    network: (url, reason) =>
      `${url} n’est pas lisible (${reason}) ; vérifiez la connexion et le serveur.`,
    timeout: (url, seconds) => `${url} n’a pas été lu en ${seconds} s ; réessayez.`,
    tooLarge: (url, most) => `${url} dépasse ${most} ; choisissez un fichier plus petit.`,
    noPrint: (url) =>
      `${url} n’est pas un fichier d’imprimé ; donnez une image dans un imprimé, avec group, w1 et w2.`,
    notJson: (url) => `${url} n’est pas du JSON ; choisissez un autre fichier.`,
    noSymmetries: (url) => `${url} ne contient pas de liste de symétries ; corrigez-le.`,
    notAnImage: (url) => `${url} n’est pas lisible comme image ; choisissez-en une autre.`,
    fileChanged: (url) =>
      `${url} n’est pas le fichier qui a servi au modèle ; remettez le précédent, ou refaites le modèle.`,
    notStorable: (what) =>
      `${what} a été donné comme objet ; donnez son URL pour que le modèle puisse être enregistré.`,
    garment: 'Le patron',
    print: 'L’imprimé',
    noAnswer: 'Pas encore de solution à enregistrer ; attendez-la avec solve().',
    noCloth:
      "Il n’y a pas de tissu où placer les pièces ; indiquez sa largeur dans l’attribut 'cloth-width'.",
    noDrawing: 'Rien n’est encore dessiné ; attendez avec solve().',
    pictureWidth: (most) =>
      `Une image a de 1 à ${most} pixels de large ; demandez une de ces largeurs.`,
    allowance: (most) => `Une marge a de 0 à ${most} ; demandez-en une ainsi.`,
    noPicture: 'Ce navigateur ne peut pas écrire l’image ; demandez-en une plus petite.',
    noTools: (reason) =>
      `Ce qu’il faut pour cela ne peut être chargé (${reason}) ; vérifiez la connexion et rechargez la page.`,
    cancelled: 'Le calcul a été interrompu.',
  },
};
