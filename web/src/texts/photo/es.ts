/** En español: un estampado leído de una foto. */
import type {PhotoTexts} from './en.js';

export const photo: PhotoTexts = {
  title: 'Foto de tu tela',
  intake:
    'Extiende la tela y fotografíala desde arriba, de modo que se vean al menos tres repeticiones en ambas direcciones. Elige la imagen, suéltala aquí o pégala.',
  stays: 'Se queda en este dispositivo.',
  choose: 'Elegir una imagen',
  camera: 'Hacer una foto',
  another: 'Otra imagen',
  photo: 'Foto de la tela',
  nodes: ['Esquina de la celda', 'Extremo de w1', 'Extremo de w2'],
  ends: ['Primer punto medido', 'Segundo punto medido'],
  stages: {
    repeat: 'Buscando la repetición',
    light: 'Igualando la luz',
    symmetry: 'Comparando simetrías',
    tile: 'Componiendo la celda',
  },
  faults: {
    plain:
      'No se encontró ningún estampado, la tela parece lisa: fotografíala con luz más clara desde un lado.',
    noRepeat:
      'No se encontró ningún rapport: aléjate hasta que se vean tres en cada dirección, y fotografía la tela plana y desde arriba.',
    fewRepeats: 'Se ven muy pocos rapports: aléjate hasta que haya tres en cada dirección.',
    twoPrints:
      'Una parte de la imagen muestra otro estampado, o ninguno: recorta la imagen al estampado que quieres.',
    changes:
      'El estampado cambia a lo largo de la tela: fotografía una parte en la que todos los rapports sean iguales.',
    blurred: 'La imagen está borrosa: mantén quieta la cámara y deja que enfoque la tela.',
    moire:
      'El tejido produce un muaré en la imagen: fotografía la tela un poco más de cerca o de lejos.',
    uneven: 'La tela no está plana: alísala y fotografíala de nuevo.',
    edges: 'Los bordes de la imagen no casan: da el rapport entero, o una foto que muestre varios.',
    small: 'La imagen es demasiado pequeña: da una de al menos 32 píxeles en cada dirección.',
  },
  reading: (stage, percent) => `${stage}, ${percent}`,
  cancelled: 'Detenido.',
  again: 'Buscar de nuevo',
  byHand: 'Dibujar la celda a mano',
  hand: 'Arrastra la esquina y las dos flechas hasta una repetición del estampado, y después:',
  alignHand: 'Buscar la repetición desde aquí',
  found: (group) => `Encontrado: ${group}.`,
  confidences: {
    likely: 'Es probable, pero compara la muestra con tu tela.',
    uncertain:
      'Ninguna repetición es segura: elige lo correcto, mueve las esquinas, o haz otra foto con tres repeticiones en ambas direcciones.',
  },
  others: '¿O es una de estas?',
  other: (number) => `Repetición ${number}`,
  notes: {
    uneven: 'La tela no está del todo plana.',
    differs: 'Las zonas rojas difieren de las demás copias y se dejan fuera.',
    focalLength: 'Mide a lo largo de w1 y de w2: si no, las proporciones son inciertas.',
  },
  lattice: 'Repetición',
  how: 'Arrastra las esquinas, o muévelas con las flechas: la repetición sigue al estampado cercano. Con Alt se queda donde la pones.',
  twice: (vector) => `${vector} el doble de largo`,
  half: (vector) => `${vector} la mitad de largo`,
  halfDrop: 'A medio salto',
  group: 'Simetría',
  verdicts: {
    has: 'la tiene',
    almost: 'casi',
    'has not': 'no la tiene',
    cannot: 'imposible con esta repetición',
  },
  foundOne: 'encontrada',
  breaks: (group) => `Dónde no se cumple ${group}`,
  exact: 'Hacer exactas las simetrías',
  show: 'Mostrar',
  overlays: {
    cells: 'Celdas',
    axes: 'Espejos y giros',
    differing: 'Copias que difieren',
  },
  flatten: 'Igualar la luz',
  swatch: 'Muestra, 3 repeticiones de ancho',
  making: 'Preparando la muestra…',
  size: 'Tamaño',
  unknown:
    'Tamaño desconocido: mide al menos una de estas con una cinta. Puedes alinear el estampado antes, pero no cortar.',
  repeatsAlong: (vector) => `Repeticiones a lo largo de ${vector}`,
  measure: (unit) => `miden (${unit})`,
  between: 'O medir entre dos puntos de la foto',
  distance: (unit) => `Distancia entre ellos (${unit})`,
  measures: (width, height) => `Una repetición mide ${width} × ${height}.`,
  misfit: (w1, w2, group) =>
    `Tu tela mide ${w1} a lo largo de w1 y ${w2} a lo largo de w2, pero ${group} pide lados iguales: elige una simetría que no los pida, o mide de nuevo.`,
  cloth: 'En la tela',
  turn: 'Girar 90°',
  warp: (turn) => `El estampado está girado ${turn}; el largo de la tela va hacia arriba.`,
  name: 'Nombre',
  use: 'Usar este estampado',
};
