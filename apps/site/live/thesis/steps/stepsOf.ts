import type { View } from '@farol/renderer';
import type { BufferName } from '../buffers/BufferView';

/** One step of a technique: the buffer or view that its passes have made by then, and what is said of it. */
export interface Step {
  readonly show: BufferName | View;
  /** English and Spanish. */
  readonly label: readonly [string, string];
  readonly en: string;
  readonly es: string;
}

const step = (show: Step['show'], label: Step['label'], en: string, es: string): Step => ({ show, label, en, es });

const albedo = step(
  'albedo',
  ['Diffuse', 'Difuso'],
  'First pass, first target: the diffuse colour of the nearest surface.',
  'Primera pasada, primer destino: el color difuso de la superficie más próxima.',
);
const normal = step(
  'normal',
  ['Normals', 'Normales'],
  'In the same pass, the normal of each pixel.',
  'En la misma pasada, la normal de cada píxel.',
);
const depth = step(
  'depth',
  ['Depth', 'Profundidad'],
  'The depth buffer, from which positions are rebuilt.',
  'El búfer de profundidad, del que se reconstruye la posición.',
);
const bounds = step(
  'tile-depth',
  ['Tile bounds', 'Límites por celda'],
  'The nearest (red) and farthest (green) depth in each tile of 16 × 16 pixels.',
  'La profundidad menor (rojo) y mayor (verde) de cada celda de 16 × 16 píxeles.',
);
const picture = (en: string, es: string): Step => step('final', ['Picture', 'Imagen'], en, es);
const counts = (en: string, es: string): Step => step('light-count', ['Lights a pixel', 'Luces por píxel'], en, es);

