/* eslint-disable no-irregular-whitespace -- French parts : ; ? and quotes from words by spaces that do not break */
/** French texts of the print and the match. */
import type {PrintTexts} from '../en/print.js';

export const print: PrintTexts = {
  controls: {
    fit: 'Coupe',
    presets: 'Points de départ',
    presetNames: {
      homeSewist: 'Couture à la maison, droit-fil',
      wovenShirt: 'Chemise en tissu',
      bestFit: 'Meilleur raccord, tout angle',
      placeOnly: 'Placer seulement, garder chaque contour',
    },
    presetNotes: {
      homeSewist: 'Les pièces sont en droit-fil et changent de 10 mm au plus.',
      wovenShirt:
        'Les pièces sont en droit-fil et changent de 4 mm au plus, pour que col et poignets gardent leur coupe.',
      bestFit:
        'Les pièces sont posées à tout angle et changent de 10 mm au plus ; l’imprimé se raccorde au mieux.',
      placeOnly: 'Les pièces sont en droit-fil et gardent le contour tracé.',
    },
    greatestChange: (unit) => `Plus grand changement (${unit})`,
    between: (least, most) => `Saisissez un nombre de ${least} à ${most}.`,
    grain: 'Droit-fil de toutes les pièces',
    grains: {on: 'En droit-fil', across: 'En travers', bias: 'Dans le biais', free: 'Tout angle'},
    continuousOnly: 'Seulement prolonger l’imprimé',
    continuousNote: 'Aucune couture en miroir : l’imprimé continue par-dessus chacune.',
    method: 'Méthode',
    methods: {
      best: 'La meilleure',
      paper: 'Wolff et al. 2019',
      ws19: 'Wolff et Sorkine-Hornung 2019, sans symétrie',
    },
    solveAsIGo: 'Recalculer à mesure',
    unitNames: {cm: 'Centimètres', inch: 'Pouces'},
    paperScale: 'Écart 0–2 cm, comme dans l’article',
  },
  print: {
    title: 'Imprimé',
    open: 'Ouvrir un imprimé',
    photo: 'Photo de votre tissu',
    own: (title) => `Le vôtre : ${title}`,
    group: 'Groupe de symétrie',
    stripes: 'Rayures',
    more: 'D’autres imprimés',
    ours: 'Imprimés fournis avec Seamwise',
    filter: 'Montrer seulement',
    filters: {
      botanical: 'Fleurs',
      geometric: 'Géométriques',
      tailored: 'Rayures et carreaux',
      mirrors: 'Avec miroirs',
    },
    colourways: 'Coloris',
    width: (unit) => `Largeur du rapport (${unit})`,
    height: (unit) => `Hauteur du rapport (${unit})`,
    proportions: 'Garder les proportions',
    sides: (width, height, turn) =>
      `Le rapport sur le tissu, dont la longueur va vers le haut : largeur ${width}, hauteur ${height}, tourné de ${turn}`,
    sideNames: {width: 'largeur', height: 'hauteur'},
    fromFile: (resolution, size) => `D’après le fichier : ${resolution}, ${size} de large`,
    dpi: (value) => `${value} ppp`,
    onPaper: 'dessiné à l’échelle',
    backToFile: (resolution, size) => `Comme le dit le fichier : ${resolution}, ${size} de large`,
    unasked: 'Bien des programmes écrivent ce nombre d’eux-mêmes : mesurez pour être sûr.',
    sizeUnknown:
      'Le fichier ne dit pas à quelle taille il s’imprime : mesurez, ou saisissez une taille.',
    unscaled:
      'La taille de cet imprimé est inconnue : mesurez-la, ou saisissez une taille, avant de couper.',
    measure: {
      open: 'Mesurer sur l’image',
      how: 'Cliquez sur deux points dont vous connaissez la distance, ou déplacez-les avec les flèches.',
      points: ['Premier point', 'Second point'],
      distance: (unit) => `Distance entre eux (${unit})`,
      makes: (width, height) => `Un rapport fait alors ${width} × ${height}.`,
      apply: 'Prendre cette taille',
    },
    repeats: {
      label: 'Comment l’image se répète',
      straight: 'Droit',
      halfDrop: 'Sauté',
      brick: 'En briques',
      mirrored: 'En miroir',
      mirroredAcross: 'En miroir de côté',
      mirroredUp: 'En miroir de haut en bas',
    },
    angle: 'Angle (degrés)',
    turn: 'Rotation (degrés)',
    oneWay: 'Différent la tête en bas',
    oneWayNote: 'Est-il pareil la tête en bas ? Alors laissez ceci décoché.',
    lacks: {
      piece: (group) =>
        `Une pièce symétrique demande un imprimé à miroirs, et ${group} n’en a pas.`,
      pair: (group) =>
        `Une paire en miroir demande un imprimé à miroirs ou à symétries glissées, et ${group} n’en a pas.`,
    },
    wouldDo: 'Ceux-ci conviendraient :',
    notQuite: (group, fitting) =>
      `Votre tissu n’est pas tout à fait ${group} ; ${fitting} convient encore.`,
    take: (group) => `Prendre ${group}`,
    keep: (group) => `Garder ${group}`,
    needsPicture:
      'L’image de cet imprimé est dans un fichier à part : ouvrez-le ensuite, ou déposez-le ici.',
    keeps: 'Trouvé dans l’image :',
    reads: {
      picture: (how) => `Cette image est différente ${how}, là où elle est encadrée.`,
      stripes: (how) => `Ces rayures sont différentes ${how}, là où elles sont encadrées.`,
    },
    differs: {
      leftRight: 'de droite à gauche',
      topBottom: 'de bas en haut',
      diagonal: 'de part et d’autre d’une diagonale',
      slanted: 'de part et d’autre d’une ligne oblique',
      steps: 'une fois en miroir et avancée',
      upsideDown: 'la tête en bas',
      quarterTurn: 'après un quart de tour',
      thirdTurn: 'après un tiers de tour',
      sixthTurn: 'après un sixième de tour',
      halfDrop: 'un demi-rapport à côté',
    },
    has: 'Voici ce qu’elle a :',
    openEdges: {
      across: 'Ses bords gauche et droit ne se raccordent pas.',
      up: 'Ses bords haut et bas ne se raccordent pas.',
      both: 'Ses bords ne se raccordent pas.',
    },
    marked: (title) => `${title}, où ce qui ne va pas est marqué`,
    doubtful: (title) => `${title} ne se répète pas tel quel.`,
    remedy: {
      label: 'Ce qu’on en fait',
      halfDrop: 'C’est un rapport sauté',
      brick: 'C’est un rapport en briques',
      mirror: 'Mettre en miroir',
      photo: 'C’est une photo de tissu',
      another: 'En choisir un autre',
      anyway: 'Prendre quand même',
    },
    meanings: {
      p1: 'Se répète, sans rotation ni miroir.',
      p2: 'Pareil la tête en bas ; sans miroir.',
      pm: 'Miroir dans une direction.',
      pg: 'Comme des pas : en miroir et avancé.',
      cm: 'Miroir dans une direction, rangée suivante en sauté.',
      pmm: 'Miroir dans les deux directions.',
      pmg: 'Miroir dans une direction, comme des pas dans l’autre.',
      pgg: 'Comme des pas dans les deux directions.',
      cmm: 'Miroir dans les deux directions, rangée suivante en sauté.',
      p4: 'Pareil après un quart de tour ; sans miroir.',
      p4m: 'Miroir dans les deux directions et sur les deux diagonales, comme un carreau.',
      p4g: 'Quarts de tour, et entre eux des miroirs en diagonale.',
      p3: 'Pareil après un tiers de tour ; sans miroir.',
      p3m1: 'Miroir dans trois directions, par tous les centres de rotation.',
      p31m: 'Miroir dans trois directions, avec des centres de rotation aussi à côté.',
      p6: 'Pareil après un sixième de tour ; sans miroir.',
      p6m: 'Miroir dans six directions, comme un cristal de neige.',
      stripes: 'Miroir dans les deux directions ; le long de la rayure, tout endroit se vaut.',
    },
    files: {
      tooLarge: (name) => `${name} dépasse 12 Mo ; réduisez l’image.`,
      tooWide: (name) => `${name} a plus de 8192 pixels sur un côté ; réduisez l’image.`,
      outsidePictures: (name) =>
        `${name} fait appel à des images d’ailleurs, que les navigateurs omettent ; intégrez-les au fichier, ou enregistrez-le en PNG.`,
      unreadable: (name) => `${name} n’est pas lisible comme image.`,
      kinds: {
        png: 'une image PNG',
        jpeg: 'une image JPEG',
        webp: 'une image WebP',
        svg: 'un dessin SVG',
        gif: 'une image GIF',
        heic: 'une photo HEIC',
        avif: 'une image AVIF',
        tiff: 'une image TIFF',
        bmp: 'une image BMP',
        pdf: 'un document PDF',
        photoshop: 'un fichier Photoshop',
        postscript: 'un fichier PostScript',
        dxf: 'un dessin DXF',
        zip: 'une archive ZIP',
      },
      wrongKind: (name, kind) =>
        `${name} est ${kind}, qui ne peut être un imprimé : enregistrez-le en PNG ou JPEG, et ouvrez cela.`,
      damaged: (name, kind) =>
        `${name} est ${kind}, mais abîmé : enregistrez-le de nouveau, ou prenez une autre copie.`,
      pattern: (name) => `${name} est un patron, pas un imprimé : utilisez Ouvrir un patron.`,
      openEdges: {
        across: (name) =>
          `${name} ne se répète pas : ses bords gauche et droit ne se raccordent pas. Décidez sous Imprimé ce qu’on en fait.`,
        up: (name) =>
          `${name} ne se répète pas : ses bords haut et bas ne se raccordent pas. Décidez sous Imprimé ce qu’on en fait.`,
        both: (name) =>
          `${name} ne se répète pas : ses bords ne se raccordent pas. Décidez sous Imprimé ce qu’on en fait.`,
      },
      noPrint: (name) =>
        `${name} n’est pas un imprimé : ouvrez une image (PNG, JPEG, WebP, SVG), ou un fichier d’imprimé avec group, w1 et w2.`,
      wrongLattice: (name, group) =>
        `Dans ${name}, w1 et w2 n’engendrent pas un réseau de ${group}.`,
    },
  },
};
