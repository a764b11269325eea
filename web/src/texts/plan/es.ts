/** Spanish texts of a drawn layout. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Plan de corte 1 : ${scale}`,
  length: 'Largo',
  proven: 'largo mínimo demostrado',
  atBest: (length) => `en el mejor caso ${length}`,
  lying: 'de las piezas colocadas',
  buy: 'Compra',
  roundedUp: (step) => `redondeado al alza, en pasos de ${step}`,
  use: 'Tela aprovechada',
  ofWidth: (width) => `en un ancho de ${width}`,
  cost: 'El estampado cuesta',
  without: (length) => `sin estampado ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Tela de ${width} de ancho, orillos de ${selvedge}, ${gap} entre las piezas, margen de costura de ${allowance}; una sola capa, con el derecho hacia arriba.`,
  folded: (width, selvedge, gap, allowance, fold) =>
    `Tela de ${width} de ancho, orillos de ${selvedge}, ${gap} entre las piezas, margen de costura de ${allowance}; doblada a lo largo a ${fold} del borde izquierdo, derecho con derecho, mostrada desplegada.`,
  print: (name, across, along) =>
    `${name}: el anillo está en una esquina de la repetición, a ${across} del borde izquierdo, a ${along} del inicio.`,
  plain: 'El estampado no se tiene en cuenta: las piezas van en cualquier sitio.',
  unplaced: (pieces) => `Sin sitio: ${pieces}.`,
  pinned: (length) => `Las piezas fijadas cuestan ${length} más.`,
  start: 'Inicio de la tela',
  page: (number, count) => `página ${number} de ${count}`,
  garment: (piece, garment) => `${piece}, prenda ${garment}`,
  crosses: 'Las cruces de una pieza están en un mismo punto del estampado',
  crossesUnit: (unit) => `Cada una desde el borde izquierdo × desde el inicio de la tela [${unit}]`,
  number: 'N.º',
  piece: 'Pieza',
  cross: (number) => `Cruz ${number}`,
  phases: 'El estampado puede empezar en otro punto en el borde izquierdo',
  phase: 'Inicio del estampado',
  widths: 'En otros anchos',
  width: 'Ancho',
  none: '–',
  notes: {
    plainPieces: ({pieces}) =>
      `Las piezas de tela lisa no se colocan sobre el estampado: ${pieces}.`,
    pliesUnlike: () =>
      'Este estampado nunca se repite a lo largo de la tela, así que con ningún largo empiezan igual todas las capas: colócalas una a una.',
    pliesWhole: ({counts: [plies], lengths: [repeat]}) =>
      `Cada una de las ${plies} capas mide un número entero de repeticiones de ${repeat}, para que todas empiecen igual.`,
    flawsFromCut: () =>
      'Los defectos se cuentan desde el corte, donde se supone que empieza el estampado; si no, indica a qué distancia empieza.',
    folded: ({rounded: [edge]}) =>
      `La tela está doblada a ${edge} del borde izquierdo, derecho con derecho, y las dos capas se cortan a la vez.`,
    foldKeepsPrint: () =>
      'En tela doblada el estampado no se desplaza bajo ninguna pieza, porque la capa de abajo muestra su imagen reflejada.',
    phaseRange: ({range: [least, most]}) =>
      `De ${least} a ${most}, según dónde empiece el estampado en el orillo; mídelo.`,
    phaseNowhere: ({counts: [nowhere, all]}) =>
      `En ${nowhere} de ${all} inicios posibles del estampado no caben todas las piezas en la tela.`,
  },
};