/** Steps of each technique that the figure shows. */
export const stepsOf = {
  deferred: [
    albedo,
    normal,
    step(
      'specular',
      ['Specular', 'Especular'],
      'Third target: how the surface reflects highlights.',
      'Tercer destino: cómo refleja la superficie los brillos.',
    ),
    depth,
    step(
      'ambient',
      ['Accumulation', 'Acumulación'],
      'Ambient and emissive light are there before the first light.',
      'La luz ambiente y la emisiva están antes que la primera luz.',
    ),
    step(
      'lighting',
      ['Lights', 'Luces'],
      'Second pass: each light over the pixels of its volume, added. Take lights away with the slider.',
      'Segunda pasada: cada luz sobre los píxeles de su volumen, sumada. Quite luces con el control.',
    ),
    counts('How many volumes each pixel was shaded for.', 'Por cuántos volúmenes se ha sombreado cada píxel.'),
    picture(
      'Lights and accumulation together, then what is transparent, drawn forward.',
      'Luces y acumulación juntas; después lo transparente, por forward.',
    ),
  ],
  'light-prepass': [
    step('thin-depth', ['Depth', 'Profundidad'], 'First pass: depth,', 'Primera pasada: la profundidad,'),
    step('thin-normal', ['Normals', 'Normales'], 'normals,', 'las normales'),
    step(
      'thin-lobe',
      ['Specular power', 'Poder especular'],
      'and specular power: 8 bytes a pixel and no colours.',
      'y el poder especular: 8 bytes por píxel y ningún color.',
    ),
    step(
      'light-diffuse',
      ['Diffuse light', 'Luz difusa'],
      'Second pass: the diffuse light that arrives at each pixel,',
      'Segunda pasada: la luz difusa que llega a cada píxel',
    ),
    step(
      'light-specular',
      ['Specular light', 'Luz especular'],
      'and the specular light, apart, since materials come later.',
      'y la especular, aparte, porque los materiales vienen después.',
    ),
    picture(
      'Third pass: the objects once more, each material over the light of its pixels.',
      'Tercera pasada: los objetos otra vez, cada material sobre la luz de sus píxeles.',
    ),
  ],
  inferred: [
    step(
      'thin-depth',
      ['Depth', 'Profundidad'],
      'Light pre-pass at a lower resolution: move the slider of texels.',
      'Light pre-pass con menos resolución: mueva el control de téxeles.',
    ),
    step(
      'thin-normal',
      ['Normals', 'Normales'],
      'Normals at that resolution; a transparent object takes one texel of four.',
      'Las normales a esa resolución; un objeto transparente ocupa un téxel de cada cuatro.',
    ),
    step(
      'thin-object',
      ['Object numbers', 'Números de objeto'],
      'Which object each texel is of: the filter that scales up mixes no two objects.',
      'De qué objeto es cada téxel: el filtro que amplía no mezcla dos objetos.',
    ),
    step(
      'light-diffuse',
      ['Light', 'Luz'],
      'The L-buffer: a quarter of the pixels to light at a half of the resolution.',
      'El L-buffer: a media resolución, un cuarto de los píxeles que iluminar.',
    ),
    picture(
      'Materials at full resolution, light scaled up by a filter that keeps edges.',
      'Materiales a resolución completa, luz ampliada por un filtro que respeta los bordes.',
    ),
  ],
  'tiled-deferred': [
    albedo,
    normal,
    depth,
    bounds,
    counts(
      'A list for each tile of the lights that reach its depths: counted here.',
      'Para cada celda, la lista de luces que llegan a sus profundidades: aquí, contadas.',
    ),
    picture(
      'One lighting pass: each pixel reads the G-buffer once and walks the list of its tile.',
      'Una pasada de iluminación: cada píxel lee el G-Buffer una vez y recorre la lista de su celda.',
    ),
  ],
  'tiled-forward': [
    counts(
      'A list of lights for each tile, whatever is in it: no depth is known yet.',
      'Una lista de luces por celda, haya lo que haya en ella: aún no se sabe la profundidad.',
    ),
    step(
      'overdraw',
      ['Shadings', 'Sombreados'],
      'Surfaces that something hides later are shaded in vain.',
      'Las superficies que algo tapa después se sombrean en vano.',
    ),
    picture(
      'The objects, each shader walking the list of its tile; transparency and multisampling work as in forward.',
      'Los objetos, cada shader por la lista de su celda; la transparencia y el multisampling funcionan como en forward.',
    ),
  ],
  'forward-plus': [
    depth,
    bounds,
    counts(
      'Lists within the depths of each tile, slice by slice (2.5D): compare tiled forward.',
      'Listas dentro de las profundidades de cada celda, capa a capa (2.5D): compárelo con tiled forward.',
    ),
    picture(
      'The objects by their lists, each pixel shaded once thanks to the depth pass.',
      'Los objetos según sus listas; gracias a la pasada de profundidad cada píxel se sombrea una vez.',
    ),
  ],
  'clustered-deferred': [
    albedo,
    normal,
    step(
      'slices',
      ['Clusters', 'Clusters'],
      'Tiles are cut in depth too, into slices that grow with distance (beyond the thesis).',
      'Las celdas se cortan también en profundidad, en capas que crecen con la distancia (más allá de la tesis).',
    ),
    counts('Lights of the cluster that each pixel is in.', 'Luces del cluster en que está cada píxel.'),
    picture(
      'One pass over the G-buffer by the lists of clusters.',
      'Una pasada sobre el G-Buffer con las listas de los clusters.',
    ),
  ],
  'clustered-forward': [
    counts(
      'Lists by tile and depth, made before anything is drawn: no depth pass is needed.',
      'Listas por celda y profundidad, hechas antes de dibujar: no hace falta pasada de profundidad.',
    ),
    step(
      'overdraw',
      ['Shadings', 'Sombreados'],
      'How often each pixel was shaded.',
      'Cuántas veces se ha sombreado cada píxel.',
    ),
    picture(
      'Opaque and transparent objects by the same lists.',
      'Objetos opacos y transparentes con las mismas listas.',
    ),
  ],
} as const satisfies Record<string, readonly Step[]>;

export type StepTechnique = keyof typeof stepsOf;
